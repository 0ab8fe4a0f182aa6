#include "hydro/forces/PressureHull.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/wetted/PressureMesh.h"
#include "hydro/geometry/wetted/SymmetricTriangles.h"
#include "hydro/geometry/wetted/ThinnedHull.h"

namespace cutwater {

namespace {

constexpr double kEdgesOfStrip = 1.5;  // lengths of a strip, in triangles
constexpr double kSameSurface = 1e-9;
constexpr double kSameVertex = 1e-9;  // of the hull's size
constexpr double kWholeBeam = 0.9;    // of the beam at rest, from which on a strip is immersed
constexpr double kGoodError = 1e-3;   // of the waves' pressure
constexpr double kWeightOff = 1e-3;   // of the weight, from which on it is said

// Strips no shorter than the triangles, so that each has some.
std::vector<double> stationsOf(const Bounds& hull, double edge) {
  std::vector<double> stations;
  const double from = hull.low.x(), length = hull.high.x() - from;
  const double strips = std::clamp(std::floor(length / (kEdgesOfStrip * edge)), 1.0,
                                   static_cast<double>(PressureHull::kMostStrips));
  for (double i = 0.0; i <= strips; i += 1.0) stations.push_back(from + length * i / strips);
  return stations;
}

// k with which (kh)²/12 is the error of the sea's pressure, r.m.s.: Σa²k⁴ / Σa², to the fourth
// root. 0 in calm water.
double waveNumberOf(const SeaState& sea) {
  double square = 0.0, all = 0.0;
  for (std::size_t i = 0; i < sea.components().size(); ++i) {
    const double a = sea.components()[i].amplitude, k = sea.waveNumber(i);
    square += a * a * k * k * k * k;
    all += a * a;
  }
  return all > 0.0 ? std::pow(square / all, 0.25) : 0.0;
}

WettedTriangles::State atRest(const WettedTriangles& hull, const Vec3& cog) {
  WettedTriangles::State state(hull);
  for (std::size_t i = 0; i < hull.points().size(); ++i)
    state.depth[i] = -(hull.points().z[i] + cog.z());
  hull.cut(Vec3::UnitZ(), state);
  return state;
}

std::vector<double> armsOf(const std::vector<double>& stations, double from) {
  std::vector<double> arms;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i)
    arms.push_back(0.5 * (stations[i] + stations[i + 1]) - from);
  return arms;
}

SurfaceMesh shared(const SurfaceMesh& hull) {
  return welded(hull, kSameVertex * bounds(hull).diagonal());
}

// A section's added mass goes with the square of its beam.
std::vector<double> weightsOf(const std::vector<double>& beam) {
  std::vector<double> weights;
  for (const double b : beam) weights.push_back(b * b);
  return weights;
}

// Area, volume and first moments of both alike.
bool sameSurface(const SurfaceMesh& a, const SurfaceMesh& b) {
  const auto measures = [](const SurfaceMesh& mesh) {
    double area = 0.0, volume = 0.0;
    Vec3 middle = Vec3::Zero();
    for (const Face& face : mesh.faces) {
      const Vec3 N = vectorArea(mesh, face), at = meanCorner(mesh, face);
      area += N.norm();
      volume += at.dot(N);
      middle += N.norm() * at;
    }
    Eigen::Matrix<double, 5, 1> all;
    all << area, volume / std::sqrt(area), middle / std::sqrt(area);
    return all;
  };
  return (measures(a) - measures(b)).norm() <= kSameSurface * measures(b).norm();
}

// A mesh that is its own mirror image stays so: its port half is refined, and mirrored.
SurfaceMesh refinedAlike(const SurfaceMesh& mesh, double edge, std::size_t most) {
  const SurfaceMesh port = cutBelow(mesh, {-Vec3::UnitY(), 0.0});
  const SurfaceMesh whole = port.faces.empty() ? port : bothHalves(port);
  const bool mirrored =
      !whole.faces.empty() && openEdges(whole).empty() && sameSurface(whole, mesh);
  if (!mirrored) return refined(mesh, edge, most).mesh;
  return bothHalves(refined(port, edge, most / 2).mesh);
}

// Of the triangles that may be wet, r.m.s. over their area; of each the longest edge.
double edgeOf(const SurfaceMesh& mesh) {
  double square = 0.0, all = 0.0;
  for (const Face& face : mesh.faces) {
    const Vec3 &a = mesh.corner(face, 0), &b = mesh.corner(face, 1), &c = mesh.corner(face, 2);
    if (std::min({a.z(), b.z(), c.z()}) > 0.0) continue;
    const double area = 0.5 * (b - a).cross(c - a).norm();
    square +=
        area * std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    all += area;
  }
  return all > 0.0 ? std::sqrt(square / all) : 0.0;
}

}  // namespace

bool hasClosedHull(const ShipParticulars& ship) {
  if (ship.hull.faces.empty()) return false;
  try {
    return WettedTriangles(shared(ship.hull), ship.cog).volume() > 0.0;
  } catch (const HydroError&) {
    return false;
  }
}

struct PressureHull::Made {
  WettedTriangles triangles;
  WettedTriangles::State rest;
  std::vector<double> stations;
  double distance, edge;
};

PressureHull::Made PressureHull::make(const ShipParticulars& ship, const SeaState& sea,
                                      std::size_t most) {
  if (ship.hull.faces.empty())
    throw HydroError(Fault::DatabaseIncomplete,
                     "mode = \"nonlinear\": the database holds no hull, only panels; solve the "
                     "ship from its mesh, or take mode = \"linear\"");
  if (most < kFewestTriangles)
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("hull_triangles = {}: at least {}", most, kFewestTriangles));
  const Bounds size = bounds(ship.hull);
  const double k = waveNumberOf(sea);
  // In waves half of the triangles for the shape, the others to make them short.
  const ThinnedHull thin =
      thinned(symmetricTriangles(shared(ship.hull)), k > 0.0 ? most / 2 : most);
  const double strip = (size.high.x() - size.low.x()) / (kMostStrips * kEdgesOfStrip);
  const double edge = k > 0.0 ? std::min(strip, edgeFor(kGoodError, k)) : strip;
  const SurfaceMesh mesh = refinedAlike(thin.mesh, edge, most);
  const double reached = edgeOf(mesh);
  const std::vector<double> stations = stationsOf(size, reached);
  const WettedTriangles triangles(mesh, ship.cog, stations);
  return {triangles, atRest(triangles, ship.cog), stations, thin.distance, reached};
}

double PressureHull::pressureErrorIn(const SeaState& sea) const noexcept {
  const double k = waveNumberOf(sea);
  return k > 0.0 ? linearPressureError(edge_, k) : 0.0;
}

PressureHull::PressureHull(const ShipParticulars& ship, const Mat6& addedMass, const SeaState& sea,
                           std::size_t most)
    : PressureHull(ship, addedMass, make(ship, sea, most)) {
  pressureError_ = pressureErrorIn(sea);
}

PressureHull::PressureHull(const ShipParticulars& ship, const Mat6& addedMass, Made made)
    : triangles_(std::move(made.triangles)),
      arms_(armsOf(made.stations, ship.cog.x())),
      restBeam_(made.rest.beamArea),
      mass_(addedMass, weightsOf(restBeam_), arms_),
      restDeck_(made.rest.deckArea),
      volume_(made.rest.volume),
      energy_(-ship.density * ship.gravity * volume_ * (made.rest.centre.z() + ship.cog.z())),
      distance_(made.distance),
      edge_(made.edge) {
  const double floats = ship.density * volume_;
  if (std::abs(floats - ship.mass) > kWeightOff * ship.mass)
    warning_ = fmt::format(
        "the hull displaces {:.6g} kg as the ship lies in its file, and the ship weighs {:.6g} kg: "
        "in mode = \"nonlinear\" it will float {} than there",
        floats, ship.mass, floats > ship.mass ? "higher" : "deeper");
}

void PressureHull::shares(const WettedTriangles::State& state,
                          std::span<double> shares) const noexcept {
  for (std::size_t i = 0; i < restBeam_.size(); ++i) {
    const double whole = kWholeBeam * restBeam_[i];
    const double ratio = whole > 0.0 ? state.beamArea[i] / whole : 1.0;
    shares[i] = std::min(1.0, ratio * ratio);
  }
}

}  // namespace cutwater
