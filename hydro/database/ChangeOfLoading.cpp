#include "hydro/database/ChangeOfLoading.h"

#include <fmt/format.h>

#include <cmath>

#include "hydro/Errors.h"

namespace cutwater {

namespace {

constexpr double kTolerance = 1e-3;  // of displacement; of G, of length along and of beam across

[[noreturn]] void refuse(Fault fault, const std::string& what) {
  throw HydroError(fault, "withLoading: " + what);
}

void checkMass(const ShipParticulars& ship, double mass) {
  if (!(mass > 0.0) || !std::isfinite(mass)) {
    refuse(Fault::ValueOutOfRange, fmt::format("mass = {} kg, must be > 0", mass));
  }
  const double displaced = ship.density * ship.volume;
  const double miss = std::abs(mass - displaced), before = std::abs(ship.mass - displaced);
  if (miss > kTolerance * displaced && miss > before * (1.0 + 1e-9)) {
    refuse(Fault::ValueOutOfRange,
           fmt::format(
               "mass = {:.9g} kg: the ship displaces {:.9g} kg ({:+.2f} %); another draught is "
               "another wetted surface, solve again with it",
               mass, displaced, 100.0 * (mass / displaced - 1.0)));
  }
}

void checkCentre(const ShipParticulars& ship, const Vec3& cog) {
  if (!cog.allFinite()) refuse(Fault::ValueOutOfRange, "cog is not finite");
  const double length = ship.length();
  for (const int axis : {0, 1}) {
    const double extent = axis == 0 ? length : ship.beam();
    const double miss = std::abs(cog[axis] - ship.centreOfBuoyancy[axis]);
    const double before = std::abs(ship.cog[axis] - ship.centreOfBuoyancy[axis]);
    if (miss > kTolerance * extent && miss > before + 1e-9 * length) {
      refuse(Fault::ValueOutOfRange,
             fmt::format(
                 "cog {} = {:.6g} m: the centre of buoyancy is at {:.6g} m, more than 0.1 % of "
                 "{:.4g} m away; the ship would {}, solve again with that wetted surface",
                 axis == 0 ? "x" : "y", cog[axis], ship.centreOfBuoyancy[axis], extent,
                 axis == 0 ? "trim" : "heel"));
    }
  }
  if (ship.symmetric && std::abs(cog.y() - ship.cog.y()) > 1e-9 * length) {
    refuse(Fault::BadArgument,
           fmt::format("cog y = {} m, was {} m: the database holds half a hull, whose even and odd "
                       "modes are not coupled; solve with symmetric = \"none\"",
                       cog.y(), ship.cog.y()));
  }
}

void checkGyradii(const ShipParticulars& ship, const Vec3& gyradii) {
  for (int i = 0; i < 3; ++i) {
    if (gyradii[i] == ship.gyradii[i] || (gyradii[i] > 0.0 && std::isfinite(gyradii[i]))) continue;
    refuse(Fault::ValueOutOfRange,
           fmt::format("gyradii: {} = {} m, must be > 0", kModeNames[3 + i], gyradii[i]));
  }
}

/// P of a shift d = G′ − G.
Mat6 shiftMatrix(const Vec3& d) {
  Mat6 P = Mat6::Identity();
  P.bottomLeftCorner<3, 3>() << 0.0, d.z(), -d.y(), -d.z(), 0.0, d.x(), d.y(), -d.x(), 0.0;
  return P;
}

/// The part of C from the moments of buoyancy, by V(r_B − r_G) (geometry/Hydrostatics.h).
Mat6 buoyancyStiffness(const ShipParticulars& ship, const Vec3& cog) {
  const Vec3 arm = ship.density * ship.gravity * ship.volume * (ship.centreOfBuoyancy - cog);
  Mat6 c = Mat6::Zero();
  c(Roll, Roll) = c(Pitch, Pitch) = arm.z();
  c(Roll, Yaw) = -arm.x();
  c(Pitch, Yaw) = -arm.y();
  return c;
}

/// Tables: rows by P, crest from over G to over G′.
class Shifted {
 public:
  Shifted(const Mat6& P, const Vec3& d, double gravity) : P_(P), d_(d), gravity_(gravity) {}
  void matrix(Mat6& Z) const { Z = (P_ * Z * P_.transpose()).eval(); }
  void rows(Coefficients::AdjointVectors& b) const { b = (P_.cast<Complex>() * b).eval(); }
  void force(CVec6& F, double heading, double waveOmega) const {
    const double k = waveOmega * waveOmega / gravity_;
    const double along = d_.x() * std::cos(heading) - d_.y() * std::sin(heading);
    F = (std::polar(1.0, k * along) * (P_.cast<Complex>() * F)).eval();
  }

 private:
  Mat6 P_;
  Vec3 d_;
  double gravity_;
};

void shiftTables(const Shifted& shift, Coefficients& c) {
  for (auto* table : {&c.froudeKrylov, &c.diffraction}) {
    for (std::size_t h = 0; h < table->size(); ++h) {
      for (std::size_t i = 0; i < c.omega.size(); ++i)
        shift.force((*table)[h][i], c.headings[h], c.omega[i]);
    }
  }
  DiffractionTable& table = c.diffractionTable;
  const std::size_t headings = table.headings.size(), count = table.waveOmega.size();
  for (std::size_t n = 0; n < table.values.size(); ++n) {
    shift.force(table.values[n], table.headings[n / count % headings], table.waveOmega[n % count]);
  }
}

}  // namespace

Coefficients withLoading(const Coefficients& coefficients, double mass, const Vec3& cog,
                         const Vec3& gyradii) {
  const ShipParticulars& before = coefficients.ship;
  checkMass(before, mass);
  checkCentre(before, cog);
  checkGyradii(before, gyradii);
  Coefficients c = coefficients;
  c.ship.mass = mass;
  c.ship.cog = cog;
  c.ship.gyradii = gyradii;
  c.stability = {};  // was of the loading before
  const Vec3 d = cog - before.cog;
  if (d.isZero(0.0)) return c;
  const Shifted shift(shiftMatrix(d), d, before.gravity);
  c.ship.restoring -= buoyancyStiffness(before, before.cog);
  for (Mat6* m : {&c.ship.restoring, &c.addedMassInfDirect}) shift.matrix(*m);
  c.ship.restoring += buoyancyStiffness(before, cog);
  for (auto* Z : {&c.addedMass, &c.damping, &c.addedMassX, &c.dampingX})
    Z->forEach([&](Mat6& m) { shift.matrix(m); });
  for (auto* vectors : {&c.adjoint, &c.adjointX})
    vectors->forEach([&](Coefficients::AdjointVectors& b) { shift.rows(b); });
  shiftTables(shift, c);
  return c;
}

}  // namespace cutwater
