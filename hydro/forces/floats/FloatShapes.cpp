#include "hydro/forces/floats/FloatShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater {

namespace {

constexpr double kSameCorner = 1e-9;  // of the size
constexpr int kFewestParts = 2, kMostParts = 6;
constexpr int kRingSides = 16;
constexpr int kBallParts = 3;  // of an edge of the icosahedron
constexpr int kLattice = 9;    // points along each side of a bounding box

SurfaceMesh sharing(const SurfaceMesh& mesh) {
  return welded(mesh, kSameCorner * bounds(mesh).diagonal());
}

// One face of a box, from a corner along u and v, normal u × v.
void addGrid(SurfaceMesh& mesh, const Vec3& corner, const Vec3& u, int nu, const Vec3& v, int nv) {
  const auto first = static_cast<int>(mesh.vertices.size());
  for (int i = 0; i <= nu; ++i) {
    for (int j = 0; j <= nv; ++j) mesh.vertices.emplace_back(corner + i * u / nu + j * v / nv);
  }
  const auto at = [&](int i, int j) { return first + i * (nv + 1) + j; };
  for (int i = 0; i < nu; ++i) {
    for (int j = 0; j < nv; ++j) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      // Diagonals that meet in the middle of a face, so that its halves are alike.
      if ((2 * i < nu) == (2 * j < nv)) {
        mesh.faces.push_back({{a, b, c, -1}});
        mesh.faces.push_back({{a, c, d, -1}});
      } else {
        mesh.faces.push_back({{a, b, d, -1}});
        mesh.faces.push_back({{b, c, d, -1}});
      }
    }
  }
}

SurfaceMesh icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  SurfaceMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  // Every three corners at one edge's length from one another.
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        const auto& at = mesh.vertices;
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b),
                   k = static_cast<std::size_t>(c);
        const double longest =
            std::max({(at[i] - at[j]).norm(), (at[j] - at[k]).norm(), (at[k] - at[i]).norm()});
        if (longest > 2.1) continue;
        const bool outward = at[i].dot(at[j].cross(at[k])) > 0.0;
        mesh.faces.push_back(outward ? Face{{a, b, c, -1}} : Face{{a, c, b, -1}});
      }
    }
  }
  return mesh;
}

double volumeOfTetrahedron(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot(b.cross(c)) / 6.0;
}

bool within(const Bounds& box, const Vec3& point) {
  return (point.array() >= box.low.array()).all() && (point.array() <= box.high.array()).all();
}

bool encloses(const SurfaceMesh& convex, const Vec3& point) {
  return std::all_of(convex.faces.begin(), convex.faces.end(), [&](const Face& face) {
    return vectorArea(convex, face).dot(point - meanCorner(convex, face)) <= 0.0;
  });
}

}  // namespace

SurfaceMesh floatBox(const Vec3& half) {
  const double edge = std::max(half.minCoeff(), 2.0 * half.maxCoeff() / kMostParts);
  std::array<int, 3> parts;
  std::array<Vec3, 3> along;
  for (int i = 0; i < 3; ++i) {
    const double wanted = std::round(2.0 * half[i] / edge);
    parts[static_cast<std::size_t>(i)] =
        std::clamp(static_cast<int>(wanted), kFewestParts, kMostParts);
    along[static_cast<std::size_t>(i)] = 2.0 * half[i] * Vec3::Unit(i);
  }
  SurfaceMesh mesh;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    addGrid(mesh, -half + along[i], along[j], parts[j], along[k], parts[k]);
    addGrid(mesh, -half, along[k], parts[k], along[j], parts[j]);
  }
  return sharing(mesh);
}

SurfaceMesh floatBall(double radius) {
  const SurfaceMesh coarse = icosahedron();
  SurfaceMesh mesh;
  for (const Face& face : coarse.faces) {
    const Vec3 &a = coarse.corner(face, 0), &b = coarse.corner(face, 1),
               &c = coarse.corner(face, 2);
    const auto first = static_cast<int>(mesh.vertices.size());
    std::array<std::array<int, kBallParts + 1>, kBallParts + 1> at{};
    int next = first;
    for (std::size_t i = 0; i <= kBallParts; ++i) {
      for (std::size_t j = 0; i + j <= kBallParts; ++j) {
        const auto x = static_cast<double>(i) / kBallParts, y = static_cast<double>(j) / kBallParts;
        mesh.vertices.emplace_back((a + x * (b - a) + y * (c - a)).normalized());
        at[i][j] = next++;
      }
    }
    for (std::size_t i = 0; i < kBallParts; ++i) {
      for (std::size_t j = 0; i + j < kBallParts; ++j) {
        mesh.faces.push_back({{at[i][j], at[i + 1][j], at[i][j + 1], -1}});
        if (i + j + 1 < kBallParts)
          mesh.faces.push_back({{at[i + 1][j], at[i + 1][j + 1], at[i][j + 1], -1}});
      }
    }
  }
  mesh = sharing(mesh);
  const double scale = radius * std::cbrt(4.0 / 3.0 * kPi / volumeIntegrals(mesh).volume);
  for (Vec3& p : mesh.vertices) p *= scale;
  return mesh;
}

SurfaceMesh floatTurned(std::span<const ProfilePoint> profile, int sides, double volume) {
  SurfaceMesh mesh;
  std::vector<int> before, ring;  // of one vertex on the axis
  for (const ProfilePoint& point : profile) {
    ring.clear();
    const int count = point.radius > 0.0 ? sides : 1;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * kPi * i / sides;
      ring.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.emplace_back(point.radius * std::cos(angle), point.radius * std::sin(angle),
                                 point.z);
    }
    for (int i = 0; i < sides && !before.empty(); ++i) {
      const auto one = [&](const std::vector<int>& of, int k) {
        return of[of.size() == 1 ? 0 : static_cast<std::size_t>(k % sides)];
      };
      const int a = one(before, i), b = one(before, i + 1), c = one(ring, i + 1), d = one(ring, i);
      if (a != b) mesh.faces.push_back({{a, b, c, -1}});
      if (c != d) mesh.faces.push_back({{a, c, d, -1}});
    }
    before = ring;
  }
  const double out = std::sqrt(volume / volumeIntegrals(mesh).volume);
  for (Vec3& p : mesh.vertices) p.head<2>() *= out;
  return mesh;
}

SurfaceMesh floatCylinder(double radius, double halfHeight) {
  const std::array<ProfilePoint, 5> profile{{{0.0, -halfHeight},
                                             {radius, -halfHeight},
                                             {radius, 0.0},
                                             {radius, halfHeight},
                                             {0.0, halfHeight}}};
  return floatTurned(profile, kRingSides, 2.0 * kPi * radius * radius * halfHeight);
}

SurfaceMesh floatCapsule(double radius, double halfHeight) {
  constexpr int kRings = 3;  // of a half ball, from its pole to its rim
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= kRings; ++i) {
    const double angle = 0.5 * kPi * i / kRings;
    profile.push_back(
        {i == 0 ? 0.0 : radius * std::sin(angle), -halfHeight - radius * std::cos(angle)});
  }
  const std::size_t half = profile.size();
  if (halfHeight > 0.5 * radius) profile.push_back({radius, 0.0});
  for (std::size_t i = half; i-- > 0;) {
    if (halfHeight <= 0.0 && i + 1 == half) continue;  // a ball has one rim
    profile.push_back({profile[i].radius, -profile[i].z});
  }
  const double volume = kPi * radius * radius * (2.0 * halfHeight + 4.0 / 3.0 * radius);
  return floatTurned(profile, 12, volume);
}

SurfaceMesh floatCone(double radius, double height) {
  const double half = 0.5 * height;
  const std::array<ProfilePoint, 4> profile{
      {{0.0, -half}, {radius, -half}, {0.5 * radius, 0.0}, {0.0, half}}};
  return floatTurned(profile, kRingSides, kPi / 3.0 * radius * radius * height);
}

// Of a tetrahedron with corners 0, a, b, c: V/20 (Σ r rᵀ + s sᵀ), s = Σ r.
Mat3 secondMoments(const SurfaceMesh& closed) {
  Mat3 sum = Mat3::Zero();
  const SurfaceMesh mesh = triangulated(closed);
  for (const Face& face : mesh.faces) {
    const Vec3 &a = mesh.corner(face, 0), &b = mesh.corner(face, 1), &c = mesh.corner(face, 2);
    const Vec3 s = a + b + c;
    sum += volumeOfTetrahedron(a, b, c) / 20.0 *
           (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  return sum;
}

double overlapOf(std::span<const SurfaceMesh> convex) {
  if (convex.size() < 2) return 0.0;
  double shared = 0.0, all = 0.0;
  std::vector<Bounds> boxes;
  for (const SurfaceMesh& mesh : convex) boxes.push_back(bounds(mesh));
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Bounds& box = boxes[i];
    const Vec3 cell = (box.high - box.low) / kLattice;
    int inside = 0, twice = 0;
    for (int n = 0; n < kLattice * kLattice * kLattice; ++n) {
      const int row = n / kLattice, layer = row / kLattice;
      const Vec3 part(n % kLattice, row % kLattice, layer);
      const Vec3 point = box.low + (part + Vec3::Constant(0.5)).cwiseProduct(cell);
      if (!encloses(convex[i], point)) continue;
      ++inside;
      for (std::size_t j = 0; j < convex.size(); ++j) {
        if (j == i || !within(boxes[j], point) || !encloses(convex[j], point)) continue;
        ++twice;
        break;
      }
    }
    const double volume = volumeIntegrals(convex[i]).volume;
    all += volume;
    shared += inside > 0 ? volume * twice / inside : 0.0;
  }
  return all > 0.0 ? shared / all : 0.0;
}

}  // namespace cutwater
