#include "hydro/geometry/HullShells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"

namespace cutwater {
namespace {

using EdgeKey = std::pair<int, int>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Which faces meet at each edge, and in which sense they run along it.
class Neighbours {
 public:
  explicit Neighbours(const SurfaceMesh& mesh) {
    for (int k = 0; k < static_cast<int>(mesh.faces.size()); ++k) {
      const Face& f = mesh.faces[index(k)];
      for (int i = 0; i < f.size(); ++i) {
        const int a = f[i], b = f[(i + 1) % f.size()];
        uses_[{std::min(a, b), std::max(a, b)}].push_back({k, a < b});
      }
    }
  }

  /// Calls visit(neighbour, agrees) for faces across edges that exactly two faces share.
  template <class Visit>
  void across(const Face& f, int face, Visit visit) const {
    for (int i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      const auto& both = uses_.at({std::min(a, b), std::max(a, b)});
      if (both.size() != 2) continue;
      const auto& other = both[0].face == face ? both[1] : both[0];
      visit(other.face, both[0].rising != both[1].rising);
    }
  }

 private:
  struct Use {
    int face;
    bool rising;
  };
  std::map<EdgeKey, std::vector<Use>> uses_;
};

/// Faces that hang together, with the sense that makes them agree with the first: +1 or −1.
struct Piece {
  std::vector<int> faces;
  std::vector<int> sense;
};

std::vector<Piece> pieces(const SurfaceMesh& mesh, const std::string& name) {
  const Neighbours neighbours(mesh);
  std::vector<int> sense(mesh.faces.size(), 0);
  std::vector<Piece> all;
  for (int first = 0; first < static_cast<int>(mesh.faces.size()); ++first) {
    if (sense[index(first)] != 0) continue;
    Piece piece;
    std::vector<int> todo{first};
    sense[index(first)] = 1;
    while (!todo.empty()) {
      const int k = todo.back();
      todo.pop_back();
      piece.faces.push_back(k);
      neighbours.across(mesh.faces[index(k)], k, [&](int other, bool agrees) {
        const int wanted = agrees ? sense[index(k)] : -sense[index(k)];
        if (sense[index(other)] == 0) {
          sense[index(other)] = wanted;
          todo.push_back(other);
        } else if (sense[index(other)] != wanted) {
          throw HydroError(Fault::HullInverted,
                           name +
                               ": the surface is one-sided, its faces cannot all be turned "
                               "outwards; first seen at " +
                               placeText(mesh.corner(mesh.faces[index(k)], 0)));
        }
      });
    }
    std::sort(piece.faces.begin(), piece.faces.end());
    for (int k : piece.faces) piece.sense.push_back(sense[index(k)]);
    all.push_back(piece);
  }
  return all;
}

Face turned(const SurfaceMesh& mesh, int face, int sense) {
  Face f = mesh.faces[index(face)];
  if (sense < 0) std::reverse(f.v.begin(), f.v.begin() + f.size());
  return f;
}

SurfaceMesh meshOf(const SurfaceMesh& mesh, const Piece& piece) {
  SurfaceMesh out;
  std::map<int, int> newIndex;
  for (std::size_t i = 0; i < piece.faces.size(); ++i) {
    Face f = turned(mesh, piece.faces[i], piece.sense[i]);
    for (int c = 0; c < f.size(); ++c) {
      const auto [it, isNew] = newIndex.emplace(f[c], static_cast<int>(out.vertices.size()));
      if (isNew) out.vertices.push_back(mesh.corner(f, c));
      f.v[index(c)] = it->second;
    }
    out.faces.push_back(f);
  }
  return out;
}

/// Volume whose sign tells outside from inside: of the piece itself if closed, of its part below
/// water if open there at the waterline or centreline only; 0 for an open piece above water.
double tellingVolume(const SurfaceMesh& piece) {
  if (openEdges(piece).empty()) return volumeIntegrals(piece).volume;
  return volumeIntegrals(cutBelow(piece)).volume;
}

/// Solid angle of a closed surface seen from p, over 4π: 1 inside, 0 outside.  [Van Oosterom &
/// Strackee 1983]
double windingNumber(const SurfaceMesh& mesh, const Vec3& p) {
  double angle = 0.0;
  for (const Face& f : mesh.faces)
    for (int i = 1; i + 1 < f.size(); ++i) {
      const Vec3 a = mesh.corner(f, 0) - p, b = mesh.corner(f, i) - p,
                 c = mesh.corner(f, i + 1) - p;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      const double bottom = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
      angle += 2 * std::atan2(a.dot(b.cross(c)), bottom);
    }
  return angle / (4 * kPi);
}

void refuseNested(const std::vector<SurfaceMesh>& closed, const std::string& name) {
  for (const SurfaceMesh& outer : closed) {
    const Bounds box = bounds(outer);
    for (const SurfaceMesh& inner : closed) {
      const Vec3& p = inner.vertices[0];
      if (&inner == &outer || (p - box.low).minCoeff() <= 0 || (box.high - p).minCoeff() <= 0)
        continue;
      if (windingNumber(outer, p) > 0.5)
        throw HydroError(Fault::HullNotClosed,
                         name + ": one piece of the hull lies inside another, at " + placeText(p) +
                             "; give the outer surface alone");
    }
  }
}

}  // namespace

std::string placeText(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x(), p.y(), p.z());
  return text;
}

SurfaceMesh withoutDoubles(const SurfaceMesh& mesh) {
  std::set<std::array<int, 4>> seen;
  SurfaceMesh out{mesh.vertices, {}};
  for (const Face& f : mesh.faces) {
    std::array<int, 4> corners = f.v;
    std::sort(corners.begin(), corners.end());
    if (seen.insert(corners).second) out.faces.push_back(f);
  }
  return out;
}

std::vector<OpenEdge> looseEdges(const SurfaceMesh& mesh) {
  std::map<EdgeKey, std::vector<OpenEdge>> uses;
  for (int k = 0; k < static_cast<int>(mesh.faces.size()); ++k) {
    const Face& f = mesh.faces[index(k)];
    for (int i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      uses[{std::min(a, b), std::max(a, b)}].push_back({a, b, k});
    }
  }
  std::vector<OpenEdge> loose;
  for (const auto& [edge, faces] : uses)
    if (faces.size() % 2 == 1) loose.push_back(faces[0]);
  return loose;
}

SurfaceMesh turnedOutwards(const SurfaceMesh& mesh, const std::string& name) {
  SurfaceMesh out = mesh;
  std::vector<SurfaceMesh> closed;
  const double size = bounds(mesh).diagonal();
  for (Piece piece : pieces(mesh, name)) {
    SurfaceMesh part = meshOf(mesh, piece);
    const double volume = tellingVolume(part);
    const bool inWater = bounds(part).low.z() < 0;
    // Below 1e-12 of the cube of its size the sign is round-off.
    if (inWater && std::abs(volume) <= 1e-12 * size * size * size)
      throw HydroError(Fault::HullInverted,
                       name + ": a piece of " + std::to_string(part.faces.size()) +
                           " faces encloses no volume, so its outside cannot be inferred; at " +
                           placeText(part.vertices[0]));
    if (volume < 0) {
      for (int& s : piece.sense) s = -s;
      part = turnedOver(part);
    }
    for (std::size_t i = 0; i < piece.faces.size(); ++i)
      out.faces[index(piece.faces[i])] = turned(mesh, piece.faces[i], piece.sense[i]);
    if (openEdges(part).empty()) closed.push_back(std::move(part));
  }
  refuseNested(closed, name);
  return out;
}

}  // namespace cutwater
