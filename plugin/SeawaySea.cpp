// Seas that change: what is coming, the ticks in which it comes in and the old one goes, and what
// other threads see of it.
#include <algorithm>

#include "hydro/Errors.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/SeaTables.h"
#include "plugin/FloatFleet.h"
#include "plugin/SeaChange.h"
#include "plugin/SeaView.h"
#include "plugin/Seaway.h"
#include "plugin/SettingsCheck.h"

CUTWATER_PLUGIN_BEGIN

void Seaway::setSea(SeaState next, double fadeSeconds) {
  settleSea();
  SeaChange::Order order;
  order.next = std::make_shared<const SeaState>(std::move(next));
  order.both = std::make_shared<const SeaState>(sea_->goingOver(*order.next, time_, fadeSeconds));
  order.seconds = fadeSeconds;
  order.kinds = tables_;
  for (const auto& kind : tables_)
    checkSea(*order.next, kind->hydrodynamics()->ship().gravity, "Seaway::setSea");
  for (const auto& ship : ships_) {
    const auto isIts = [&](const auto& kind) { return kind.get() == &ship->tables(); };
    const auto its = std::find_if(tables_.begin(), tables_.end(), isIts);
    order.kindOf.push_back(static_cast<std::size_t>(its - tables_.begin()));
    order.ships.push_back(ship->seaOrder());
  }
  floats_->checkSea(*order.next);
  if (!change_) change_ = std::make_unique<SeaChange>();
  change_->make(std::move(order));
}

SeaView Seaway::view() const { return SeaView(watch_); }

bool Seaway::seaIsChanging() const noexcept {
  return coming_ != nullptr || (change_ && change_->busy());
}

void Seaway::waitForSea() {
  if (!change_ || !change_->busy()) return;
  change_->wait();
  enterComing();
}

// What is being made is waited for, as who asks for something else did not ask for it.
void Seaway::settleSea() noexcept {
  try {
    waitForSea();
  } catch (...) {
    raise(kSeaNotChanged);
  }
}

// Between two ticks, if it is ready. Throws what was thrown in making it.
void Seaway::enterComing() {
  if (!change_) return;
  std::exception_ptr failed;
  std::unique_ptr<ComingSea> made = change_->take(failed);
  if (failed) std::rethrow_exception(failed);
  if (!made) return;
  made->both->goesOverFrom(time_);
  made->until = time_ + made->seconds;
  const SharedWaves shared{0, sea_->components().size(), 0};
  for (std::size_t i = 0; i < ships_.size(); ++i) ships_[i]->enterSea(made->shipsInBoth[i], shared);
  floats_->enterSea(made->floatsInBoth);
  tables_.swap(made->tablesInBoth);
  setShared(made->both);
  coming_.swap(made);
  if (made) change_->free(std::move(made));
}

void Seaway::enterNext() noexcept {
  const SharedWaves shared = coming_->ofNext();
  for (std::size_t i = 0; i < ships_.size(); ++i)
    ships_[i]->enterSea(coming_->shipsInNext[i], shared);
  floats_->enterSea(coming_->floatsInNext);
  tables_.swap(coming_->tablesInNext);
  setShared(coming_->next);
  change_->free(std::move(coming_));
}

void Seaway::setShared(const std::shared_ptr<const SeaState>& sea) noexcept {
  sea_ = sea;
  seaKey_ = sea->key();
  watch_->set(sea, time_);
}

// A change that is being made holds what goes over now.
void Seaway::followSea() noexcept {
  if (!change_) return;
  try {
    enterComing();
  } catch (...) {
    raise(kSeaNotChanged);
  }
  if (coming_ && time_ >= coming_->until && !change_->busy()) enterNext();
}

CUTWATER_PLUGIN_END
