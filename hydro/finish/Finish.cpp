#include "hydro/finish/Finish.h"

#include <fmt/format.h>

#include <algorithm>

#include "hydro/database/Interpolation.h"
#include "hydro/finish/ConsistentLimit.h"
#include "hydro/finish/GridNeeds.h"
#include "hydro/finish/Mask.h"

namespace cutwater {

namespace {

void symmetrise(Coefficients& c) {
  // Frequencies that the panels do not resolve are wild.
  c.provenance.settings +=
      fmt::format("added_mass_asymmetry_resolved = {:.3g}\ndamping_asymmetry_resolved = {:.3g}\n",
                  asymmetry(c.addedMass, resolvedCount(c)), asymmetry(c.damping, resolvedCount(c)));
  for (auto* matrices : {&c.addedMass, &c.damping}) {
    for (Mat6& m : *matrices) m = (0.5 * (m + m.transpose())).eval();
  }
}

void setUnfinished(Coefficients& c, std::string reason) {
  c.status = CoefficientStatus::Unfinished;
  c.unfinishedBecause = std::move(reason);
}

}  // namespace

Coefficients finish(SolverOutput output) {
  Coefficients c(std::move(output));
  symmetrise(c);
  applyMask(c);
  const GridNeeds grid(c);
  if (c.omega.size() < 2) {
    setUnfinished(c, singleFrequencyReason(grid));
    return c;
  }
  // K, D and ∂A(∞) come from B, ∂A and ∂B alone: the new A(∞) does not change them.
  const RetardationMatrix memory(c, ForwardSpeedForm::Report);
  const ConsistentLimit limit = consistentLimit(c, memory);
  if (limit.trusted && grid.leastCount) {
    continueConsistently(c, memory, limit.addedMassInf);
    c.status = CoefficientStatus::Finished;
    return c;
  }
  const std::vector<std::string> damping = dampingWarnings(c);
  if (damping.empty() && !hinderingResonances(c, memory, limit, grid).empty()) {
    continueConsistently(c, memory, limit.median);
    c.status = CoefficientStatus::Finished;
  } else {
    setUnfinished(c, unfinishedReason(grid, limit, damping));
  }
  return c;
}

double asymmetry(const OverFrequency<Mat6>& matrices, std::size_t count) {
  Mat6 scale = Mat6::Zero(), worst = Mat6::Zero();
  for (std::size_t i = 0; i < std::min(count, matrices.size()); ++i) {
    const Mat6& m = matrices[i];
    const Vec6 size = m.diagonal().cwiseAbs().cwiseSqrt();
    scale = scale.cwiseMax(size * size.transpose());
    worst = worst.cwiseMax((m - m.transpose()).cwiseAbs());
  }
  return (scale.array() > 0.0).select(worst.cwiseQuotient(scale), Mat6::Zero()).maxCoeff();
}

}  // namespace cutwater
