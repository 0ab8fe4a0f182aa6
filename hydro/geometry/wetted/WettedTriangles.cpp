#include "hydro/geometry/wetted/WettedTriangles.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"
#include "hydro/base/SimdMath.h"
#include "hydro/geometry/PlaceText.h"

namespace cutwater {

namespace {

constexpr double kFlattest = 0.1;  // level part of a normal, below which it is taken as that

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

// Over a triangle of vector area N and corners r_i, with P = Σp_i:
//   ∫p dS = S P/3,   ∫p r dS = S (P Σr + Σ p_i r_i)/12
// and with q_i = V_i·N and f linear, ∫f (V·n) dS = (Σq Σf + Σ q_i f_i)/12.
struct WettedTriangles::Loads {
  Vec3 velocity, spin;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), flow = Vec3::Zero();

  void add(const Corner (&c)[3], const Vec3 (&f)[3], const Vec3& N) noexcept {
    const double P = c[0].pressure + c[1].pressure + c[2].pressure;
    const Vec3 r = c[0].r + c[1].r + c[2].r;
    force -= (P / 3.0) * N;
    moment -= ((1.0 / 12.0) *
               (P * r + c[0].pressure * c[0].r + c[1].pressure * c[1].r + c[2].pressure * c[2].r))
                  .cross(N);
    const double through = velocity.dot(N);
    const Vec3 turning = N.cross(spin);  // (Ω × r)·N = r·(N × Ω)
    const double q[3] = {through + turning.dot(c[0].r), through + turning.dot(c[1].r),
                         through + turning.dot(c[2].r)};
    flow += (1.0 / 12.0) *
            ((q[0] + q[1] + q[2]) * (f[0] + f[1] + f[2]) + q[0] * f[0] + q[1] * f[1] + q[2] * f[2]);
  }
};

// With e the vertical and D = Σd_i, V = −∫d e·n dS, as the divergence of d e is −1 and d is 0 in
// the surface; likewise ∫r dV = −∫(r d + ½d² e) e·n dS.   ∫d² dS = S (D² + Σd_i²)/12
struct WettedTriangles::Measures {
  Vec3 first = Vec3::Zero();
  double area = 0.0, volume = 0.0, second = 0.0;

  void add(const Corner& a, const Corner& b, const Corner& c, double down) noexcept {
    const Vec3 r = a.r + b.r + c.r;
    const double D = a.depth + b.depth + c.depth, share = down / 12.0;
    volume += down * D / 3.0;
    first += share * (D * r + a.depth * a.r + b.depth * b.r + c.depth * c.r);
    second += share * (D * D + a.depth * a.depth + b.depth * b.depth + c.depth * c.depth);
  }
};

WettedTriangles::State::State(const WettedTriangles& hull)
    : depth(hull.points().size(), 0.0),
      pressure(hull.points().size(), 0.0),
      surfacePressure(hull.points().size(), 0.0),
      onSurface(hull.points().size(), 0.0),
      rise(hull.points().size(), 0.0),
      beamArea(hull.strips(), 0.0) {
  for (std::vector<double>& f : carried) f.resize(hull.points().size(), 0.0);
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
  findWeights();
}

// A triangle gives each of its vertices N/3 and (Σr + r_i)/12 × N.
void WettedTriangles::findWeights() {
  for (auto* columns : {&weights_.force, &weights_.moment}) {
    for (std::vector<double>& column : *columns) column.resize(points_.size(), 0.0);
  }
  for (const Triangle& t : triangles_) {
    for (const int v : t.v) {
      const Vec3 moment = momentWeight(t, v);
      for (std::size_t k = 0; k < 3; ++k) {
        weights_.force[k][static_cast<std::size_t>(v)] += t.area[static_cast<int>(k)] / 3.0;
        weights_.moment[k][static_cast<std::size_t>(v)] += moment[static_cast<int>(k)];
      }
    }
  }
}

Vec3 WettedTriangles::momentWeight(const Triangle& t, int vertex) const noexcept {
  const auto at = [this](int v) -> const Vec3& { return places_[static_cast<std::size_t>(v)]; };
  return ((1.0 / 12.0) * (at(t.v[0]) + at(t.v[1]) + at(t.v[2]) + at(vertex))).cross(t.area);
}

WettedTriangles::Corner WettedTriangles::corner(const State& state, int vertex) const noexcept {
  const auto i = static_cast<std::size_t>(vertex);
  return {places_[i], state.depth[i], state.pressure[i]};
}

Vec3 WettedTriangles::carriedAt(const State& state, int vertex) noexcept {
  const auto i = static_cast<std::size_t>(vertex);
  return {state.carried[0][i], state.carried[1][i], state.carried[2][i]};
}

Vec3 WettedTriangles::carriedAt(const State& state, const Crossing& at) noexcept {
  const Vec3 wet = carriedAt(state, at.wet);
  return wet + at.part * (carriedAt(state, at.dry) - wet);
}

// Where the surface cuts an edge, always found from its wet end: both triangles of the edge have
// the same bits.
WettedTriangles::Crossing WettedTriangles::crossing(const State& state, int wet,
                                                    int dry) const noexcept {
  const auto i = static_cast<std::size_t>(wet), j = static_cast<std::size_t>(dry);
  const double t = state.depth[i] / (state.depth[i] - state.depth[j]);
  const auto between = [&](const std::vector<double>& f) { return f[i] + t * (f[j] - f[i]); };
  return {{places_[i] + t * (places_[j] - places_[i]), 0.0, between(state.surfacePressure)},
          wet,
          dry,
          t};
}

// Of the triangle's area the piece at a corner that is alone on its side has the share
// (ab/AB)(ac/AC).
WettedTriangles::Piece WettedTriangles::pieceOf(const Triangle& triangle, int wet,
                                                const State& state) const noexcept {
  const bool aloneIsWet = wet == 1;
  const auto isWet = [&](std::size_t k) {
    return state.depth[static_cast<std::size_t>(triangle.v[k])] > 0.0;
  };
  std::size_t alone = 0;
  while (alone < 2 && isWet(alone) != aloneIsWet) ++alone;
  const int a = triangle.v[alone], b = triangle.v[(alone + 1) % 3], c = triangle.v[(alone + 2) % 3];
  if (aloneIsWet) {
    const Crossing ab = crossing(state, a, b), ac = crossing(state, a, c);
    return {ab, ac, {a, -1}, ab.part * ac.part, 0.0};
  }
  const Crossing ab = crossing(state, b, a), ac = crossing(state, c, a);
  const double toB = 1.0 - ab.part, toC = 1.0 - ac.part;
  return {ab, ac, {b, c}, 1.0 - toB, toB * (1.0 - toC)};
}

// Loads are linear in p: a triangle that is wet at all corners is in the sum over its vertices. Of
// one that is cut, what is in that sum is taken off again, and its piece put in.
void WettedTriangles::exchange(const Triangle& t, const Piece& piece, State& state,
                               Loads& loads) const noexcept {
  for (const int v : piece.wet) {
    if (v < 0) continue;
    const auto i = static_cast<std::size_t>(v);
    const Vec3 moment = momentWeight(t, v);
    loads.force += (state.pressure[i] / 3.0) * t.area;
    loads.moment += state.pressure[i] * moment;
    loads.flow -= (loads.velocity.dot(t.area) / 3.0 + loads.spin.dot(moment)) * carriedAt(state, v);
  }
  const Vec3 fb = carriedAt(state, piece.ab), fc = carriedAt(state, piece.ac);
  const Corner first = corner(state, piece.wet[0]);
  const Vec3 f0 = carriedAt(state, piece.wet[0]);
  if (piece.wet[1] < 0) {
    loads.add({first, piece.ab.at, piece.ac.at}, {f0, fb, fc}, piece.first * t.area);
  } else {
    const Corner second = corner(state, piece.wet[1]);
    const Vec3 f1 = carriedAt(state, piece.wet[1]);
    loads.add({piece.ab.at, first, second}, {fb, f0, f1}, piece.first * t.area);
    loads.add({piece.ab.at, second, piece.ac.at}, {fb, f1, fc}, piece.second * t.area);
  }
}

// A level hull section of normal n, n_h its level part, in water that rises at ζ̇ moves outwards at
// (V·n − ζ̇ n·e)/|n_h|. Where the hull lies nearly flat in the surface that is bounded.
void WettedTriangles::addEdge(const Vec3& up, const Vec6& motion, const Piece& piece,
                              const Triangle& t, State& state) const noexcept {
  const auto at = [](const std::vector<double>& f, const Crossing& c) {
    const auto i = static_cast<std::size_t>(c.wet), j = static_cast<std::size_t>(c.dry);
    return f[i] + c.part * (f[j] - f[i]);
  };
  const Vec3 &a = piece.ab.at.r, &b = piece.ac.at.r;
  const Vec3 velocity = motion.head<3>() + motion.tail<3>().cross(0.5 * (a + b));
  const double upwards = t.area.dot(up);
  const double level = std::sqrt(std::max(0.0, t.size * t.size - upwards * upwards));
  const double rise = 0.5 * (at(state.rise, piece.ab) + at(state.rise, piece.ac));
  const double speed =
      (velocity.dot(t.area) - rise * upwards) / std::max(level, kFlattest * t.size);
  const double length = (b - a).norm();
  state.edge +=
      (0.5 * speed * length) * (at(state.onSurface, piece.ab) * carriedAt(state, piece.ab) +
                                at(state.onSurface, piece.ac) * carriedAt(state, piece.ac));
}

CUTWATER_VECTOR void WettedTriangles::sumOverVertices(const Weights& weights, const State& state,
                                                      const Vec6& motion, double* sums) noexcept {
  Double4 force[3] = {}, moment[3] = {}, flow[3] = {};
  const std::size_t count = state.depth.size();
  for (std::size_t i = 0; i < count; i += 4) {
    const Double4 depth = load4(&state.depth[i]), none = {};
    const Double4 pressure = depth > none ? load4(&state.pressure[i]) : none;
    Double4 through = {};
    for (std::size_t k = 0; k < 3; ++k) {
      const Double4 N = load4(&weights.force[k][i]), M = load4(&weights.moment[k][i]);
      force[k] -= pressure * N;
      moment[k] -= pressure * M;
      through += motion[static_cast<int>(k)] * N + motion[static_cast<int>(k) + 3] * M;
    }
    through = depth > none ? through : none;
    for (std::size_t k = 0; k < 3; ++k) flow[k] += through * load4(&state.carried[k][i]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    sums[k] = sumOf(force[k]);
    sums[3 + k] = sumOf(moment[k]);
    sums[6 + k] = sumOf(flow[k]);
  }
}

void WettedTriangles::press(const Vec3& up, const Vec6& motion, State& state) const noexcept {
  std::fill(state.beamArea.begin(), state.beamArea.end(), 0.0);
  state.waterline.clear();
  state.edge.setZero();
  state.deckArea = 0.0;
  double sums[9];
  sumOverVertices(weights_, state, motion, sums);
  Loads loads{motion.head<3>(), motion.tail<3>()};
  const double* depth = state.depth.data();
  for (const Triangle& t : triangles_) {
    const int wet = (depth[t.v[0]] > 0.0) + (depth[t.v[1]] > 0.0) + (depth[t.v[2]] > 0.0);
    if (wet == 0) continue;
    double share = 1.0;
    if (wet < 3) {
      const Piece piece = pieceOf(t, wet, state);
      share = piece.first + piece.second;
      exchange(t, piece, state, loads);
      addEdge(up, motion, piece, t, state);
      state.waterline.emplace_back(piece.ab.at.r, piece.ac.at.r);
    }
    const double down = -share * t.area.dot(up);
    state.beamArea[static_cast<std::size_t>(t.strip)] += std::max(0.0, down);
    state.deckArea += std::max(0.0, -down);
  }
  state.load << loads.force + Vec3(sums[0], sums[1], sums[2]),
      loads.moment + Vec3(sums[3], sums[4], sums[5]);
  state.flow = loads.flow + Vec3(sums[6], sums[7], sums[8]);
  state.wetVertices = static_cast<std::size_t>(std::count_if(
      state.depth.begin(), state.depth.begin() + static_cast<std::ptrdiff_t>(vertices_),
      [](double d) { return d > 0.0; }));
}

void WettedTriangles::measure(const Vec3& up, State& state) const noexcept {
  Measures sums;
  const double* depth = state.depth.data();
  for (const Triangle& t : triangles_) {
    const int wet = (depth[t.v[0]] > 0.0) + (depth[t.v[1]] > 0.0) + (depth[t.v[2]] > 0.0);
    if (wet == 0) continue;
    const double down = -t.area.dot(up);
    if (wet == 3) {
      sums.add(corner(state, t.v[0]), corner(state, t.v[1]), corner(state, t.v[2]), down);
      sums.area += t.size;
      continue;
    }
    const Piece piece = pieceOf(t, wet, state);
    sums.area += (piece.first + piece.second) * t.size;
    const Corner first = corner(state, piece.wet[0]);
    if (piece.wet[1] < 0) {
      sums.add(first, piece.ab.at, piece.ac.at, piece.first * down);
    } else {
      const Corner second = corner(state, piece.wet[1]);
      sums.add(piece.ab.at, first, second, piece.first * down);
      sums.add(piece.ab.at, second, piece.ac.at, piece.second * down);
    }
  }
  state.area = sums.area;
  state.volume = sums.volume;
  state.centre =
      sums.volume > 0.0 ? Vec3((sums.first + 0.5 * sums.second * up) / sums.volume) : Vec3::Zero();
}

void WettedTriangles::wetFaces(const State& state, std::vector<WetFace>& faces) const noexcept {
  faces.clear();
  const double* depth = state.depth.data();
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& area) {
    faces.push_back({(a + b + c) / 3.0, area});
  };
  const auto at = [this](int v) -> const Vec3& { return places_[static_cast<std::size_t>(v)]; };
  for (const Triangle& t : triangles_) {
    const int wet = (depth[t.v[0]] > 0.0) + (depth[t.v[1]] > 0.0) + (depth[t.v[2]] > 0.0);
    if (wet == 0) continue;
    if (wet == 3) {
      add(at(t.v[0]), at(t.v[1]), at(t.v[2]), t.area);
      continue;
    }
    const Piece piece = pieceOf(t, wet, state);
    const Vec3 &ab = piece.ab.at.r, &ac = piece.ac.at.r, &first = at(piece.wet[0]);
    if (piece.wet[1] < 0) {
      add(first, ab, ac, piece.first * t.area);
    } else {
      const Vec3& second = at(piece.wet[1]);
      add(ab, first, second, piece.first * t.area);
      add(ab, second, ac, piece.second * t.area);
    }
  }
}

void WettedTriangles::cut(const Vec3& up, State& state) const noexcept {
  press(up, Vec6::Zero(), state);
  measure(up, state);
}

}  // namespace cutwater
