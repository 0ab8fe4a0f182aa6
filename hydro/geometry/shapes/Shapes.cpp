#include "hydro/geometry/shapes/Shapes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/geometry/shapes/ShapeGrid.h"
#include "hydro/geometry/shapes/Spacing.h"

namespace cutwater {
namespace {

void requirePositive(const char* function, std::initializer_list<double> lengths) {
  for (double v : lengths)
    if (!(v > 0) || !std::isfinite(v))
      throw HydroError(Fault::ValueOutOfRange, std::string(function) + ": length " +
                                                   std::to_string(v) + " m is not positive");
}

int rowsAbove(double freeboard, double wetGirth, int girth) {
  return std::max(1, static_cast<int>(std::lround(freeboard / wetGirth * girth)));
}

SurfaceMesh boxHalf(const BoxShape& box, int nx, int ny, int nz, double low, double high,
                    bool lid) {
  const double x = 0.5 * box.length, y = 0.5 * box.breadth;
  const auto rectangle = [&](int nu, int nv, const Vec3& o, const Vec3& u, const Vec3& v) {
    return gridSurface(uniform(nu), uniform(nv),
                       [=](double s, double t) -> Vec3 { return o + s * u + t * v; });
  };
  const Vec3 X{2 * x, 0, 0}, Y{0, y, 0}, Z{0, 0, high - low};
  SurfaceMesh half = rectangle(nx, nz, {-x, y, high}, X, -Z);         // side
  half = joined(half, rectangle(nz, ny, {-x, 0, low}, Z, Y));         // stern
  half = joined(half, rectangle(ny, nz, {x, 0, low}, Y, Z));          // bow
  half = joined(half, lid ? rectangle(nx, ny, {-x, 0, high}, X, Y)    // deck
                          : rectangle(nx, ny, {-x, y, low}, X, -Y));  // bottom
  return welded(half, 0.0);
}

}  // namespace

SurfaceMesh wetBox(const BoxShape& box, int nx, int ny, int nz) {
  requirePositive("wetBox", {box.length, box.breadth, box.draft});
  return boxHalf(box, nx, ny, nz, -box.draft, 0.0, false);
}

SurfaceMesh closedBox(const BoxShape& box, int nx, int ny, int nz) {
  requirePositive("closedBox", {box.length, box.breadth, box.draft, box.freeboard});
  const int up = rowsAbove(box.freeboard, box.draft, nz);
  return closedFromHalves(wetBox(box, nx, ny, nz),
                          boxHalf(box, nx, ny, up, 0.0, box.freeboard, true));
}

SurfaceMesh wetHalfEllipsoid(const EllipsoidShape& e, int along, int girth) {
  requirePositive("wetHalfEllipsoid", {e.a, e.b, e.c});
  return gridSurface(uniform(along), uniform(girth), [&](double u, double v) -> Vec3 {
    const double theta = kPi * u, phi = 0.5 * kPi * v;
    return {-e.a * std::cos(theta), e.b * std::sin(theta) * std::cos(phi),
            -e.c * std::sin(theta) * std::sin(phi)};
  });
}

SurfaceMesh closedHalfEllipsoid(const EllipsoidShape& e, double freeboard, int along, int girth) {
  requirePositive("closedHalfEllipsoid", {freeboard});
  const auto deckEdge = [&](double u) -> Vec3 {
    return {-e.a * std::cos(kPi * u), e.b * std::sin(kPi * u), freeboard};
  };
  const int up = rowsAbove(freeboard, 0.8 * (e.b + e.c), girth);
  return closedFromHalves(wetHalfEllipsoid(e, along, girth),
                          wallSided(uniform(along), up, girth, deckEdge));
}

SurfaceMesh wetHemisphere(double radius, int around, int down) {
  requirePositive("wetHemisphere", {radius});
  return gridSurface(uniform(around), uniform(down), [&](double u, double v) -> Vec3 {
    const double phi = kPi * u, theta = 0.5 * kPi * v;
    return radius * Vec3{-std::cos(phi) * std::cos(theta), std::sin(phi) * std::cos(theta),
                         -std::sin(theta)};
  });
}

SurfaceMesh closedSphere(double radius, int around, int down) {
  const SurfaceMesh wet = wetHemisphere(radius, around, down);
  SurfaceMesh dry = turnedOver(wet);
  for (Vec3& p : dry.vertices) p.z() = p.z() == 0.0 ? 0.0 : -p.z();
  return closedFromHalves(wet, dry);
}

WigleyShape wigley(int hull) {
  if (hull < 1 || hull > 4)
    throw HydroError(Fault::BadArgument, "wigley: hull " + std::to_string(hull) + " is not 1 to 4");
  return {3.0, hull % 2 == 1 ? 0.3 : 0.6, 0.1875, hull <= 2 ? 1.0 : 0.0};
}

namespace {

Vec3 wigleyPoint(const WigleyShape& h, double u, double zeta) {
  const double xi = 2 * u - 1, q = 1 - xi * xi, z2 = zeta * zeta;
  const double eta =
      (1 - z2) * q * (1 + 0.2 * xi * xi) + h.alpha * z2 * (1 - std::pow(zeta, 8)) * std::pow(q, 4);
  return {0.5 * h.length * xi, 0.5 * h.breadth * eta, -h.draft * zeta};
}

}  // namespace

SurfaceMesh wetWigley(const WigleyShape& hull, int along, int girth) {
  requirePositive("wetWigley", {hull.length, hull.breadth, hull.draft});
  return gridOfCurves(uniform(along), uniform(girth),
                      [&](double u, double v) { return wigleyPoint(hull, u, v); });
}

SurfaceMesh closedWigley(const WigleyShape& hull, double freeboard, int along, int girth) {
  requirePositive("closedWigley", {freeboard});
  const auto deckEdge = [&](double u) -> Vec3 {
    return wigleyPoint(hull, u, 0.0) + Vec3{0, 0, freeboard};
  };
  const int up = rowsAbove(freeboard, hull.draft, girth);
  return closedFromHalves(wetWigley(hull, along, girth),
                          wallSided(uniform(along), up, girth, deckEdge));
}

}  // namespace cutwater
