#include "demos/make_meshes/Boat.h"

#include <algorithm>
#include <cmath>

#include "hydro/geometry/shapes/ShapeGrid.h"
#include "hydro/geometry/shapes/Spacing.h"

namespace cutwater::meshes {
namespace {

// x of the transom, of the waterline's end and of the deck's.
constexpr double kTransom = -6.0, kStem = 5.3, kBow = 6.0;
constexpr double kDraught = 0.88, kTransomDraught = 0.30;
constexpr double kHalfBreadth = 1.62, kDeckHalfBreadth = 1.86;
// u of the broadest section, of where the keel begins to rise aft, and forward.
constexpr double kFullest = 0.40, kRun = 0.60, kForefoot = 0.78;
// Faces of a side.
constexpr int kAlong = 40, kGirth = 12, kUp = 4, kAcross = 4;

enum Colour : std::size_t { Bottom, Topsides, Deck, Board, House, Roof, Glass, Spar, Blade };

/// One transverse section, as the frigate's:
///     below water  y = b (1 − ζⁿ), ζ = −z/d;      above  y = b + (b_d − b)(z/F)^1.4
struct Section {
  double x, b, d, n, deckB, freeboard;
};

double squared(double v) { return v * v; }

/// Freeboard at x.
double sheer(double x) { return 1.05 + 0.75 * squared((x - kTransom) / (kBow - kTransom)); }

Section sectionAt(double u) {
  Section q{};
  q.x = kTransom + (kStem - kTransom) * u;
  const double aft = std::max(0.0, 1 - u / kFullest);
  const double fore = std::max(0.0, (u - kFullest) / (1 - kFullest));
  const double run = std::max(0.0, 1 - u / kRun);
  const double forefoot = std::max(0.0, (u - kForefoot) / (1 - kForefoot));
  q.b = kHalfBreadth * (1 - 0.12 * squared(aft) - squared(fore));
  q.d = kDraught - (kDraught - kTransomDraught) * squared(run);
  q.d *= std::sqrt(1 - squared(forefoot));
  q.n = 1.9 + 0.7 * squared(aft) - 0.6 * squared(fore);
  q.deckB = kDeckHalfBreadth * (1 - 0.10 * squared(aft) - std::pow(fore, 3.2));
  q.freeboard = sheer(q.x + (kBow - kStem) * std::pow(u, 6));
  return q;
}

Vec3 wetPoint(double u, double zeta) {
  const Section q = sectionAt(u);
  return {q.x, q.b * (1 - std::pow(zeta, q.n)), -q.d * zeta};
}

/// Point of the dry side at height fraction t = z/F.
Vec3 dryPoint(double u, double t) {
  const Section q = sectionAt(u);
  const double rake = (kBow - kStem) * std::pow(u, 6);
  return {q.x + rake * t, q.b + (q.deckB - q.b) * std::pow(t, 1.4), t * q.freeboard};
}

/// Both sides, divided into triangles alike.
Surface mirrored(const SurfaceMesh& port, Colour colour) {
  return {bothHalves(triangulated(port)), colour};
}

Part hull() {
  const std::vector<double> u = spacedAtEnds(kAlong, 0.3), girth = uniform(kGirth),
                            up = uniform(kUp), across = uniform(kAcross);
  const auto downwards = [](double v) { return v == 1.0 ? 0.0 : 1 - v; };
  const SurfaceMesh bottom = gridOfCurves(u, girth, wetPoint);
  const SurfaceMesh side =
      gridSurface(u, up, [&](double s, double v) { return dryPoint(s, downwards(v)); });
  const SurfaceMesh deck = gridSurface(u, across, [](double s, double v) -> Vec3 {
    const Vec3 edge = dryPoint(s, 1.0);
    return {edge.x(), v * edge.y(), edge.z()};
  });
  // The transom's rows are the last section's, below water and above it.
  const std::vector<double> rows = arcsAt(girth, [](double v) { return wetPoint(0.0, v); });
  const SurfaceMesh wetTransom = gridSurface(across, rows, [](double v, double zeta) -> Vec3 {
    const Vec3 edge = wetPoint(0.0, zeta);
    return {edge.x(), v * edge.y(), edge.z()};
  });
  const SurfaceMesh dryTransom = gridSurface(up, across, [](double h, double v) -> Vec3 {
    const Vec3 edge = dryPoint(0.0, h);
    return {edge.x(), v * edge.y(), edge.z()};
  });
  return {"hull",
          {mirrored(joined(bottom, wetTransom), Bottom),
           mirrored(joined(side, dryTransom), Topsides), mirrored(deck, Deck)}};
}

/// A board on the transom from t = 0.12 of the freeboard to the deck.
Part transom() {
  constexpr double thickness = 0.03;
  const auto edge = [](double h) { return dryPoint(0.0, 0.12 + 0.88 * h); };
  const std::vector<double> up = uniform(kUp);
  const auto face = [&](double x) {
    return gridSurface(up, {0.0, 1.0}, [&, x](double h, double v) -> Vec3 {
      return {x, v * edge(h).y(), edge(h).z()};
    });
  };
  const double back = kTransom - thickness;
  SurfaceMesh half = joined(face(back), turnedOver(face(kTransom)));
  // Outer edge, top and bottom.
  half = joined(half, gridSurface({back, kTransom}, up, [&](double x, double h) -> Vec3 {
                  return {x, edge(1 - h).y(), edge(1 - h).z()};
                }));
  const auto lid = [&](double h) {
    return gridSurface({back, kTransom}, {0.0, 1.0}, [&, h](double x, double v) -> Vec3 {
      return {x, v * edge(h).y(), edge(h).z()};
    });
  };
  half = joined(half, joined(lid(1.0), turnedOver(lid(0.0))));
  return {"transom", {mirrored(half, Board)}};
}

/// What stands on deck or roof: its port side between two ends, each level with its own x of both
/// ends and half breadths there.
struct Level {
  double z;                  ///< height; of the lowest level on deck: added to the sheer
  double xAft, xFore;        ///< [m]
  double halfAft, halfFore;  ///< [m]
};

struct Block {
  std::vector<Level> levels;  ///< from below
  bool onDeck = true;         ///< the lowest level follows the sheer
  int along = 1;              ///< faces along a side

  Vec3 at(double s, std::size_t i, double y) const {
    const Level& l = levels[i];
    const double x = l.xAft + (l.xFore - l.xAft) * s;
    const double half = l.halfAft + (l.halfFore - l.halfAft) * s;
    return {x, y * half, l.z + (i == 0 && onDeck ? sheer(x) : 0.0)};
  }
  SurfaceMesh level(std::size_t i) const {
    return gridSurface(uniform(along), {0.0, 1.0},
                       [&, i](double s, double v) { return at(s, i, v); });
  }
  /// Port side, front and back between two levels.
  SurfaceMesh walls(std::size_t i) const {
    const auto height = [i](double v) { return v == 0.0 ? i + 1 : i; };
    const SurfaceMesh side = gridSurface(uniform(along), {0.0, 1.0},
                                         [&](double s, double v) { return at(s, height(v), 1.0); });
    const auto end = [&](double s) {
      return gridSurface({0.0, 1.0}, {0.0, 1.0},
                         [&, s](double y, double v) { return at(s, height(v), y); });
    };
    return joined(side, joined(end(0.0), turnedOver(end(1.0))));
  }
};

SurfaceMesh solid(const Block& block) {
  SurfaceMesh mesh = joined(turnedOver(block.level(0)), block.level(block.levels.size() - 1));
  for (std::size_t i = 0; i + 1 < block.levels.size(); ++i) mesh = joined(mesh, block.walls(i));
  return mesh;
}

Part coachroof() {
  const Block block{{{0.0, 1.553, 4.35, 1.278, 0.62}, {1.98, 1.463, 4.15, 1.178, 0.55}}, true, 8};
  return {"coachroof", {mirrored(solid(block), House)}};
}

/// Walls to the sill, a band of windows with posts, the roof.
Part wheelhouse() {
  const Block block{{{0.0, -1.9, 1.55, 1.35, 1.28},
                     {2.05, -1.9, 1.45, 1.25, 1.18},
                     {2.72, -1.85, 1.10, 1.15, 1.08},
                     {2.84, -1.85, 1.05, 1.14, 1.07}},
                    true,
                    8};
  const SurfaceMesh band = block.walls(1);
  SurfaceMesh glass{band.vertices, {}}, posts = glass;
  // The first faces are the side's: every third of them is a post.
  for (std::size_t k = 0; k < band.faces.size(); ++k) {
    const bool side = k < static_cast<std::size_t>(block.along);
    (side && k % 3 == 0 ? posts : glass).faces.push_back(band.faces[k]);
  }
  const SurfaceMesh walls = joined(turnedOver(block.level(0)), joined(block.walls(0), posts));
  return {"wheelhouse",
          {mirrored(walls, House), mirrored(welded(glass, 1e-9), Glass),
           mirrored(joined(block.walls(2), block.level(3)), Roof)}};
}

/// On the wheelhouse's roof, raked aft, with a yard on top.
Part mast() {
  const Block pole{{{2.84, -1.10, -0.98, 0.06, 0.06}, {4.60, -1.50, -1.44, 0.03, 0.03}}, false, 1};
  const Block yard{{{4.60, -1.53, -1.41, 0.55, 0.55}, {4.66, -1.53, -1.41, 0.55, 0.55}}, false, 1};
  return {"mast", {mirrored(joined(solid(pole), solid(yard)), Spar)}};
}

Part rudder() {
  SurfaceMesh blade;
  blade.vertices = {
      {-5.92, 0.0, -0.40}, {-5.50, 0.0, -0.46}, {-5.46, 0.0, -0.85}, {-5.94, 0.0, -0.85}};
  blade.faces = {{{0, 1, 2, 3}}};
  return {"rudder", {{blade, Blade}}};
}

}  // namespace

Model boat() {
  return {{{"antifouling", {0.25, 0.02, 0.02}},
           {"topsides", {0.02, 0.06, 0.18}},
           {"deck", {0.45, 0.32, 0.18}},
           {"transom board", {0.30, 0.12, 0.04}},
           {"house", {0.85, 0.85, 0.80}},
           {"roof", {0.70, 0.70, 0.66}},
           {"glass", {0.03, 0.05, 0.07}},
           {"spar", {0.60, 0.60, 0.62}},
           {"blade", {0.25, 0.02, 0.02}, true}},
          {hull(), transom(), coachroof(), wheelhouse(), mast(), rudder()}};
}

}  // namespace cutwater::meshes
