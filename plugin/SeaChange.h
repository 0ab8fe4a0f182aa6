#pragma once
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "plugin/FloatFleet.h"
#include "plugin/ShipSea.h"

CUTWATER_PLUGIN_BEGIN

/// A sea that goes over into another, and what the ships need in it and after it.
struct ComingSea {
  std::shared_ptr<const SeaState> both, next;
  double seconds = 0.0;  ///< in which it goes over
  double until = 0.0;    ///< time [s] at which it has
  std::vector<std::shared_ptr<const SeaTables>> tablesInBoth, tablesInNext;  ///< one for each kind
  std::vector<ShipSea> shipsInBoth, shipsInNext;  ///< in the order of the ships
  std::unique_ptr<FloatSea> floatsInBoth, floatsInNext;

  /// Components of the next sea: the last ones of both.
  SharedWaves ofNext() const noexcept {
    const std::size_t count = next->components().size();
    return {both->components().size() - count, count, 0};
  }
};

/// A thread that makes the tables of seas that are to come, and frees those of seas that were, so
/// that no tick has to. One thread at a time may call.
class SeaChange {
 public:
  struct Order {
    std::shared_ptr<const SeaState> both, next;
    double seconds = 0.0;
    std::vector<std::shared_ptr<const SeaTables>> kinds;  ///< in the present sea
    std::vector<std::size_t> kindOf;                      ///< of each ship
    std::vector<ShipSeaOrder> ships;
  };
  SeaChange();
  ~SeaChange();
  SeaChange(const SeaChange&) = delete;
  SeaChange& operator=(const SeaChange&) = delete;

  /// @pre nothing is being made.
  void make(Order order);
  /// Something is being made, or is made and was not taken.
  bool busy() const noexcept;
  /// What was made; null if it is not ready. Does not wait.
  /// @param failed  set to what was thrown instead; nothing is being made any more then.
  std::unique_ptr<ComingSea> take(std::exception_ptr& failed) noexcept;
  void wait() noexcept;  ///< until it is ready
  /// Frees it on our thread. Allocates nothing.
  void free(std::unique_ptr<ComingSea> sea) noexcept;

 private:
  enum class State { Idle, Ordered, Made };
  void work();

  mutable std::mutex mutex_;  // of all that follows but the thread
  std::condition_variable changed_;
  State state_ = State::Idle;
  bool ends_ = false;
  Order order_;
  std::unique_ptr<ComingSea> made_;
  std::exception_ptr failed_;
  std::vector<std::unique_ptr<ComingSea>> toFree_;  // room for some
  std::thread thread_;
};

/// The tables of a kind of ship in a sea, out of those there are, or made now and put to them.
/// @throws HydroError as SeaTables.
std::shared_ptr<const SeaTables> tablesOf(std::vector<std::shared_ptr<const SeaTables>>& tables,
                                          std::shared_ptr<const Hydrodynamics> kind,
                                          const std::shared_ptr<const SeaState>& sea);

/// What of a sea change the ships get, on this thread.
/// @throws HydroError as ShipSea.
std::unique_ptr<ComingSea> makeComingSea(const SeaChange::Order& order);

CUTWATER_PLUGIN_END
