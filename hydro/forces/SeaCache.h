#pragma once
#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "hydro/Conventions.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

class ExcitationTable;

/// Exact wave loads on a ship of one course and speed: per component of the sea the force [N/m,
/// N·m/m] per metre of amplitude, in H.
struct CourseForces {
  double heading = 0.0, speed = 0.0;             ///< ψ̄ [rad], U [m/s]
  std::vector<std::array<CVec6, 2>> components;  ///< [component][WaveLoad]
};

/// Wave loads on one ship's hull, per metre of amplitude, made when first asked for. They belong to
/// frequencies and headings; seas that differ in heights and phases alone share them.
struct SeaCache {
  explicit SeaCache(const SeaState& sea) : waves(sea) {}
  bool isOf(const SeaState& sea) const noexcept;

  static constexpr std::size_t kCoursesKept = 16;
  SeaState waves;
  std::mutex mutex;  // of what follows
  std::shared_ptr<const ExcitationTable> following;
  std::vector<std::shared_ptr<const CourseForces>> exact;  // the last one asked for comes last
};

}  // namespace cutwater
