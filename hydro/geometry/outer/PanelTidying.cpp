#include "hydro/geometry/outer/PanelTidying.h"

#include <algorithm>
#include <map>
#include <optional>

namespace cutwater {
namespace {

constexpr double kSliver = 0.12;  // height of a triangle over its longest edge
// A quadrilateral with a straight corner is as good as a triangle: only what folds is divided.
constexpr double kFolded = -1e-3;
constexpr int kTidyings = 6;

using Corners = std::vector<int>;

const Vec3& point(const SurfaceMesh& mesh, int v) {
  return mesh.vertices[static_cast<std::size_t>(v)];
}

Vec3 areaOf(const SurfaceMesh& mesh, int a, int b, int c) {
  return 0.5 * (point(mesh, b) - point(mesh, a)).cross(point(mesh, c) - point(mesh, a));
}

/// Smallest height over longest edge, of triangles turned with the whole; negative if one is not.
double goodness(const SurfaceMesh& mesh, const Vec3& whole, int a, int b, int c) {
  const Vec3 area = areaOf(mesh, a, b, c);
  const double longest2 = std::max({(point(mesh, b) - point(mesh, a)).squaredNorm(),
                                    (point(mesh, c) - point(mesh, b)).squaredNorm(),
                                    (point(mesh, a) - point(mesh, c)).squaredNorm()});
  if (longest2 == 0.0) return 0.0;
  return (area.dot(whole) < 0 ? -2.0 : 2.0) * area.norm() / longest2;
}

/// The worst of the triangles into which corners fall when cut from corner i.
double fanGoodness(const SurfaceMesh& mesh, const Corners& c, std::size_t i) {
  const std::size_t n = c.size();
  Vec3 whole = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < n; ++k) whole += areaOf(mesh, c[0], c[k], c[k + 1]);
  double worst = 1.0;
  for (std::size_t k = 1; k + 1 < n; ++k)
    worst = std::min(worst, goodness(mesh, whole, c[i], c[(i + k) % n], c[(i + k + 1) % n]));
  return worst;
}

Face faceOf(int a, int b, int c, int d = -1) { return {{a, b, c, d}}; }

/// Three to five corners as faces, convex ones where that is possible.
void addPolygon(const SurfaceMesh& mesh, const Corners& c, std::vector<Face>& out) {
  const std::size_t n = c.size();
  if (n == 3) {
    out.push_back(faceOf(c[0], c[1], c[2]));
  } else if (n == 4) {
    const double even = fanGoodness(mesh, c, 0), odd = fanGoodness(mesh, c, 1);
    if (std::min(even, odd) > kFolded) {
      out.push_back(faceOf(c[0], c[1], c[2], c[3]));
    } else if (even >= odd) {
      out.push_back(faceOf(c[0], c[1], c[2]));
      out.push_back(faceOf(c[0], c[2], c[3]));
    } else {
      out.push_back(faceOf(c[1], c[2], c[3]));
      out.push_back(faceOf(c[1], c[3], c[0]));
    }
  } else {
    // Cut off the corner that leaves the best quadrilateral.
    std::size_t best = 0;
    double most = -1e300;
    for (std::size_t i = 0; i < n; ++i) {
      const Corners rest{c[i], c[(i + 2) % n], c[(i + 3) % n], c[(i + 4) % n]};
      const Corners cut{c[i], c[(i + 1) % n], c[(i + 2) % n]};
      const double good = std::min(
          {fanGoodness(mesh, rest, 0), fanGoodness(mesh, rest, 1), fanGoodness(mesh, cut, 0)});
      if (good > most) most = good, best = i;
    }
    out.push_back(faceOf(c[best], c[(best + 1) % n], c[(best + 2) % n]));
    addPolygon(mesh, {c[best], c[(best + 2) % n], c[(best + 3) % n], c[(best + 4) % n]}, out);
  }
}

/// Corner of a triangle that lies nearly on the edge of the other two, or −1.
int cornerOnEdge(const SurfaceMesh& mesh, const Face& f) {
  if (f.size() != 3) return -1;
  int opposite = 0;
  double longest = -1.0;
  for (int i = 0; i < 3; ++i) {
    const double l = (mesh.corner(f, (i + 1) % 3) - mesh.corner(f, (i + 2) % 3)).norm();
    if (l > longest) longest = l, opposite = i;
  }
  const double height = 2 * vectorArea(mesh, f).norm() / longest;
  return height < kSliver * longest ? opposite : -1;
}

/// Whether these lie in calm water or in the centreplane, where surfaces may be open.
bool onOneBoundary(const SurfaceMesh& mesh, const Face& f) {
  bool water = true, centre = true;
  for (int i = 0; i < f.size(); ++i) {
    water = water && mesh.corner(f, i).z() == 0.0;
    centre = centre && mesh.corner(f, i).y() == 0.0;
  }
  return water || centre;
}

/// Corners between which the rim goes there and back are none.
Corners withoutSpikes(Corners c) {
  for (std::size_t i = 0; i < c.size() && c.size() > 2;) {
    const std::size_t next = (i + 1) % c.size(), after = (i + 2) % c.size();
    if (c[i] != c[after]) {
      ++i;
      continue;
    }
    c.erase(c.begin() + static_cast<std::ptrdiff_t>(std::max(next, after)));
    c.erase(c.begin() + static_cast<std::ptrdiff_t>(std::min(next, after)));
    i = 0;
  }
  return c;
}

/// One round: no face is changed twice in it.
class SliverRemoval {
 public:
  explicit SliverRemoval(const SurfaceMesh& mesh)
      : mesh_(mesh), grown_(mesh.faces.size()), gone_(mesh.faces.size(), false) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (int i = 0; i < mesh.faces[f].size(); ++i)
        faceAt_[{mesh.faces[f][i], mesh.faces[f][(i + 1) % mesh.faces[f].size()]}] = f;
  }

  SurfaceMesh removed() {
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      if (gone_[f] || grown_[f]) continue;
      if (onOneBoundary(mesh_, mesh_.faces[f])) gone_[f] = true;
      const int corner = gone_[f] ? -1 : cornerOnEdge(mesh_, mesh_.faces[f]);
      if (corner >= 0) giveToNeighbour(f, corner);
    }
    SurfaceMesh out{mesh_.vertices, {}};
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      if (gone_[f]) continue;
      if (grown_[f]) {
        addPolygon(mesh_, *grown_[f], out.faces);
      } else {
        out.faces.push_back(mesh_.faces[f]);
      }
    }
    return out;
  }

 private:
  void giveToNeighbour(std::size_t f, int corner) {
    const Face& s = mesh_.faces[f];
    const int from = s[(corner + 1) % 3], to = s[(corner + 2) % 3], middle = s[corner];
    const auto across = faceAt_.find({to, from});
    if (across == faceAt_.end()) return;
    const std::size_t g = across->second;
    if (gone_[g] || grown_[g]) return;
    Corners c;
    for (int i = 0; i < mesh_.faces[g].size(); ++i) {
      c.push_back(mesh_.faces[g][i]);
      if (mesh_.faces[g][i] == to) c.push_back(middle);
    }
    c = withoutSpikes(std::move(c));
    if (std::count(c.begin(), c.end(), middle) > 1) return;
    gone_[f] = true;
    if (c.size() >= 3) {
      grown_[g] = std::move(c);
    } else {
      gone_[g] = true;  // they lay back to back
    }
  }

  const SurfaceMesh& mesh_;
  std::map<std::pair<int, int>, std::size_t> faceAt_;
  std::vector<std::optional<Corners>> grown_;
  std::vector<bool> gone_;
};

/// Faces without the vertices at which only two of them meet; a triangle between two such edges
/// goes. Vertices on an open edge stay.
SurfaceMesh withoutNeedles(const SurfaceMesh& mesh) {
  std::vector<int> faces(mesh.vertices.size(), 0);
  for (const Face& f : mesh.faces)
    for (int i = 0; i < f.size(); ++i) ++faces[static_cast<std::size_t>(f[i])];
  constexpr int kStays = 1000;
  for (const OpenEdge& e : openEdges(mesh))
    for (const int v : {e.from, e.to}) faces[static_cast<std::size_t>(v)] = kStays;
  SurfaceMesh out{mesh.vertices, {}};
  for (const Face& f : mesh.faces) {
    Face left;
    std::size_t n = 0;
    for (int i = 0; i < f.size(); ++i)
      if (faces[static_cast<std::size_t>(f[i])] != 2) left.v[n++] = f[i];
    if (n >= 3) out.faces.push_back(left);
  }
  return out;
}

SurfaceMesh withoutFoldedFaces(const SurfaceMesh& mesh) {
  SurfaceMesh out{mesh.vertices, {}};
  for (const Face& f : mesh.faces)
    addPolygon(mesh, Corners(f.v.begin(), f.v.begin() + f.size()), out.faces);
  return out;
}

}  // namespace

std::vector<Face> withoutFolds(const std::vector<Face>& faces) {
  std::vector<std::pair<std::array<int, 4>, std::size_t>> keys;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::array<int, 4> key = faces[f].v;
    std::sort(key.begin(), key.end());
    keys.emplace_back(key, f);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> gone(faces.size(), false);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    if (keys[i].first != keys[i + 1].first) continue;
    gone[keys[i].second] = gone[keys[i + 1].second] = true;
    ++i;
  }
  std::vector<Face> kept;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (!gone[f]) kept.push_back(faces[f]);
  return kept;
}

std::vector<Face> tidied(const SurfaceMesh& panels) {
  SurfaceMesh mesh = withoutFoldedFaces(withoutNeedles(panels));
  for (int round = 0; round < kTidyings; ++round) {
    mesh = withoutNeedles(SliverRemoval(mesh).removed());
    mesh.faces = withoutFolds(mesh.faces);
  }
  return mesh.faces;
}

}  // namespace cutwater
