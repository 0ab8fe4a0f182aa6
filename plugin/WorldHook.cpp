#include "plugin/WorldHook.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "hydro/Errors.h"

CUTWATER_PLUGIN_BEGIN

namespace {

// A protected member of the base is named through a class derived from it; no cast is involved.
struct Slot : btDiscreteDynamicsWorld {
  static btInternalTickCallback& of(btDynamicsWorld& world) {
    return world.*(&Slot::m_internalPreTickCallback);
  }
  static bool holds(btDiscreteDynamicsWorld& world, btActionInterface* action) {
    const auto& actions = world.*(&Slot::m_actions);
    return actions.findLinearSearch(action) < actions.size();
  }
};

}  // namespace

// The callback is given the world alone, so our state is found by it. Worlds may be stepped on
// several threads while others come and go: readers walk a list that only grows and take no lock.
// An entry without a hook is of a world whose Seaway has ended, perhaps after the world itself.
struct WorldHook::Entry final : btActionInterface {
  std::atomic<btDynamicsWorld*> world{nullptr};
  std::atomic<WorldHook*> hook{nullptr};
  btInternalTickCallback user = nullptr;
  Entry* next = nullptr;  // never changes once published

  static std::atomic<Entry*> first;
  static std::mutex writing;

  static Entry* find(const btDynamicsWorld* world) noexcept {
    Entry* entry = first.load(std::memory_order_acquire);
    while (entry != nullptr && entry->world.load(std::memory_order_acquire) != world)
      entry = entry->next;
    return entry;
  }

  static Entry& make() {
    // Never freed: a Seaway of static storage may end after anything we could own them by.
    static auto& owned = *new std::vector<std::unique_ptr<Entry>>;
    Entry* entry = owned.emplace_back(std::make_unique<Entry>()).get();
    entry->next = first.load(std::memory_order_relaxed);
    first.store(entry, std::memory_order_release);
    return *entry;
  }

  static void preTick(btDynamicsWorld* world, btScalar step) {
    const Entry* entry = find(world);
    if (entry == nullptr) return;  // a stranger kept our address after we had left
    if (entry->user != nullptr) entry->user(world, step);
    if (WorldHook* hook = entry->hook.load(std::memory_order_acquire))
      hook->listener_.beforeTick(step);
  }

  void updateAction(btCollisionWorld*, btScalar step) override {
    WorldHook* ours = hook.load(std::memory_order_acquire);
    if (ours == nullptr) return;
    btInternalTickCallback& slot = Slot::of(ours->world_);
    if (slot != &Entry::preTick) {
      user = slot;
      slot = &Entry::preTick;
      ours->listener_.slotTaken();
    }
    ours->listener_.afterTick(step);
  }

  void debugDraw(btIDebugDraw* drawer) override {
    WorldHook* ours = hook.load(std::memory_order_acquire);
    if (drawer != nullptr && ours != nullptr) ours->listener_.draw(*drawer);
  }
};

std::atomic<WorldHook::Entry*> WorldHook::Entry::first{nullptr};
std::mutex WorldHook::Entry::writing;

// A world that has our action is the one of the entry; otherwise that one is gone, and this is a
// new one at its address.
WorldHook::WorldHook(btDiscreteDynamicsWorld& world, TickListener& listener)
    : world_(world), listener_(listener) {
  const std::lock_guard lock(Entry::writing);
  Entry* entry = Entry::find(&world);
  const bool known = entry != nullptr && Slot::holds(world, entry);
  if (known && entry->hook.load(std::memory_order_relaxed) != nullptr) {
    throw HydroError(Fault::BadArgument,
                     "Seaway: this world has a Seaway already; add ships to that");
  }
  if (entry == nullptr) entry = Entry::find(nullptr);  // one that is free again
  if (entry == nullptr) entry = &Entry::make();
  if (WorldHook* orphan = entry->hook.load(std::memory_order_relaxed)) orphan->entry_ = nullptr;
  btInternalTickCallback& slot = Slot::of(world);
  if (slot != &Entry::preTick) entry->user = slot;
  if (!known) world.addAction(entry);
  slot = &Entry::preTick;
  entry->hook.store(this, std::memory_order_relaxed);
  entry->world.store(&world, std::memory_order_release);
  entry_ = entry;
}

WorldHook::~WorldHook() {
  const std::lock_guard lock(Entry::writing);
  if (entry_ == nullptr) return;  // its world went, and another one stands in its place
  entry_->hook.store(nullptr, std::memory_order_release);
  if (!worldLives_) return;
  world_.removeAction(entry_);
  btInternalTickCallback& slot = Slot::of(world_);
  if (slot == &Entry::preTick) slot = entry_->user;
  entry_->user = nullptr;
  entry_->world.store(nullptr, std::memory_order_release);
}

CUTWATER_PLUGIN_END
