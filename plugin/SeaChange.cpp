#include "plugin/SeaChange.h"

#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr std::size_t kRoomToFree = 8;

}  // namespace

std::shared_ptr<const SeaTables> tablesOf(std::vector<std::shared_ptr<const SeaTables>>& tables,
                                          std::shared_ptr<const Hydrodynamics> kind,
                                          const std::shared_ptr<const SeaState>& sea) {
  for (const auto& known : tables) {
    if (known->hydrodynamics() == kind) return known;
  }
  return tables.emplace_back(std::make_shared<const SeaTables>(std::move(kind), sea));
}

std::unique_ptr<ComingSea> makeComingSea(const SeaChange::Order& order) {
  auto coming = std::make_unique<ComingSea>();
  coming->both = order.both;
  coming->next = order.next;
  coming->seconds = order.seconds;
  coming->floatsInBoth = std::make_unique<FloatSea>(order.both);
  coming->floatsInNext = std::make_unique<FloatSea>(order.next);
  for (const auto& kind : order.kinds) {
    coming->tablesInNext.push_back(
        std::make_shared<const SeaTables>(kind->hydrodynamics(), order.next));
    coming->tablesInBoth.push_back(std::make_shared<const SeaTables>(
        order.both, std::vector{kind, coming->tablesInNext.back()}));
  }
  for (std::size_t i = 0; i < order.ships.size(); ++i) {
    coming->shipsInBoth.emplace_back(coming->tablesInBoth[order.kindOf[i]], order.ships[i]);
    coming->shipsInNext.emplace_back(coming->tablesInNext[order.kindOf[i]], order.ships[i]);
  }
  return coming;
}

SeaChange::SeaChange() {
  toFree_.reserve(kRoomToFree);
  thread_ = std::thread([this] { work(); });
}

SeaChange::~SeaChange() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void SeaChange::make(Order order) {
  {
    const std::lock_guard lock(mutex_);
    order_ = std::move(order);
    state_ = State::Ordered;
  }
  changed_.notify_all();
}

bool SeaChange::busy() const noexcept {
  const std::lock_guard lock(mutex_);
  return state_ != State::Idle;
}

std::unique_ptr<ComingSea> SeaChange::take(std::exception_ptr& failed) noexcept {
  const std::lock_guard lock(mutex_);
  if (state_ != State::Made) return nullptr;
  state_ = State::Idle;
  failed = std::exchange(failed_, nullptr);
  return std::move(made_);
}

void SeaChange::wait() noexcept {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return state_ != State::Ordered; });
}

// Beyond the room there is (nobody changes seas so often) it is freed here.
void SeaChange::free(std::unique_ptr<ComingSea> sea) noexcept {
  {
    const std::lock_guard lock(mutex_);
    if (toFree_.size() < toFree_.capacity()) toFree_.push_back(std::move(sea));
  }
  changed_.notify_all();
}

void SeaChange::work() {
  std::vector<std::unique_ptr<ComingSea>> old;
  old.reserve(kRoomToFree);
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ends_ || state_ == State::Ordered || !toFree_.empty(); });
    old.swap(toFree_);
    if (ends_) return;
    const bool ordered = state_ == State::Ordered;
    Order order;
    if (ordered) order = std::move(order_);
    lock.unlock();
    old.clear();
    std::unique_ptr<ComingSea> made;
    std::exception_ptr failed;
    if (ordered) {
      try {
        made = makeComingSea(order);
      } catch (...) {
        failed = std::current_exception();
      }
    }
    order = {};  // it may be the last to hold tables
    lock.lock();
    if (!ordered) continue;
    made_ = std::move(made);
    failed_ = failed;
    state_ = State::Made;
    changed_.notify_all();
  }
}

CUTWATER_PLUGIN_END
