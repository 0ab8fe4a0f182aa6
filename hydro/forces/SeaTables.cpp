#include "hydro/forces/SeaTables.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "hydro/Errors.h"
#include "hydro/base/ParallelFor.h"
#include "hydro/excitation/ExcitationTable.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/forces/Hydrodynamics.h"
#include "hydro/forces/PressureHull.h"
#include "hydro/forces/SeaCache.h"

namespace cutwater {

namespace {

WavesBeyond wavesBeyond(const SeaState& sea, double lastOmega) {
  WavesBeyond beyond{.lastOmega = lastOmega};
  double all = 0.0, left = 0.0;
  for (const WaveComponent& wave : sea.components()) {
    const double energy = wave.amplitude * wave.amplitude;
    all += energy;
    if (wave.omega <= lastOmega) continue;
    ++beyond.count;
    left += energy;
  }
  beyond.share = left > 0.0 ? left / all : 0.0;
  return beyond;
}

}  // namespace

SeaTables::SeaTables(std::shared_ptr<const Hydrodynamics> hydrodynamics,
                     std::shared_ptr<const SeaState> sea)
    : hydro_(std::move(hydrodynamics)), sea_(std::move(sea)) {
  if (!hydro_ || !sea_) {
    throw HydroError(Fault::BadArgument, "SeaTables: no hydrodynamics or no sea (null pointer)");
  }
  cache_ = hydro_->cacheOf(*sea_);
  beyond_ = wavesBeyond(*sea_, hydro_->excitation().lastOmega());
}

std::string SeaTables::warning() const {
  if (beyond_.count == 0 || sea_->components().size() == 1) return {};
  return fmt::format(
      "omega_max = {:.6g} rad/s of the database: {} of {} waves are beyond it, {:.3g} % of m0; "
      "their linear wave loads are left out (in nonlinear mode their undisturbed pressure still "
      "acts)",
      beyond_.lastOmega, beyond_.count, sea_->components().size(), 100.0 * beyond_.share);
}

SeaTables::SeaTables(std::shared_ptr<const SeaState> sea,
                     std::vector<std::shared_ptr<const SeaTables>> parts)
    : sea_(std::move(sea)), parts_(std::move(parts)) {
  std::size_t components = 0;
  for (const auto& part : parts_) components += part ? part->sea().components().size() : 0;
  if (!sea_ || parts_.empty() || !parts_.front() || components != sea_->components().size())
    throw HydroError(Fault::BadArgument, "SeaTables: the parts are not those of the sea");
  hydro_ = parts_.front()->hydrodynamics();
  beyond_ = wavesBeyond(*sea_, hydro_->excitation().lastOmega());
}

SeaTables::~SeaTables() = default;

std::vector<std::shared_ptr<const ExcitationTable>> SeaTables::following() const {
  std::vector<std::shared_ptr<const ExcitationTable>> tables;
  for (const auto& part : parts_) {
    for (auto& table : part->following()) tables.push_back(std::move(table));
  }
  if (!parts_.empty()) return tables;
  const std::lock_guard lock(cache_->mutex);
  if (!cache_->following) {
    cache_->following =
        std::make_shared<ExcitationTable>(hydro_->excitation(ForwardSpeedForm::Tuck), *sea_);
  }
  return {cache_->following};
}

std::shared_ptr<const PressureHull> SeaTables::pressureHull(std::size_t most) const {
  const std::lock_guard lock(mutex_);
  for (const auto& [count, hull] : hulls_) {
    if (count == most) return hull;
  }
  const Coefficients& c = hydro_->coefficients();
  hulls_.emplace_back(
      most, std::make_shared<const PressureHull>(c.ship, c.addedMass.atInfinity, *sea_, most));
  return hulls_.back().second;
}

namespace {

// Seen from a ship whose course is turned by ψ̄ to port, a wave towards (cos β, −sin β) travels at
// the polar angle −β − ψ̄, hence β + ψ̄ relative to the ship.
CourseForces forcesOn(const Hydrodynamics& hydro, const SeaState& sea, double heading,
                      double speed) {
  CourseForces forces{heading, speed, {}};
  if (sea.components().empty()) return forces;
  const WaveExcitation& excitation = hydro.excitation();
  forces.components.resize(sea.components().size());
  parallelFor(forces.components.size(), 0, [&](std::size_t i) {
    const WaveComponent& wave = sea.components()[i];
    if (forces.components.size() > 1 && wave.omega > excitation.lastOmega()) {
      forces.components[i] = {CVec6::Zero(), CVec6::Zero()};
      return;
    }
    try {
      const auto force = excitation.at(wave.omega, wave.heading + heading, speed);
      forces.components[i] = {force.froudeKrylov, force.diffraction};
    } catch (const HydroError& error) {
      throw HydroError(error.fault(), "wave component " + std::to_string(i) + ": " + error.what());
    }
  });
  return forces;
}

}  // namespace

std::shared_ptr<const CourseForces> SeaTables::exact(double heading, double speed) const {
  if (!parts_.empty()) {
    CourseForces all{heading, speed, {}};
    for (const auto& part : parts_) {
      const auto forces = part->exact(heading, speed);
      all.components.insert(all.components.end(), forces->components.begin(),
                            forces->components.end());
    }
    return std::make_shared<const CourseForces>(std::move(all));
  }
  const std::lock_guard lock(cache_->mutex);
  auto& kept = cache_->exact;
  const auto known = std::find_if(kept.begin(), kept.end(), [&](const auto& forces) {
    return forces->heading == heading && forces->speed == speed;
  });
  if (known != kept.end()) {
    std::rotate(known, known + 1, kept.end());
    return kept.back();
  }
  kept.push_back(std::make_shared<const CourseForces>(forcesOn(*hydro_, *sea_, heading, speed)));
  if (kept.size() > SeaCache::kCoursesKept) kept.erase(kept.begin());
  return kept.back();
}

}  // namespace cutwater
