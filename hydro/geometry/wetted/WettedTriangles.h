#pragma once
#include <array>
#include <utility>
#include <vector>

#include "hydro/geometry/SurfaceMesh.h"

namespace cutwater {

/// The wetted part of a closed hull under any surface z = ζ(x, y), and the load of a pressure on
/// it. It knows no waves: it is told how deep each vertex lies, and the pressure there.
///     const WettedTriangles hull(ship.hull, ship.cog);
///     WettedTriangles::State state(hull);                     // of one ship
///     for (…) state.depth[i] = ζ − z, state.pressure[i] = …;  // of hull.points()
///     hull.cut(up, state);                                    // state.load, state.volume, …
///
/// Depth and pressure are linear over each triangle, which is cut where the depth is 0, and
///     F = −∫p n dS,   M = −∫p r × n dS
/// over the wet piece is exact for them. Neighbours share vertices and cuts: in still water the
/// force along the surface and the moment about the vertical vanish to round-off, whatever the
/// triangles, and the vertical force is that of Archimedes. Immutable; any number of ships share
/// it.
/// THEORY.md, chapter 9.
class WettedTriangles {
 public:
  /// @param hull  closed, normals out, vertices shared, in hull axes [m]; quadrilaterals are split.
  /// @param origin  r = 0 in hull axes [m]: G.
  /// @param stations  where strips end, increasing in x: strip i from stations[i] to [i + 1]. A
  ///        triangle belongs to the strip of its middle. Empty: one strip.
  /// @throws HydroError HullNotClosed with the place of an open edge; HullInverted: it encloses no
  ///         volume; MeshEmpty; MeshNotFinite.
  WettedTriangles(const SurfaceMesh& hull, const Vec3& origin,
                  const std::vector<double>& stations = {});

  /// Vertices from the origin, in hull axes [m], and after them repeats of the last up to a
  /// multiple of kLanes.
  struct Points {
    std::vector<double> x, y, z;
    std::size_t size() const noexcept { return x.size(); }
  };
  static constexpr std::size_t kLanes = 16;
  const Points& points() const noexcept { return points_; }
  std::size_t vertices() const noexcept { return vertices_; }
  std::size_t triangles() const noexcept { return triangles_.size(); }
  std::size_t strips() const noexcept { return strips_; }
  double longestEdge() const noexcept { return longestEdge_; }  ///< [m]
  double volume() const noexcept { return volume_; }            ///< of the whole hull [m³]

  /// What one ship knows of its wetted hull. Hull axes, about the origin.
  struct State {
    explicit State(const WettedTriangles& hull);
    // In, of each of points().
    std::vector<double> depth;     ///< ζ − z [m], > 0 under water
    std::vector<double> pressure;  ///< [Pa], where depth > 0
    /// [Pa] in the surface above or below the vertex, where an edge of it is cut; 0 in still water.
    std::vector<double> surfacePressure;
    /// Three quantities f of the water at the vertex, and two in the surface above or below it:
    /// one, g, and the rate at which it rises [m/s]. 0 where nobody asks for `flow` and `edge`.
    std::array<std::vector<double>, 3> carried;
    std::vector<double> onSurface, rise;
    // Out, of press().
    Vec6 load = Vec6::Zero();  ///< [N, N·m]
    Vec3 flow = Vec3::Zero();  ///< ∫f (V·n) dS with the hull's velocity V
    /// ∮g f V_ν dl along the waterline, V_ν its own velocity outwards, as hull and water move.
    Vec3 edge = Vec3::Zero();
    std::vector<double> beamArea;  ///< wetted area that faces down, seen from above [m²], by strip
    double deckArea = 0.0;         ///< wetted area that faces up, seen from above [m²]
    /// Pieces of the waterline [m], in no order. Never more than one a triangle.
    std::vector<std::pair<Vec3, Vec3>> waterline;
    std::size_t wetVertices = 0;
    // Out, of measure().
    double area = 0.0;           ///< wetted [m²]
    double volume = 0.0;         ///< submerged [m³]
    Vec3 centre = Vec3::Zero();  ///< of that volume [m]; 0 where there is none
  };
  /// The load, and what comes with it. Allocates nothing; some microseconds for 2000 triangles.
  /// @param up  the vertical in hull axes, a unit vector.
  /// @param motion  of the hull, V = v + Ω × r: v [m/s], Ω [rad/s] in hull axes.
  void press(const Vec3& up, const Vec6& motion, State& state) const noexcept;
  /// Area, volume and centre.
  void measure(const Vec3& up, State& state) const noexcept;
  /// Both, of a hull that does not move.
  void cut(const Vec3& up, State& state) const noexcept;

  /// A wet triangle, or a triangle of what is wet of one.
  struct WetFace {
    Vec3 middle;  ///< mean of its corners [m]
    Vec3 area;    ///< n S [m²]
  };
  /// All of them, in the order of the triangles. Depths alone are looked at. Allocates nothing if
  /// there is room for two a triangle.
  void wetFaces(const State& state, std::vector<WetFace>& faces) const noexcept;

 private:
  struct Triangle {
    std::array<int, 3> v{};
    int strip = 0;
    Vec3 area = Vec3::Zero();  // vector area n S [m²]
    double size = 0.0;         // S
  };
  struct Corner {
    Vec3 r;
    double depth, pressure;
  };
  /// Where the surface cuts an edge.
  struct Crossing {
    Corner at;
    int wet, dry;  // its ends
    double part;   // of the way from the wet one
  };
  /// What is wet of a triangle that is cut: one corner and both cuts, or two corners (the first at
  /// ab) and both cuts, which are two triangles ab, first, second and ab, second, ac.
  struct Piece {
    Crossing ab, ac;
    std::array<int, 2> wet;  // vertices; the second −1: there is none
    double first, second;    // shares of the whole triangle
  };
  struct Loads;
  struct Measures;
  /// What each vertex has of ∫φ n dS and ∫φ r × n dS, φ its linear shape function.
  struct Weights {
    std::array<std::vector<double>, 3> force, moment;
  };
  void findWeights();
  Vec3 momentWeight(const Triangle& t, int vertex) const noexcept;
  static void sumOverVertices(const Weights& weights, const State& state, const Vec6& motion,
                              double* sums) noexcept;
  Corner corner(const State& state, int vertex) const noexcept;
  static Vec3 carriedAt(const State& state, int vertex) noexcept;
  static Vec3 carriedAt(const State& state, const Crossing& at) noexcept;
  Crossing crossing(const State& state, int wet, int dry) const noexcept;
  Piece pieceOf(const Triangle& triangle, int wet, const State& state) const noexcept;
  void exchange(const Triangle& t, const Piece& piece, State& state, Loads& loads) const noexcept;
  void addEdge(const Vec3& up, const Vec6& motion, const Piece& piece, const Triangle& t,
               State& state) const noexcept;

  Points points_;
  std::vector<Vec3> places_;
  std::vector<Triangle> triangles_;
  Weights weights_;
  std::size_t vertices_ = 0, strips_ = 1;
  double longestEdge_ = 0.0, volume_ = 0.0;
};

}  // namespace cutwater
