#include "hydro/geometry/outer/SurfaceFitting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/outer/PanelTidying.h"

namespace cutwater {
namespace {

constexpr double kAlongEdge = 0.8;  // cosine of the angle up to which two edges are one
constexpr int kReturns = 3;         // to the surface and to the plane that holds a vertex, in turn
constexpr double kEdge = 0.8;  // cosine of the angle between the faces of an edge: 37° or more
constexpr double kStep = 0.5;  // of the way to the middle, a round
constexpr double kOfThickness = 0.2;
constexpr double kFlat = 1e-3;      // of the way a vertex may go: lower heights are none
constexpr double kMostShare = 1.5;  // of the height of the surface over the panels
constexpr int kFillRounds = 8;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Decides which of two neighbours may take the other's place.
class Merging {
 public:
  explicit Merging(DualSurface& surface)
      : s_(surface), of_(surface.mesh.vertices.size()), used_(of_.size(), false) {
    std::iota(of_.begin(), of_.end(), 0);
  }

  void shorterThan(double shortest) {
    struct Edge {
      double length;
      int a, b;
    };
    std::vector<Edge> edges;
    for (const Face& f : s_.mesh.faces)
      for (int i = 0; i < f.size(); ++i) {
        const int a = f[i], b = f[(i + 1) % f.size()];
        const double length = (point(a) - point(b)).norm();
        if (a < b && length < shortest) edges.push_back({length, a, b});
      }
    std::sort(edges.begin(), edges.end(), [](const Edge& l, const Edge& r) {
      return std::tie(l.length, l.a, l.b) < std::tie(r.length, r.a, r.b);
    });
    // Each vertex once: a chain of short edges must not end in one point.
    for (const Edge& e : edges)
      if (!used_[at(e.a)] && !used_[at(e.b)]) merge(e.a, e.b);
    rebuild();
  }

 private:
  Vec3& point(int i) { return s_.mesh.vertices[at(i)]; }
  VertexHold& hold(int i) { return s_.hold[at(i)]; }

  void merge(int a, int b) {
    const int flagsA = flags(a), flagsB = flags(b);
    const bool aStays = flagsA == (flagsA | flagsB) && hold(a).planes >= hold(b).planes;
    const bool bStays = flagsB == (flagsA | flagsB) && hold(b).planes >= hold(a).planes;
    if ((!aStays && !bStays) || !oneEdge(a, b)) return;
    const int stays = aStays ? a : b, goes = aStays ? b : a;
    if (aStays && bStays && flagsA == 0 && hold(a).planes == 1)
      point(stays) = 0.5 * (point(a) + point(b));
    of_[at(goes)] = stays;
    used_[at(a)] = used_[at(b)] = true;
  }
  int flags(int i) { return (hold(i).onCentreplane ? 1 : 0) + (hold(i).onWater ? 2 : 0); }

  /// Of two vertices on sharp edges: that both edges run from one to the other.
  bool oneEdge(int a, int b) {
    if (hold(a).planes < 2 || hold(b).planes < 2) return true;
    if (hold(a).planes == 3 && hold(b).planes == 3) return false;
    const Vec3 between = (point(b) - point(a)).normalized();
    const auto runs = [&](int i) {
      return hold(i).planes == 3 || std::abs(hold(i).along.dot(between)) > kAlongEdge;
    };
    return runs(a) && runs(b);
  }

  /// Faces on what is left of their corners. Two faces back to back on the same corners go.
  void rebuild() {
    std::vector<Face> kept;
    for (Face face : s_.mesh.faces) {
      Face left;
      int n = 0;
      for (int i = 0; i < face.size(); ++i) {
        const int v = of_[at(face[i])], before = of_[at(face[(i + face.size() - 1) % face.size()])];
        if (v != before) left.v[at(n++)] = v;
      }
      if (n < 3 || (n == 4 && (left[0] == left[2] || left[1] == left[3]))) continue;
      kept.push_back(left);
    }
    s_.mesh.faces = withoutFolds(kept);
    dropUnused();
  }

  void dropUnused() {
    std::vector<int> now(s_.mesh.vertices.size(), -1);
    DualSurface left;
    for (Face face : s_.mesh.faces) {
      for (int i = 0; i < face.size(); ++i) {
        int& v = now[at(face[i])];
        if (v < 0) {
          v = static_cast<int>(left.mesh.vertices.size());
          left.mesh.vertices.push_back(point(face[i]));
          left.hold.push_back(hold(face[i]));
        }
        face.v[at(i)] = v;
      }
      left.mesh.faces.push_back(face);
    }
    s_ = std::move(left);
  }

  DualSurface& s_;
  std::vector<int> of_;
  std::vector<bool> used_;
};

Vec3 heldTo(Vec3 p, const VertexHold& hold) {
  if (hold.onCentreplane) p.y() = 0.0;
  if (hold.onWater) p.z() = 0.0;
  return p;
}

Vec3 back(Vec3 p, const VertexHold& hold, const SurfaceTree& onto) {
  p = heldTo(p, hold);
  for (int i = 0; i < kReturns; ++i) p = heldTo(onto.nearest(p), hold);
  return p;
}

bool mayMove(const VertexHold& hold) {
  return hold.planes <= 1 && !(hold.onCentreplane && hold.onWater);
}

/// Mean, by area, of the middles of the faces around each vertex.
std::vector<Vec3> middles(const SurfaceMesh& mesh) {
  std::vector<Vec3> sum(mesh.vertices.size(), Vec3::Zero());
  std::vector<double> area(sum.size(), 0.0);
  for (const Face& f : mesh.faces) {
    const double a = vectorArea(mesh, f).norm();
    for (int i = 0; i < f.size(); ++i) {
      sum[at(f[i])] += a * meanCorner(mesh, f);
      area[at(f[i])] += a;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = area[i] > 0 ? Vec3(sum[i] / area[i]) : mesh.vertices[i];
  return sum;
}

/// The vector area at each vertex that may move, within the planes that hold it.
std::vector<Vec3> pushes(const DualSurface& s) {
  std::vector<Vec3> push(s.mesh.vertices.size(), Vec3::Zero());
  for (const Face& f : s.mesh.faces)
    for (int i = 0; i < f.size(); ++i) push[at(f[i])] += vectorArea(s.mesh, f) / f.size();
  for (std::size_t i = 0; i < push.size(); ++i) {
    if (!mayMove(s.hold[i])) push[i].setZero();
    if (s.hold[i].onCentreplane) push[i].y() = 0.0;
    if (s.hold[i].onWater) push[i].z() = 0.0;
  }
  return push;
}

}  // namespace

void mergeShortEdges(DualSurface& surface, double shortest) {
  Merging(surface).shorterThan(shortest);
}

namespace {

/// Whether faces within reach of a place turn by more than kEdge.
bool hasEdge(const SurfaceMesh& fine, const SurfaceTree& onto, const Vec3& place, double reach) {
  const Vec3 around = Vec3::Constant(reach);
  std::vector<Vec3> normals;
  for (const int f : onto.near(place - around, place + around)) {
    const Vec3 n = vectorArea(fine, fine.faces[at(f)]).normalized();
    for (const Vec3& other : normals)
      if (n.dot(other) < kEdge) return true;
    normals.push_back(n);
  }
  return false;
}

}  // namespace

void releaseRoundEdges(DualSurface& surface, const SurfaceMesh& fine, const SurfaceTree& onto,
                       double tolerance, double reach) {
  for (std::size_t i = 0; i < surface.hold.size(); ++i) {
    VertexHold& hold = surface.hold[i];
    if (hold.planes <= 1) continue;
    const Vec3 &p = surface.mesh.vertices[i], place = onto.nearest(p);
    if ((place - p).norm() > tolerance && !hasEdge(fine, onto, place, reach)) hold.planes = 1;
  }
}

void smooth(DualSurface& surface, const SurfaceTree& onto, int rounds) {
  for (std::size_t i = 0; i < surface.hold.size(); ++i)
    if (mayMove(surface.hold[i]))
      surface.mesh.vertices[i] = back(surface.mesh.vertices[i], surface.hold[i], onto);
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vec3> middle = middles(surface.mesh);
    for (std::size_t i = 0; i < middle.size(); ++i) {
      Vec3& p = surface.mesh.vertices[i];
      if (mayMove(surface.hold[i])) p = back(p + kStep * (middle[i] - p), surface.hold[i], onto);
    }
  }
}

namespace {

/// How far the surface stands out over the middles of the faces around each vertex, by area [m].
std::vector<double> heights(const SurfaceMesh& mesh, const SurfaceTree& onto) {
  std::vector<double> sum(mesh.vertices.size(), 0.0), area(sum.size(), 0.0);
  for (const Face& f : mesh.faces) {
    const Vec3 middle = meanCorner(mesh, f), vector = vectorArea(mesh, f);
    const double height = (onto.nearest(middle) - middle).dot(vector.normalized());
    for (int i = 0; i < f.size(); ++i) {
      sum[at(f[i])] += vector.norm() * height;
      area[at(f[i])] += vector.norm();
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = area[i] > 0 ? sum[i] / area[i] : 0.0;
  return sum;
}

/// How far a vertex may go outwards [m]: a ray into the body finds the other side of a plate.
double limitOf(const SurfaceTree& tree, const Vec3& vertex, const Vec3& outwards, double most) {
  const Vec3 from = vertex - 0.01 * most * outwards;
  for (double thickness = most / kOfThickness; thickness > 0.02 * most; thickness *= 0.5)
    if (!tree.meets(from, -outwards, -1, thickness)) return kOfThickness * thickness;
  return 0.0;
}

}  // namespace

void fillOut(DualSurface& surface, const SurfaceTree& onto, double volume, double most) {
  const SurfaceMesh before = surface.mesh;
  const SurfaceTree tree(before);
  const std::vector<Vec3> push = pushes(surface);
  const std::vector<double> height = heights(before, onto);
  std::vector<double> limit(push.size(), 0.0);
  for (std::size_t i = 0; i < push.size(); ++i)
    if (push[i].norm() > 0 && std::abs(height[i]) > kFlat * most)
      limit[i] = limitOf(tree, before.vertices[i], push[i].normalized(), most);
  double share = 0.0;  // of the height
  const auto way = [&](std::size_t i) {
    return std::clamp(share * height[i], -limit[i], limit[i]);
  };
  for (int round = 0; round < kFillRounds; ++round) {
    const double lacking = volume - volumeIntegrals(surface.mesh).volume;
    double perShare = 0.0;
    for (std::size_t i = 0; i < push.size(); ++i)
      if (limit[i] > std::abs(way(i))) perShare += push[i].norm() * height[i];
    if (std::abs(perShare) < 1e-12 * volume) return;
    share = std::clamp(share + lacking / perShare, -kMostShare, kMostShare);
    for (std::size_t i = 0; i < push.size(); ++i)
      if (limit[i] > 0)
        surface.mesh.vertices[i] = before.vertices[i] + way(i) * push[i].normalized();
  }
}

}  // namespace cutwater
