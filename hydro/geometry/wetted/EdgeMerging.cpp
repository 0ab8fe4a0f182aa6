#include "hydro/geometry/wetted/EdgeMerging.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hydro/geometry/MeshEdges.h"

namespace cutwater {
namespace {

// How much a misfit of the waterplane's area counts: as this part of the hull's size, times the
// area, would as a volume (decision 0103).
constexpr double kWaterplaneDepth = 0.05;
// Where the volumes leave the place free, it is near the edge's middle; where they leave the order
// free, short edges go first.
constexpr double kToMiddle = 1e-5, kLengthCounts = 1e-8;
// The least cosine between a triangle's normals before and after.
constexpr double kLeastTurnCosine = 0.2;
// Twice the area over the sum of the squared sides: at least this, or half of what it was.
constexpr double kLeastShape = 0.02;
// Below this the triangles around an edge face all ways, and hold no volume.
constexpr double kLeastOpening = 0.02;

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

bool has(const Face& f, int v) { return f[0] == v || f[1] == v || f[2] == v; }

void sortUnique(std::vector<int>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

/// A triangle's normal times twice its area, and the sum of its squared sides.
struct Shape {
  Vec3 n;
  double sides2;
  Shape(const Vec3& a, const Vec3& b, const Vec3& c)
      : n((b - a).cross(c - a)),
        sides2((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm()) {}
};

}  // namespace

// Places u from the middle of an edge. A triangle with normal n of twice its area and a corner p
// spans six times the volume n·(u − p) with u. Their squares sum to u·Hu − 2c·u + e; their own sum,
// by which the enclosed volume changes, is g·u − d.
struct EdgeMerging::Misfit {
  Mat3 H = Mat3::Zero();
  Vec3 c = Vec3::Zero(), g = Vec3::Zero();
  double d = 0.0, e = 0.0, areas = 0.0, reach2 = 0.0;

  void addSquare(const Vec3& n, double s) {
    H += n * n.transpose();
    c += s * n;
    e += s * s;
  }
  void addTriangle(const Vec3& p, const Vec3& q, const Vec3& r) {
    const Vec3 n = Shape(p, q, r).n;
    const double s = n.dot(p);
    addSquare(n, s);
    g += n;
    d += s;
    areas += n.norm();
    reach2 = std::max({reach2, p.squaredNorm(), q.squaredNorm(), r.squaredNorm()});
  }
  void hold(int axis) {
    H.row(axis).setZero();
    H.col(axis).setZero();
    c[axis] = g[axis] = 0.0;
  }
  double cost(const Vec3& u) const { return std::max(0.0, u.dot(H * u) - 2 * c.dot(u) + e); }

  /// The least cost under g·u = d, by Lagrange's multiplier; none where that is ill-posed. What the
  /// cost leaves free stays in the middle. After the second time all else is drawn there by the
  /// square of kToMiddle only.
  std::optional<Vec3> best() const {
    if (areas == 0.0) return Vec3::Zero();
    if (g.norm() < kLeastOpening * areas) return {};
    const double damping = kToMiddle * std::max(H.trace(), g.squaredNorm());
    const Mat3 inverse = (H + damping * Mat3::Identity()).inverse();
    const Vec3 alongVolume = inverse * g;
    Vec3 u = Vec3::Zero();
    for (int time = 0; time < 2; ++time) {
      const Vec3 free = inverse * (c + damping * u);
      u = free + (d - g.dot(free)) / g.dot(alongVolume) * alongVolume;
    }
    if (!(u.squaredNorm() <= reach2)) return {};
    return u;
  }
};

EdgeMerging::EdgeMerging(SurfaceMesh triangles, bool half)
    : mesh_(std::move(triangles)),
      half_(half),
      size_(bounds(mesh_).diagonal()),
      count_(mesh_.faces.size()),
      held_(mesh_.vertices.size(), 0),
      age_(mesh_.vertices.size(), 0),
      facesAt_(mesh_.vertices.size()) {
  for (std::size_t k = 0; k < mesh_.faces.size(); ++k)
    for (int i = 0; i < 3; ++i) facesAt_[slot(mesh_.faces[k][i])].push_back(static_cast<int>(k));
  holdVertices();
}

void EdgeMerging::holdVertices() {
  for (std::size_t v = 0; v < held_.size(); ++v) {
    const Vec3& p = mesh_.vertices[v];
    held_[v] = static_cast<std::uint8_t>((half_ && p.y() == 0.0 ? kCentreplane : 0) |
                                         (p.z() == 0.0 ? kWater : 0));
    if (held_[v] == (kCentreplane | kWater)) held_[v] = kStays;
  }
  const std::vector<EdgeUse> uses = edgeUses(mesh_);
  for (std::size_t i = 0, next = 0; i < uses.size(); i = next) {
    next = i + 1;
    while (next < uses.size() && uses[next].edge == uses[i].edge) ++next;
    const std::size_t a = uses[i].edge >> 32, b = uses[i].edge & 0xffffffffu;
    if (next - i == 2 && uses[i].rising != uses[i + 1].rising) continue;
    const bool cut = half_ && mesh_.vertices[a].y() == 0.0 && mesh_.vertices[b].y() == 0.0;
    if (next - i == 1 && cut) continue;
    held_[a] = held_[b] = kStays;
  }
}

void EdgeMerging::mergeTo(std::size_t most) {
  for (std::size_t before = count_ + 1; count_ > most && count_ < before;) {
    before = count_;
    considerAll();  // again: what could not go may go now
    while (count_ > most && !candidates_.empty()) mergeCheapest();
  }
}

SurfaceMesh EdgeMerging::result() const {
  SurfaceMesh out;
  std::vector<int> index(mesh_.vertices.size(), -1);
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (facesAt_[v].empty()) continue;
    index[v] = static_cast<int>(out.vertices.size());
    out.vertices.push_back(mesh_.vertices[v]);
  }
  for (const Face& f : mesh_.faces)
    if (f[0] >= 0)
      out.faces.push_back({{index[slot(f[0])], index[slot(f[1])], index[slot(f[2])], -1}});
  return out;
}

int EdgeMerging::age(int a, int b) const { return age_[slot(a)] + age_[slot(b)]; }

double EdgeMerging::side(const Face& f) const { return at(f[0]).z() + at(f[1]).z() + at(f[2]).z(); }

std::vector<int> EdgeMerging::neighbours(int v) const {
  std::vector<int> found;
  for (const int k : facesAt(v))
    for (int i = 0; i < 3; ++i)
      if (face(k)[i] != v) found.push_back(face(k)[i]);
  sortUnique(found);
  return found;
}

void EdgeMerging::consider(int a, int b) {
  if (a > b) std::swap(a, b);
  if (const auto found = merger(a, b)) candidates_.push({found->cost, a, b, age(a, b)});
}

void EdgeMerging::considerAll() {
  candidates_ = {};
  for (int v = 0; v < static_cast<int>(facesAt_.size()); ++v)
    for (const int other : neighbours(v))
      if (v < other) consider(v, other);
}

void EdgeMerging::mergeCheapest() {
  const Candidate edge = candidates_.top();
  candidates_.pop();
  if (edge.age != age(edge.a, edge.b)) return;
  // The triangles around it may have changed since.
  const auto now = merger(edge.a, edge.b);
  if (!now) return;
  if (!candidates_.empty() && now->cost > candidates_.top().cost)
    candidates_.push({now->cost, edge.a, edge.b, edge.age});
  else
    merge(edge.a, edge.b, now->to);
}

void EdgeMerging::merge(int a, int b, const Vec3& to) {
  mesh_.vertices[slot(a)] = to;
  for (const int k : std::exchange(facesAt_[slot(b)], {})) {
    Face& f = mesh_.faces[slot(k)];
    if (has(f, a)) {
      for (int i = 0; i < 3; ++i) std::erase(facesAt_[slot(f[i])], k);
      f = {};
      --count_;
    } else {
      std::replace(f.v.begin(), f.v.end(), b, a);
      facesAt_[slot(a)].push_back(k);
    }
  }
  ++age_[slot(a)];
  ++age_[slot(b)];  // no candidate has it any more
  for (const int v : neighbours(a)) consider(a, v);
}

template <class Visit>
void EdgeMerging::around(int a, int b, const Visit& visit) const {
  for (const int k : facesAt(a)) visit(face(k));
  for (const int k : facesAt(b))
    if (!has(face(k), a)) visit(face(k));
}

std::optional<EdgeMerging::Merger> EdgeMerging::merger(int a, int b) const {
  if (held(a) != held(b) || held(a) == kStays || !keepsTopology(a, b)) return {};
  const Vec3 middle = 0.5 * (at(a) + at(b));
  Misfit misfit;
  around(a, b, [&](const Face& f) {
    misfit.addTriangle(at(f[0]) - middle, at(f[1]) - middle, at(f[2]) - middle);
    if (held(a) == kWater && below(f)) addWaterline(f, a, b, misfit);
  });
  if (held(a) == kCentreplane) misfit.hold(1);
  if (held(a) == kWater) misfit.hold(2);
  const std::optional<Vec3> u = misfit.best();
  if (!u) return {};
  const Vec3 to = middle + *u;
  if (!keepsSides(a, middle, to) || !keepsNormals(a, b, to)) return {};
  const double length2 = (at(a) - at(b)).squaredNorm();
  return Merger{misfit.cost(*u) + kLengthCounts * misfit.H.trace() * length2, to};
}

// The link condition: the ends have no other common neighbours than the apexes of the triangles
// between them, and no apex is left with two triangles only.
bool EdgeMerging::keepsTopology(int a, int b) const {
  std::size_t between = 0;
  for (const int k : facesAt(a)) {
    if (!has(face(k), b)) continue;
    ++between;
    for (int i = 0; i < 3; ++i) {
      const int apex = face(k)[i];
      const std::size_t least = half_ && at(apex).y() == 0.0 ? 3 : 4;
      if (apex != a && apex != b && facesAt(apex).size() < least) return false;
    }
  }
  const std::vector<int> ofA = neighbours(a), ofB = neighbours(b);
  std::vector<int> common;
  std::set_intersection(ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(common));
  return between > 0 && common.size() == between && liesAlongPlane(a, b);
}

// An edge between two vertices of a plane that are held there must be one along which the mesh
// passes through it, or ends: no chord from one side of the waterline to the other.
bool EdgeMerging::liesAlongPlane(int a, int b) const {
  int under = 0, all = 0;
  for (const int k : facesAt(a)) {
    if (!has(face(k), b)) continue;
    under += below(face(k));
    ++all;
  }
  if (held(a) == kCentreplane) return all == 1;
  return all == 2 && (held(a) != kWater || under == 1);
}

// The line from p to q of the waterline sweeps twice the area z·((q − p) × (u − p)) on its way to
// u.
void EdgeMerging::addWaterline(const Face& f, int a, int b, Misfit& misfit) const {
  for (int i = 0; i < 3; ++i) {
    const int v = f[i], w = f[(i + 1) % 3];
    const bool moves = v == a || v == b || w == a || w == b;
    if (!moves || at(v).z() != 0.0 || at(w).z() != 0.0) continue;
    const Vec3 n = 3.0 * kWaterplaneDepth * size_ * Vec3::UnitZ().cross(at(w) - at(v));
    misfit.addSquare(n, n.dot(at(v) - 0.5 * (at(a) + at(b))));
  }
}

bool EdgeMerging::keepsSides(int a, const Vec3& from, const Vec3& to) const {
  if (half_ && held(a) != kCentreplane && !(to.y() > 0.0)) return false;
  return held(a) == kWater || from.z() * to.z() > 0.0;
}

bool EdgeMerging::keepsNormals(int a, int b, const Vec3& to) const {
  bool kept = true;
  around(a, b, [&](const Face& f) {
    if (!kept || (has(f, a) && has(f, b))) return;
    const auto moved = [&](int v) { return v == a || v == b ? to : at(v); };
    const Shape before(at(f[0]), at(f[1]), at(f[2])), after(moved(f[0]), moved(f[1]), moved(f[2]));
    const double was = before.n.norm(), is = after.n.norm();
    const bool hadNormal = was > 1e-9 * before.sides2;
    const bool turned = hadNormal && before.n.dot(after.n) < kLeastTurnCosine * was * is;
    const double shape = is / after.sides2;
    const bool thin = shape < kLeastShape && shape < 0.5 * was / before.sides2;
    kept = !turned && !thin;
  });
  return kept;
}

}  // namespace cutwater
