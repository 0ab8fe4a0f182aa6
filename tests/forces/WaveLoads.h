#pragma once
#include <memory>
#include <vector>

#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/linear/WaveForce.h"

namespace cutwater::test {

/// Both parts of the wave load on a ship, evaluated as a ship does: with the phasors of the tick.
class WaveLoads {
 public:
  WaveLoads(std::shared_ptr<const SeaTables> seaTables, const WaveForce::Course& start)
      : tables(std::move(seaTables)),
        froudeKrylov(tables, WaveLoad::FroudeKrylov, start),
        diffraction(tables, WaveLoad::Diffraction, start),
        phasors_(tables->sea().phasorBlocks()) {}
  /// @param form  of the forward-speed terms; absent: the database's own.
  WaveLoads(Coefficients coefficients, SeaState sea, const WaveForce::Course& start,
            std::optional<ForwardSpeedForm> form = {})
      : WaveLoads(seaTablesOf(std::move(coefficients), std::move(sea), form), start) {}

  static std::shared_ptr<const SeaTables> seaTablesOf(Coefficients coefficients, SeaState sea,
                                                      std::optional<ForwardSpeedForm> form = {}) {
    return std::make_shared<const SeaTables>(
        std::make_shared<const Hydrodynamics>(std::move(coefficients), form),
        std::make_shared<const SeaState>(std::move(sea)));
  }

  /// Froude-Krylov and diffraction together.
  Vec6 evaluate(TickInput now) {
    const SeaState& sea = tables->sea();
    now.sea = &sea;
    now.ramp = sea.ramp(now.time);
    sea.phasors(now.time, now.meanX, now.meanY, phasors_);
    now.phasors = phasors_;
    return froudeKrylov.evaluate(now).load + diffraction.evaluate(now).load;
  }
  /// All amplitudes are renewed for the course of `now`.
  Vec6 evaluateAnew(TickInput now) {
    now.courseBegins = true;
    return evaluate(now);
  }

  std::shared_ptr<const SeaTables> tables;
  WaveForce froudeKrylov, diffraction;

 private:
  std::vector<Phasors4> phasors_;
};

}  // namespace cutwater::test
