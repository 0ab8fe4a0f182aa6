#include "plugin/WorldHook.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "hydro/Errors.h"

CUTWATER_PLUGIN_BEGIN

namespace {

// The callback is given the world alone, so our state is found by it. Worlds may be stepped on
// several threads while others come and go: readers walk a list that only grows and take no lock.
struct Entry {
  std::atomic<btDynamicsWorld*> world{nullptr};
  std::atomic<WorldHook*> hook{nullptr};
  Entry* next = nullptr;  // never changes once published
};

std::atomic<Entry*> first{nullptr};
std::mutex writing;

Entry* find(const btDynamicsWorld* world) noexcept {
  Entry* entry = first.load(std::memory_order_acquire);
  while (entry != nullptr && entry->world.load(std::memory_order_acquire) != world)
    entry = entry->next;
  return entry;
}

void enter(btDynamicsWorld& world, WorldHook& hook) {
  const std::lock_guard lock(writing);
  if (find(&world) != nullptr) {
    throw HydroError(Fault::BadArgument,
                     "Seaway: this world has a Seaway already; add ships to that");
  }
  Entry* entry = find(nullptr);  // one that is free again
  if (entry == nullptr) {
    // Never freed: a Seaway of static storage may end after anything we could own them by.
    static auto& owned = *new std::vector<std::unique_ptr<Entry>>;
    entry = owned.emplace_back(std::make_unique<Entry>()).get();
    entry->next = first.load(std::memory_order_relaxed);
    first.store(entry, std::memory_order_release);
  }
  entry->hook.store(&hook, std::memory_order_relaxed);
  entry->world.store(&world, std::memory_order_release);
}

void leave(const btDynamicsWorld& world) noexcept {
  const std::lock_guard lock(writing);
  if (Entry* entry = find(&world)) entry->world.store(nullptr, std::memory_order_release);
}

// A protected member of the base is named through a class derived from it; no cast is involved.
struct Slot : btDynamicsWorld {
  static btInternalTickCallback& of(btDynamicsWorld& world) {
    return world.*(&Slot::m_internalPreTickCallback);
  }
};

}  // namespace

WorldHook::WorldHook(btDiscreteDynamicsWorld& world, TickListener& listener)
    : world_(world), listener_(listener) {
  enter(world, *this);
  user_ = Slot::of(world);
  Slot::of(world) = &WorldHook::preTick;
  world.addAction(this);
}

WorldHook::~WorldHook() {
  world_.removeAction(this);
  if (Slot::of(world_) == &WorldHook::preTick) Slot::of(world_) = user_;
  leave(world_);
}

void WorldHook::preTick(btDynamicsWorld* world, btScalar step) {
  const Entry* entry = find(world);
  if (entry == nullptr) return;  // a stranger kept our address after we had left
  WorldHook& self = *entry->hook.load(std::memory_order_relaxed);
  if (self.user_ != nullptr) self.user_(world, step);
  self.listener_.beforeTick(step);
}

void WorldHook::updateAction(btCollisionWorld*, btScalar step) {
  if (Slot::of(world_) != &WorldHook::preTick) {
    user_ = Slot::of(world_);
    Slot::of(world_) = &WorldHook::preTick;
    listener_.slotTaken();
  }
  listener_.afterTick(step);
}

CUTWATER_PLUGIN_END
