#include "plugin/ShipSea.h"

#include "plugin/Ship.h"
#include "plugin/ShipPart.h"

CUTWATER_PLUGIN_BEGIN

ShipSea::ShipSea(std::shared_ptr<const SeaTables> tablesOfSea, const ShipSeaOrder& order)
    : tables(std::move(tablesOfSea)), phasors(tables->sea().phasorBlocks()) {
  if (order.free) {
    predicted = std::make_unique<PredictedMotion>(tables, order.parts);
    predicted->renewAll(order.way);
  } else {
    onCourse = tables->exact(order.course.heading, order.course.speed);
    for (const WaveLoad load : {WaveLoad::FroudeKrylov, WaveLoad::Diffraction})
      waves[static_cast<std::size_t>(load)] =
          std::make_unique<WaveForce>(tables, load, order.course);
  }
  if (order.hull) wetted = std::make_unique<WettedHull>(order.hull, tables, order.scaled);
}

ShipSeaOrder Ship::seaOrder() const {
  ShipSeaOrder order;
  order.free = free();
  if (free()) {
    order.way = {course_.heading(), {course_.speed(), course_.leeway()}};
    order.parts = predicted_->parts();
  } else {
    order.course = waves_.front()->course();
  }
  order.hull = pressureHull_;
  order.scaled = nonlinear() && wetted_->scaled();
  return order;
}

// Nothing but pointers changes hands: what was is left in `sea`.
void Ship::enterSea(ShipSea& sea, const SharedWaves& shared) noexcept {
  tables_.swap(sea.tables);
  onCourse_.swap(sea.onCourse);
  phasors_.swap(sea.phasors);
  if (free()) predicted_->enterSea(*sea.predicted, shared);
  for (std::size_t i = 0; !free() && i < waves_.size(); ++i) waves_[i]->enterSea(*sea.waves[i]);
  if (nonlinear()) wetted_->enterSea(*sea.wetted);
}

CUTWATER_PLUGIN_END
