#pragma once
#include "plugin/BulletTypes.h"

CUTWATER_PLUGIN_BEGIN

/// Called around each internal tick of a world.
class TickListener {
 public:
  virtual ~TickListener() = default;
  /// In the internal pre-tick, after the user's own callback. @param step h [s].
  virtual void beforeTick(btScalar step) noexcept = 0;
  /// After solve and integration, before the user's internal tick callback.
  virtual void afterTick(btScalar step) noexcept = 0;
  /// Somebody overwrote the pre-tick slot: this tick went without beforeTick(). Already mended.
  virtual void slotTaken() noexcept = 0;
  /// The world draws itself.
  virtual void draw(btIDebugDraw&) noexcept {}
};

/// Our place in a world's tick. Bullet has one pre-tick slot and no getter for it; the callback
/// found there is kept, called first, and put back at the end; worldUserInfo is never touched. The
/// end of the tick is a btActionInterface, of which a world takes any number. One per world (a
/// second one throws HydroError BadArgument).
///
/// What stands in the world's lists is never freed, so that a hook may end after its world. It does
/// not touch a world unless it is told that it still lives.
class WorldHook final {
 public:
  WorldHook(btDiscreteDynamicsWorld& world, TickListener& listener);
  ~WorldHook();
  WorldHook(const WorldHook&) = delete;
  WorldHook& operator=(const WorldHook&) = delete;

  /// Before the end: the world is there, and is to be left as it was found. Otherwise what is left
  /// in it does nothing but call the user's callback.
  void worldLives() noexcept { worldLives_ = true; }

 private:
  struct Entry;  // a world's

  btDiscreteDynamicsWorld& world_;
  TickListener& listener_;
  Entry* entry_ = nullptr;
  bool worldLives_ = false;
};

CUTWATER_PLUGIN_END
