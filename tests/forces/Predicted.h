#pragma once
#include <memory>
#include <vector>

#include "hydro/excitation/ExcitationTable.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/PredictedMotion.h"
#include "tests/forces/FreeBox.h"

namespace cutwater::test {

/// What linear theory predicts of the free box in a sea.
struct Predicted {
  explicit Predicted(SeaState waves, const ActiveParts& parts = {})
      : hydrodynamics(std::make_shared<const Hydrodynamics>(freeBox())),
        tables(std::make_shared<const SeaTables>(
            hydrodynamics, std::make_shared<const SeaState>(std::move(waves)))),
        motion(std::make_shared<PredictedMotion>(tables, parts)),
        phasors(tables->sea().phasorBlocks()) {}
  const SeaState& sea() const { return tables->sea(); }
  void renewAll(const PredictedMotion::Way& way) { motion->renewAll(way); }
  /// Sums at this time and place.
  const PredictedMotion::Sums& sumAt(double time, double x, double y, double ramp = 1.0) {
    sea().phasors(time, x, y, phasors);
    motion->sum(phasors, ramp);
    return motion->now();
  }

  std::shared_ptr<const Hydrodynamics> hydrodynamics;
  std::shared_ptr<const SeaTables> tables;
  std::shared_ptr<PredictedMotion> motion;
  std::vector<Phasors4> phasors;
};

}  // namespace cutwater::test
