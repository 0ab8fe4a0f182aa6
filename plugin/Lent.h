#pragma once
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// Owns an object that stands in a Bullet world, where somebody else may delete it: the loop with
/// which Bullet's own examples clear a world deletes every constraint, body and motion state in
/// it. T has a virtual destructor and Bullet's own operators new and delete.
template <class T>
class Lent {
 public:
  /// Called when somebody else deletes the object, which is still whole. `self` is as given.
  /// Returns whether its memory must stay, as the world may still read it.
  using Deleted = bool (*)(void* self, T& dying);

  explicit Lent(Deleted deleted = nullptr, void* self = nullptr) noexcept
      : deleted_(deleted), self_(self) {}
  ~Lent() { end(); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

  template <class... Args>
  void make(Args&&... args) {
    end();
    void* memory = T::operator new(sizeof(Watched));
    try {
      object_ = ::new (memory) Watched(*this, std::forward<Args>(args)...);
    } catch (...) {
      T::operator delete(memory);
      throw;
    }
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
    keep(std::exchange(object_, nullptr));
  }

 private:
  struct Watched final : T {
    template <class... Args>
    explicit Watched(Lent& lent, Args&&... args) : T(std::forward<Args>(args)...), owner(&lent) {}
    // Takes the place of destructor and free, so that what is asked is asked of a whole object.
    static void operator delete(Watched* self, std::destroying_delete_t) {
      Lent* lent = std::exchange(self->owner, nullptr);
      bool stays = false;
      if (lent != nullptr) {
        lent->object_ = nullptr;
        stays = lent->deleted_ != nullptr && lent->deleted_(lent->self_, *self);
      }
      self->~Watched();
      if (stays) {
        keep(self);
      } else {
        T::operator delete(self);
      }
    }
    Lent* owner;
  };

  // Never freed, and never lost sight of.
  static void keep(void* memory) {
    static std::mutex writing;
    static auto& kept = *new std::vector<void*>;
    const std::lock_guard lock(writing);
    kept.push_back(memory);
  }

  Watched* object_ = nullptr;
  Deleted deleted_;
  void* self_;
};

CUTWATER_PLUGIN_END
