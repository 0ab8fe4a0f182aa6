#include "hydro/excitation/WaveExcitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/Interpolation.h"
#include "hydro/geometry/panels/WetSurface.h"

namespace cutwater {

namespace {

[[noreturn]] void refuse(Fault fault, const std::string& what) {
  throw HydroError(fault, "WaveExcitation: " + what);
}

/// The two columns of a table of headings that stand on either side of β, and the weight of the
/// second. Headings are angles: in any order, modulo 2π.
struct Bracket {
  std::size_t low = 0, high = 0;
  double weight = 0.0;
  double gap = 0.0;       // between them [rad]; one column alone: 2π
  bool mirrored = false;  // of −β instead, modes 2, 4, 6 reversed
};

/// The widest gap to be interpolated over, with what its ends' round-off may add [rad]. A straight
/// line over it is off by 4 % of the force of a wave three ship lengths long, whose phase at the
/// ends of the ship turns by up to ±(π/3)(π/12), and by 30 % of that of a wave one length long.
constexpr double kWidestGap = kPi / 6.0 + 1e-9;

Bracket bracket(const std::vector<double>& headings, double beta) {
  constexpr double kSame = 1e-9, kTurn = 2.0 * kPi;
  Bracket found;
  double below = kTurn, above = kTurn;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const double distance = std::remainder(headings[i] - beta, kTurn);
    const double ahead = distance < -kSame ? distance + kTurn : std::max(distance, 0.0);
    const double behind = distance > kSame ? kTurn - distance : std::max(-distance, 0.0);
    if (behind < below) {
      below = behind;
      found.low = i;
    }
    if (ahead < above) {
      above = ahead;
      found.high = i;
    }
  }
  found.gap = below + above;
  found.weight = found.gap > kSame ? below / found.gap : 0.0;
  return found;
}

/// What a table of one side of a symmetric hull lacks is its mirror image.
Bracket columns(const std::vector<double>& headings, double beta, bool symmetric) {
  const Bracket found = bracket(headings, beta);
  if (found.gap <= kWidestGap) return found;
  Bracket image = bracket(headings, -beta);
  image.mirrored = true;
  if (symmetric && image.gap <= kWidestGap) return image;
  const double gap = symmetric ? std::min(found.gap, image.gap) : found.gap;
  refuse(Fault::ValueOutOfRange,
         fmt::format("heading {:.6g} deg lies in a gap of {:.6g} deg of the database's table, more "
                     "than the 30 deg that may be interpolated over; it has no adjoint vectors",
                     beta * 180.0 / kPi, gap * 180.0 / kPi));
}

/// The row of a speed; the number of rows if there is none.
std::size_t rowOf(const DiffractionTable& table, double speed) {
  const auto row = std::find_if(table.speeds.begin(), table.speeds.end(),
                                [&](double u) { return std::abs(u - speed) <= 1e-9; });
  return static_cast<std::size_t>(row - table.speeds.begin());
}

CVec6 reversedOddModes(const CVec6& force) {
  CVec6 mirrored = force;
  for (const int j : {Sway, Roll, Yaw}) mirrored[j] = -mirrored[j];
  return mirrored;
}

/// Σ over the nodes in ω and the two headings of value(heading, node).
template <class Value>
CVec6 mixed(const Bracket& b, const LocalCubic& cubic, Value value) {
  CVec6 sum = CVec6::Zero();
  for (std::size_t i = 0; i < cubic.count; ++i) {
    const std::size_t node = cubic.first + i;
    sum +=
        cubic.weight[i] * ((1.0 - b.weight) * value(b.low, node) + b.weight * value(b.high, node));
  }
  return b.mirrored ? reversedOddModes(sum) : sum;
}

void checkOmega(const CoefficientTables& c, double omegaI) {
  if (!c.omega.empty() && omegaI > 0.0 && omegaI <= c.omega.back() * (1.0 + 1e-9)) return;
  refuse(Fault::ValueOutOfRange, fmt::format("omega = {} rad/s is outside 0..{} of the database",
                                             omegaI, c.omega.empty() ? 0.0 : c.omega.back()));
}

}  // namespace

WaveExcitation::WaveExcitation(const CoefficientTables& coefficients, ForwardSpeedForm form)
    : coefficients_(coefficients), form_(form) {
  const WetSurface wet = coefficients.wet();
  if (wet.empty()) return;
  panels_ = wet.panels();
  faces_ = wet.faces();
  const ShipParticulars& ship = coefficients.ship;
  lacking_ = LackingRestoring(wet.whole(), {ship.hull, ship.symmetric}, ship.restoring, ship.cog,
                              ship.density, ship.gravity);
}

WaveExcitation::Force WaveExcitation::at(double omegaI, double heading, double speed) const {
  const CoefficientTables& c = coefficients_;
  checkOmega(c, omegaI);
  if (!std::isfinite(speed)) refuse(Fault::ValueOutOfRange, fmt::format("speed = {} m/s", speed));
  const ShipParticulars& ship = c.ship;
  const AiryWave wave{omegaI, heading, ship.gravity};
  Force force;
  if (!c.adjoint.empty() && !panels_.panels.empty()) {
    force.diffraction = fromVectors(wave, speed);
  } else if (speed == 0.0 && rowOf(c.diffractionTable, speed) == c.diffractionTable.speeds.size()) {
    force = fromTables(omegaI, heading);
  } else {
    force.diffraction = fromDiffractionTable(wave, speed);
  }
  if (!panels_.panels.empty() || speed != 0.0) force.froudeKrylov = froudeKrylov(omegaI, heading);
  return force;
}

CVec6 WaveExcitation::froudeKrylov(double omegaI, double heading) const {
  checkOmega(coefficients_, omegaI);
  if (panels_.panels.empty()) return fromTables(omegaI, heading).froudeKrylov;
  const ShipParticulars& ship = coefficients_.ship;
  const AiryWave wave{omegaI, heading, ship.gravity};
  return froudeKrylovForce(faces_, wave, ship.cog, ship.density) + lacking_.force(wave);
}

double WaveExcitation::lastOmega() const noexcept {
  const CoefficientTables& c = coefficients_;
  if (c.omega.empty()) return HUGE_VAL;
  const auto& table = c.diffractionTable.waveOmega;
  const bool ends = c.adjoint.empty() && !table.empty();
  return (1.0 + 1e-9) * (ends ? std::min(table.back(), c.omega.back()) : c.omega.back());
}

CVec6 WaveExcitation::fromVectors(const AiryWave& wave, double speed) const {
  const CoefficientTables& c = coefficients_;
  const Encounter met(wave, speed);
  const IncidentVelocity v = atEncounter(incidentNormalVelocity(panels_, wave, c.ship.cog), met);
  const CVec6 omegaForce = diffractionForce(adjointAt(c, met.frequency()), v);
  CVec6 speedForce = CVec6::Zero();
  if (speed != 0.0 && form_ == ForwardSpeedForm::Tuck) {
    speedForce = tuckSpeedForce(omegaForce);
  } else if (speed != 0.0) {
    if (c.adjointX.empty()) {
      refuse(Fault::DatabaseIncomplete,
             fmt::format("speed = {} m/s, form report: the database holds no adjoint vectors of "
                         "d/dx (form tuck needs none)",
                         speed));
    }
    speedForce = diffractionForce(adjointXAt(c, met.frequency()), v);
  }
  return met.diffractionForce(omegaForce, speedForce);
}

CVec6 WaveExcitation::fromDiffractionTable(const AiryWave& wave, double speed) const {
  const DiffractionTable& table = coefficients_.diffractionTable;
  if (table.empty()) {
    refuse(Fault::DatabaseIncomplete,
           fmt::format("speed = {} m/s: the database has neither adjoint vectors nor a table of "
                       "diffraction forces at speed",
                       speed));
  }
  const std::size_t row = rowOf(table, speed);
  if (row == table.speeds.size()) {
    refuse(Fault::ValueOutOfRange,
           fmt::format("speed = {} m/s: the database, which has no adjoint vectors, was solved for "
                       "{} m/s",
                       speed, fmt::join(table.speeds, ", ")));
  }
  if (speed != 0.0 && form_ != coefficients_.forwardSpeed) {
    refuse(Fault::BadArgument, "the database's table of diffraction forces has the other form");
  }
  const auto& nodes = table.waveOmega;
  if (wave.omega > nodes.back() * (1.0 + 1e-9)) {
    refuse(Fault::ValueOutOfRange,
           fmt::format("omega = {} rad/s: the database's table of diffraction forces ends at {}",
                       wave.omega, nodes.back()));
  }
  return mixed(columns(table.headings, wave.heading, coefficients_.ship.symmetric),
               localCubic(nodes, std::clamp(wave.omega, nodes.front(), nodes.back())),
               [&](std::size_t h, std::size_t i) -> const CVec6& { return table.at(row, h, i); });
}

WaveExcitation::Force WaveExcitation::fromTables(double omegaI, double heading) const {
  const CoefficientTables& c = coefficients_;
  if (c.headings.empty() || c.froudeKrylov.empty()) {
    refuse(Fault::DatabaseIncomplete, "the database has no wave excitation");
  }
  const Bracket b = columns(c.headings, heading, c.ship.symmetric);
  const LocalCubic cubic = localCubic(c.omega, std::clamp(omegaI, c.omega.front(), c.omega.back()));
  const auto from = [&](const std::vector<std::vector<CVec6>>& table) {
    return mixed(b, cubic,
                 [&](std::size_t h, std::size_t i) -> const CVec6& { return table[h][i]; });
  };
  return {from(c.froudeKrylov), from(c.diffraction)};
}

}  // namespace cutwater
