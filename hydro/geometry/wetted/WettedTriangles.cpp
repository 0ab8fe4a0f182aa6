#include "hydro/geometry/wetted/WettedTriangles.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/geometry/PlaceText.h"

namespace cutwater {

namespace {

void requireClosed(const SurfaceMesh& hull) {
  if (hull.faces.empty()) throw HydroError(Fault::MeshEmpty, "wetted hull: it has no faces");
  for (const Vec3& p : hull.vertices) {
    if (!p.allFinite())
      throw HydroError(Fault::MeshNotFinite, "wetted hull: a vertex is not finite");
  }
  const std::vector<OpenEdge> open = openEdges(hull);
  if (open.empty()) return;
  const Vec3& at = hull.vertices[static_cast<std::size_t>(open.front().from)];
  throw HydroError(Fault::HullNotClosed, "wetted hull: it is not closed; " +
                                             std::to_string(open.size()) + " open edges, one at " +
                                             placeText(at) + "; give it a deck");
}

std::size_t stripOf(double x, const std::vector<double>& stations) {
  if (stations.size() < 2) return 0;
  const auto above = std::upper_bound(stations.begin() + 1, stations.end() - 1, x);
  return static_cast<std::size_t>(above - stations.begin()) - 1;
}

}  // namespace

// Over a triangle of vector area N and corners r_i, with P = Σp_i, D = Σd_i:
//   ∫p dS = S P/3,   ∫p r dS = S (P Σr + Σ p_i r_i)/12,   ∫d² dS = S (D² + Σd_i²)/12
// With e the vertical, V = −∫d e·n dS, as the divergence of d e is −1 and d is 0 in the surface;
// likewise ∫r dV = −∫(r d + ½d² e) e·n dS.
// With q_i = V_i·N and f linear, ∫f (V·n) dS = (Σq Σf + Σ q_i f_i)/12.
template <bool moving>
struct WettedTriangles::Sums {
  Vec3 up;
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero(), flow = Vec3::Zero();
  Vec3 edge = Vec3::Zero(), edgeMoment = Vec3::Zero();
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), first = Vec3::Zero();
  double area = 0.0, volume = 0.0, second = 0.0;

  void add(const Corner& a, const Corner& b, const Corner& c, const Vec3& N, double down) noexcept {
    const Vec3 r = a.r + b.r + c.r;
    const double P = a.pressure + b.pressure + c.pressure;
    const double D = a.depth + b.depth + c.depth;
    force -= (P / 3.0) * N;
    moment -=
        ((1.0 / 12.0) * (P * r + a.pressure * a.r + b.pressure * b.r + c.pressure * c.r)).cross(N);
    volume += down * D / 3.0;
    const double share = down / 12.0;
    first += share * (D * r + a.depth * a.r + b.depth * b.r + c.depth * c.r);
    second += share * (D * D + a.depth * a.depth + b.depth * b.depth + c.depth * c.depth);
    if constexpr (moving) addFlow(a, b, c, N);
  }
  // ν dl is the piece turned by a quarter about the vertical, away from the hull.
  void addEdge(const Corner& a, const Corner& b, const Vec3& N) noexcept {
    Vec3 out = (b.r - a.r).cross(up);
    if (out.dot(N) < 0.0) out = -out;
    const double g = 0.5 * (a.onSurface + b.onSurface);
    const double turn = (b.onSurface - a.onSurface) / 12.0;
    edge += g * out;
    edgeMoment += (0.5 * g * (a.r + b.r) + turn * (b.r - a.r)).cross(out);
  }
  // (Ω × r)·N = r·(N × Ω)
  void addFlow(const Corner& a, const Corner& b, const Corner& c, const Vec3& N) noexcept {
    const double through = velocity.dot(N);
    const Vec3 turning = N.cross(spin);
    const double qa = through + turning.dot(a.r), qb = through + turning.dot(b.r),
                 qc = through + turning.dot(c.r);
    flow += (1.0 / 12.0) * ((qa + qb + qc) * (a.carried + b.carried + c.carried) + qa * a.carried +
                            qb * b.carried + qc * c.carried);
  }
};

WettedTriangles::State::State(const WettedTriangles& hull)
    : depth(hull.points().size(), 0.0),
      pressure(hull.points().size(), 0.0),
      surfacePressure(hull.points().size(), 0.0),
      carried(hull.points().size(), Vec3::Zero()),
      onSurface(hull.points().size(), 0.0),
      beamArea(hull.strips(), 0.0) {
  waterline.reserve(hull.triangles());
}

WettedTriangles::WettedTriangles(const SurfaceMesh& hull, const Vec3& origin,
                                 const std::vector<double>& stations)
    : vertices_(hull.vertices.size()), strips_(std::max<std::size_t>(stations.size(), 2) - 1) {
  requireClosed(hull);
  const SurfaceMesh mesh = triangulated(hull);
  places_.reserve(vertices_);
  for (const Vec3& p : mesh.vertices) places_.emplace_back(p - origin);
  for (const Face& face : mesh.faces) {
    const Vec3 &a = mesh.corner(face, 0), &b = mesh.corner(face, 1), &c = mesh.corner(face, 2);
    const Vec3 area = vectorArea(mesh, face);
    const Vec3 middle = (a + b + c) / 3.0;
    triangles_.push_back({{face[0], face[1], face[2]},
                          static_cast<int>(stripOf(middle.x(), stations)),
                          area,
                          area.norm()});
    longestEdge_ = std::max({longestEdge_, (b - a).norm(), (c - b).norm(), (a - c).norm()});
    volume_ += (middle - origin).dot(area) / 3.0;
  }
  if (!(volume_ > 0.0))
    throw HydroError(Fault::HullInverted, "wetted hull: it encloses " + std::to_string(volume_) +
                                              " m³; its faces must look outwards");
  const std::size_t padded = (vertices_ + kLanes - 1) / kLanes * kLanes;
  for (std::size_t i = 0; i < padded; ++i) {
    const Vec3& p = places_[std::min(i, vertices_ - 1)];
    points_.x.push_back(p.x());
    points_.y.push_back(p.y());
    points_.z.push_back(p.z());
  }
}

template <bool moving>
WettedTriangles::Corner WettedTriangles::corner(const State& state, int vertex) const noexcept {
  const auto i = static_cast<std::size_t>(vertex);
  if constexpr (!moving) return {places_[i], state.depth[i], state.pressure[i], {}, 0.0};
  return {places_[i], state.depth[i], state.pressure[i], state.carried[i], 0.0};
}

// Where the surface cuts an edge, always found from its wet end: both triangles of the edge have
// the same bits.
template <bool moving>
WettedTriangles::Corner WettedTriangles::crossing(const State& state, int wet,
                                                  int dry) const noexcept {
  const auto i = static_cast<std::size_t>(wet), j = static_cast<std::size_t>(dry);
  const double t = state.depth[i] / (state.depth[i] - state.depth[j]);
  const double pressure =
      state.surfacePressure[i] + t * (state.surfacePressure[j] - state.surfacePressure[i]);
  const Vec3 at = places_[i] + t * (places_[j] - places_[i]);
  if constexpr (!moving) return {at, 0.0, pressure, {}, 0.0};
  return {at, 0.0, pressure, state.carried[i] + t * (state.carried[j] - state.carried[i]),
          state.onSurface[i] + t * (state.onSurface[j] - state.onSurface[i])};
}

// Corner a is the one that is alone on its side; of the triangle's area its piece has the share
// (ab/AB)(ac/AC).
template <bool moving>
void WettedTriangles::cutOne(const Triangle& triangle, int wet, State& state,
                             Sums<moving>& sums) const noexcept {
  const auto isWet = [&](std::size_t k) {
    return state.depth[static_cast<std::size_t>(triangle.v[k])] > 0.0;
  };
  const bool aloneIsWet = wet == 1;
  std::size_t alone = 0;
  while (alone < 2 && isWet(alone) != aloneIsWet) ++alone;
  const int a = triangle.v[alone], b = triangle.v[(alone + 1) % 3], c = triangle.v[(alone + 2) % 3];
  const auto part = [&](int from, int to) {
    const double d = state.depth[static_cast<std::size_t>(from)];
    return d / (d - state.depth[static_cast<std::size_t>(to)]);
  };
  const double toB = part(a, b), toC = part(a, c);
  const Corner ab = aloneIsWet ? crossing<moving>(state, a, b) : crossing<moving>(state, b, a);
  const Corner ac = aloneIsWet ? crossing<moving>(state, a, c) : crossing<moving>(state, c, a);
  const double down = -triangle.area.dot(sums.up);
  const double share = aloneIsWet ? toB * toC : 1.0 - toB * toC;
  if (aloneIsWet) {
    sums.add(corner<moving>(state, a), ab, ac, share * triangle.area, share * down);
  } else {
    const Corner atB = corner<moving>(state, b), atC = corner<moving>(state, c);
    const double first = 1.0 - toB, second = toB * (1.0 - toC);
    sums.add(ab, atB, atC, first * triangle.area, first * down);
    sums.add(ab, atC, ac, second * triangle.area, second * down);
  }
  sums.area += share * triangle.size;
  state.beamArea[static_cast<std::size_t>(triangle.strip)] += std::max(0.0, share * down);
  state.waterline.emplace_back(ab.r, ac.r);
  if constexpr (moving) sums.addEdge(ab, ac, triangle.area);
}

template <bool moving>
void WettedTriangles::cutAll(const Vec3& up, const Vec6& motion, State& state) const noexcept {
  Sums<moving> sums{up, motion.head<3>(), motion.tail<3>()};
  std::fill(state.beamArea.begin(), state.beamArea.end(), 0.0);
  state.waterline.clear();
  const double* depth = state.depth.data();
  for (const Triangle& t : triangles_) {
    const int wet = (depth[t.v[0]] > 0.0) + (depth[t.v[1]] > 0.0) + (depth[t.v[2]] > 0.0);
    if (wet == 0) continue;
    if (wet < 3) {
      cutOne(t, wet, state, sums);
      continue;
    }
    const double down = -t.area.dot(up);
    sums.add(corner<moving>(state, t.v[0]), corner<moving>(state, t.v[1]),
             corner<moving>(state, t.v[2]), t.area, down);
    sums.area += t.size;
    state.beamArea[static_cast<std::size_t>(t.strip)] += std::max(0.0, down);
  }
  state.load << sums.force, sums.moment;
  state.flow = sums.flow;
  state.edge << sums.edge, sums.edgeMoment;
  state.area = sums.area;
  state.volume = sums.volume;
  state.centre =
      sums.volume > 0.0 ? Vec3((sums.first + 0.5 * sums.second * up) / sums.volume) : Vec3::Zero();
}

void WettedTriangles::cut(const Vec3& up, State& state) const noexcept {
  cutAll<false>(up, Vec6::Zero(), state);
}

void WettedTriangles::cut(const Vec3& up, const Vec6& motion, State& state) const noexcept {
  cutAll<true>(up, motion, state);
}

}  // namespace cutwater
