#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// Owns an object that stands in a Bullet world, where somebody else may delete it: the loop with
/// which Bullet's own examples clear a world deletes every constraint, body and motion state in
/// it. T has a virtual destructor.
template <class T>
class Lent {
 public:
  /// @param deleted  called in the object's destructor when somebody else deletes it; `self` is
  ///                 given back to it. The object is whole but for what T's descendants add.
  explicit Lent(void (*deleted)(void* self) = nullptr, void* self = nullptr) noexcept
      : deleted_(deleted), self_(self) {}
  ~Lent() { end(); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

  template <class... Args>
  void make(Args&&... args) {
    end();
    object_ = new Watched(*this, std::forward<Args>(args)...);
  }
  T* get() const noexcept { return object_; }
  T* operator->() const noexcept { return object_; }
  T& operator*() const noexcept { return *object_; }
  explicit operator bool() const noexcept { return object_ != nullptr; }

  void end() noexcept {
    if (object_ == nullptr) return;
    object_->owner = nullptr;
    delete std::exchange(object_, nullptr);
  }
  /// Gives the object up without ending it: a world that may still live may still read it.
  void abandon() {
    if (object_ == nullptr) return;
    object_->owner = nullptr;
    // Never freed, and never lost sight of.
    static auto& kept = *new std::vector<T*>;
    kept.push_back(std::exchange(object_, nullptr));
  }

 private:
  struct Watched final : T {
    template <class... Args>
    explicit Watched(Lent& lent, Args&&... args) : T(std::forward<Args>(args)...), owner(&lent) {}
    ~Watched() override {
      if (owner == nullptr) return;
      owner->object_ = nullptr;
      if (owner->deleted_ != nullptr) owner->deleted_(owner->self_);
    }
    Lent* owner;
  };

  Watched* object_ = nullptr;
  void (*deleted_)(void*);
  void* self_;
};

CUTWATER_PLUGIN_END
