#include <fmt/format.h>

#include <cmath>

#include "demos/report_figures/Report.h"
#include "hydro/memory/RetardationMatrix.h"

namespace cutwater::report {

namespace {

constexpr double kLast = 20.0, kStep = 0.05;  // [s]

/// Δ r_jj² g/L, r = 1 m for translations: what the report divides K_jj by.
double kernelUnit(const ShipParticulars& ship, int mode) {
  return dampingUnit(ship, mode) * std::sqrt(ship.gravity / kLength);
}

}  // namespace

void writeFigures25To30(const Job& job, const Sweeps& medium) {
  if (medium.ours.status == CoefficientStatus::Unfinished) return;  // every 7th frequency, say
  const RetardationMatrix memory(medium.ours, ForwardSpeedForm::Report);
  for (int mode = Surge; mode <= Yaw; ++mode) {
    const double unit = kernelUnit(job.medium().ship, mode);
    command::Csv csv(fmt::format("tau,K{0}{0},UKU{0}{0},U2KUU{0}{0}", mode + 1));
    for (int i = 0; i <= std::lround(kLast / kStep); ++i) {
      const SpeedKernels K = memory.kernels(i * kStep);
      csv.row({i * kStep, K.atRest(mode, mode) / unit, kSpeed * K.linear(mode, mode) / unit,
               kSpeed * kSpeed * K.squared(mode, mode) / unit});
    }
    csv.write(job.file(fmt::format("figure{}.csv", 25 + mode)));
  }
}

}  // namespace cutwater::report
