#include "hydro/finish/Mask.h"

#include <fmt/format.h>

#include <algorithm>

#include "hydro/Errors.h"
#include "hydro/database/Interpolation.h"
#include "hydro/database/IrregularFrequencies.h"
#include "hydro/geometry/panels/WetSurface.h"
#include "hydro/incident/IncidentWaveForce.h"

namespace cutwater {

namespace {

/// The coefficients of the frequencies that are kept.
Coefficients regularPart(const Coefficients& c, const std::vector<bool>& kept) {
  Coefficients good = c;
  good.resolvedOmega = 0.0;  // nothing here is to be cut off
  const auto keep = [&](auto& list) {
    if (list.empty()) return;
    std::size_t to = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i]) list[to++] = list[i];
    }
    list.resize(to);
  };
  keep(good.omega);
  for (auto* list : {&good.addedMass, &good.damping, &good.addedMassX, &good.dampingX})
    keep(list->values);
  for (auto* list : {&good.adjoint, &good.adjointX}) keep(list->values);
  for (auto& heading : good.diffraction) keep(heading);
  return good;
}

CVec6 interpolated(const std::vector<double>& omega, const std::vector<CVec6>& force, double at) {
  const LocalCubic local = localCubic(omega, std::clamp(at, omega.front(), omega.back()));
  CVec6 sum = CVec6::Zero();
  for (std::size_t n = 0; n < local.count; ++n) sum += local.weight[n] * force[local.first + n];
  return sum;
}

void fillRadiation(Coefficients& c, const Coefficients& good, std::size_t i) {
  const double omega = c.omega[i];
  c.addedMass[i] = addedMassAt(good, omega);
  c.damping[i] = dampingAt(good, omega);
  if (!c.addedMassX.empty()) c.addedMassX[i] = addedMassXAt(good, omega);
  if (!c.dampingX.empty()) c.dampingX[i] = dampingXAt(good, omega);
  const double last = good.omega.back();
  const auto held = [&](const Coefficients::AdjointVectors& inf) {
    return inf.cols() > 0 ? omega : std::min(omega, last);
  };
  if (!c.adjoint.empty()) c.adjoint[i] = adjointAt(good, held(c.adjoint.atInfinity));
  if (!c.adjointX.empty()) c.adjointX[i] = adjointXAt(good, held(c.adjointX.atInfinity));
}

void fillDiffraction(Coefficients& c, const Coefficients& good, std::size_t i,
                     const PanelMesh& panels) {
  const double omega = c.omega[i];
  for (std::size_t h = 0; h < c.diffraction.size(); ++h) {
    const AiryWave wave{omega, c.headings[h], c.ship.gravity};
    c.diffraction[h][i] =
        panels.panels.empty()
            ? interpolated(good.omega, good.diffraction[h], omega)
            : CVec6(omega * diffractionForce(c.adjoint[i], panels, wave, c.ship.cog));
  }
}

}  // namespace

void applyMask(Coefficients& c) {
  c.masked = irregularFrequencies(c);
  const std::size_t resolved = resolvedCount(c);
  std::vector<bool> kept(c.omega.size(), false);
  for (std::size_t i = 0; i < resolved; ++i) kept[i] = c.masked.empty() || c.masked[i] == 0;
  const auto left = std::count(kept.begin(), kept.end(), true);
  if (left == static_cast<std::ptrdiff_t>(kept.size())) return;
  if (left < 2) {
    throw HydroError(Fault::DatabaseIncomplete,
                     fmt::format("finish: the condition limits leave {} of {} frequencies, at "
                                 "least 2 are needed",
                                 left, c.omega.size()));
  }
  const Coefficients good = regularPart(c, kept);
  PanelMesh panels;
  if (!c.adjoint.empty() && !c.wet().empty()) panels = c.wet().panels();
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    if (kept[i]) continue;
    fillRadiation(c, good, i);
    fillDiffraction(c, good, i, panels);
  }
}

}  // namespace cutwater
