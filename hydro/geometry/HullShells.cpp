#include "hydro/geometry/HullShells.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshCut.h"
#include "hydro/geometry/MeshIntegrals.h"
#include "hydro/geometry/PlaceText.h"
#include "hydro/geometry/SurfacePatches.h"

namespace cutwater {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Face turned(Face face, bool over) {
  if (over) std::reverse(face.v.begin(), face.v.begin() + face.size());
  return face;
}

/// The faces of a patch in the order of the mesh, turned to agree, with vertices of their own.
SurfaceMesh meshOf(const SurfaceMesh& mesh, const SurfacePatch& patch) {
  SurfaceMesh out;
  std::map<int, int> newIndex;
  for (std::size_t i = 0; i < patch.faces.size(); ++i) {
    Face f = turned(mesh.faces[index(patch.faces[i])], patch.turned[i]);
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
        throw HydroError(Fault::HullPartHidden,
                         name + ": one piece of the hull lies inside another, at " + placeText(p) +
                             "; give the outer surface alone");
    }
  }
}

}  // namespace

void checkVertices(const SurfaceMesh& raw, const std::string& name) {
  if (raw.vertices.empty() || raw.faces.empty())
    throw HydroError(Fault::MeshEmpty,
                     name + ": no faces (" + std::to_string(raw.vertices.size()) + " vertices)");
  for (std::size_t i = 0; i < raw.vertices.size(); ++i)
    if (!raw.vertices[i].allFinite())
      throw HydroError(Fault::MeshNotFinite, name + ": vertex " + std::to_string(i) + " is " +
                                                 placeText(raw.vertices[i]));
  const int n = static_cast<int>(raw.vertices.size());
  for (std::size_t k = 0; k < raw.faces.size(); ++k)
    for (int i = 0; i < raw.faces[k].size(); ++i)
      if (const int v = raw.faces[k][i]; v < 0 || v >= n)
        throw HydroError(Fault::MeshIndexOutOfRange, name + ": face " + std::to_string(k) +
                                                         " names vertex " + std::to_string(v) +
                                                         " of " + std::to_string(n));
}

void checkInWater(const Bounds& b, const std::string& name) {
  const double tolerance = kSnap * b.diagonal();
  const std::string range =
      "z from " + std::to_string(b.low.z()) + " to " + std::to_string(b.high.z()) + " m";
  if (b.low.z() >= -tolerance)
    throw HydroError(Fault::HullNotInWater, name + ": hull is wholly above calm water, " + range);
  if (b.high.z() < -tolerance)
    throw HydroError(Fault::HullNotInWater, name + ": hull is wholly below calm water, " + range);
}

SurfaceMesh snapped(SurfaceMesh mesh, int axis, double tolerance) {
  for (Vec3& p : mesh.vertices)
    if (std::abs(p[axis]) <= tolerance) p[axis] = 0.0;
  return mesh;
}

SurfaceMesh withMirrorImage(const SurfaceMesh& half) {
  SurfaceMesh kept{half.vertices, {}};
  for (const Face& f : half.faces) {
    double widest = 0.0;
    for (int i = 0; i < f.size(); ++i) widest = std::max(widest, std::abs(half.corner(f, i).y()));
    if (widest > 0.0) kept.faces.push_back(f);
  }
  return welded(joined(kept, mirroredInY(kept)), 0.0);
}

SurfaceMesh withoutDoubles(const SurfaceMesh& mesh) {
  using Key = std::pair<std::array<int, 4>, std::size_t>;  // corners, index
  std::vector<Key> keys;
  for (std::size_t k = 0; k < mesh.faces.size(); ++k) {
    keys.emplace_back(mesh.faces[k].v, k);
    std::sort(keys.back().first.begin(), keys.back().first.end());
  }
  std::sort(keys.begin(), keys.end());
  const auto last = std::unique(keys.begin(), keys.end(),
                                [](const Key& a, const Key& b) { return a.first == b.first; });
  std::vector<bool> kept(mesh.faces.size(), false);
  std::for_each(keys.begin(), last, [&](const Key& key) { kept[key.second] = true; });
  SurfaceMesh out{mesh.vertices, {}};
  for (std::size_t k = 0; k < mesh.faces.size(); ++k)
    if (kept[k]) out.faces.push_back(mesh.faces[k]);
  return out;
}

SurfaceMesh turnedOutwards(const SurfaceMesh& mesh, const std::string& name) {
  SurfaceMesh out = mesh;
  std::vector<SurfaceMesh> closed;
  const double size = bounds(mesh).diagonal();
  for (const SurfacePatch& patch : surfacePatches(mesh, name)) {
    SurfaceMesh part = meshOf(mesh, patch);
    const double volume = tellingVolume(part);
    const bool inWater = bounds(part).low.z() < 0;
    // Below 1e-12 of the cube of its size the sign is round-off.
    if (inWater && std::abs(volume) <= 1e-12 * size * size * size)
      throw HydroError(Fault::HullInverted,
                       name + ": a piece of " + std::to_string(part.faces.size()) +
                           " faces encloses no volume, so its outside cannot be inferred; at " +
                           placeText(part.vertices[0]));
    const bool inverted = volume < 0;
    if (inverted) part = turnedOver(part);
    for (std::size_t i = 0; i < patch.faces.size(); ++i) {
      Face& face = out.faces[index(patch.faces[i])];
      face = turned(face, patch.turned[i] != inverted);
    }
    if (openEdges(part).empty()) closed.push_back(std::move(part));
  }
  refuseNested(closed, name);
  return out;
}

}  // namespace cutwater
