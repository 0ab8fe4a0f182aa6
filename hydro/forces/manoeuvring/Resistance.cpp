#include "hydro/forces/manoeuvring/Resistance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater {

namespace {

constexpr int kPieces = 40;  // of the length, two points each: exact for T(x) of third degree
const std::array<double, 2> kGauss{0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};

/// Depth of the lowest point where an edge crosses the station x; 0 if none does.
double depthAt(const SurfaceMesh& wet, double x) {
  double lowest = 0.0;
  for (const Face& face : wet.faces) {
    for (int i = 0; i < face.size(); ++i) {
      const Vec3 &a = wet.corner(face, i), &b = wet.corner(face, (i + 1) % face.size());
      if ((a.x() <= x) == (b.x() <= x)) continue;
      lowest = std::min(lowest, a.z() + (b.z() - a.z()) * (x - a.x()) / (b.x() - a.x()));
    }
  }
  return -lowest;
}

double wettedAreaOf(const ShipParticulars& ship) {
  if (!ship.wetSurface.faces.empty())
    return (ship.symmetric ? 2.0 : 1.0) * surfaceArea(ship.wetSurface);
  const double length = ship.length(), beam = ship.beam();
  return length * beam + 2.0 * (length + beam) * ship.draught();
}

}  // namespace

Resistance::Resistance(const ShipParticulars& ship)
    : halfDensity_(0.5 * ship.density),
      crossFlow_(ship.drag.crossFlow),
      form_(1.0 + ship.drag.formFactor),
      length_(ship.length()),
      mass_(ship.mass),
      inertia_(ship.massMatrix().diagonal().tail<3>()) {
  const double piece = length_ / kPieces, stern = ship.sternX();
  for (int i = 0; i < kPieces; ++i) {
    for (const double at : kGauss) {
      const double x = stern + (i + at) * piece;
      const double depth =
          ship.wetSurface.faces.empty() ? ship.draught() : depthAt(ship.wetSurface, x);
      strips_.push_back({x - ship.cog.x(), 0.5 * piece * depth});
      lateralArea_ += strips_.back().area;
    }
  }
  wettedArea_ = wettedAreaOf(ship);
}

double Resistance::friction(double reynolds) noexcept {
  const double magnitude = std::log10(std::max(reynolds, kLowestReynolds)) - 2.0;
  return 0.075 / (magnitude * magnitude);
}

double Resistance::alongHull(double speed) const noexcept {
  const double reynolds = std::abs(speed) * length_ / kViscosity;
  return -halfDensity_ * wettedArea_ * form_ * friction(reynolds) * speed * std::abs(speed);
}

// ½ρ C_D A w|w| on a hull whose deck A is under water, held to what stops it in a tick.
double Resistance::sinking(const TickInput& now) const noexcept {
  const double w = now.etaDotNow[Heave];
  const double drag = halfDensity_ * crossFlow_ * now.deckUnderWater * w * std::abs(w);
  const double most = mass_ * std::abs(w) / now.step;
  return std::clamp(drag, -most, most);
}

// With c = ½ρ C_D ∫T|v + xr| dx and d likewise with x², Y and N are −C(v, r) with a matrix C ≥ 0 of
// diagonal c, d. A tick h takes off h M⁻¹C of the velocity, whose largest eigenvalue is at most
// h(c/m + d/I): held to 1, no motion turns round. 1/I is what a moment about the vertical turns: of
// a ship on its side or on end, far outside the theory, that is its roll.
Wrench Resistance::evaluate(const TickInput& now) noexcept {
  double side = 0.0, turn = 0.0, sideRate = 0.0, turnRate = 0.0;
  for (const Strip& strip : strips_) {
    const double v = now.leeway + strip.x * now.turnRate, rate = strip.area * std::abs(v);
    side += rate * v;
    turn += rate * v * strip.x;
    sideRate += rate;
    turnRate += rate * strip.x * strip.x;
  }
  const double drag = halfDensity_ * crossFlow_;
  const Vec3 axis = now.attitude.transpose() * now.ownAxes.col(2) / now.ownAxes(2, 2);
  const double turns = axis.cwiseAbs2().cwiseQuotient(inertia_).sum();
  const double stops = now.step * drag * (sideRate / mass_ + turnRate * turns);
  const double across = drag / std::max(1.0, stops);
  const double most = mass_ * std::abs(now.speed) / now.step;
  Vec6 force = Vec6::Zero();
  force[Surge] = std::clamp(alongHull(now.speed), -most, most);
  force[Sway] = -across * side;
  force[Yaw] = -across * turn;
  force *= now.immersion;
  force[Heave] = -sinking(now);
  return {force};
}

}  // namespace cutwater
