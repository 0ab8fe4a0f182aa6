#include "hydro/geometry/SurfacePatches.h"

#include <algorithm>
#include <cstdint>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshEdges.h"
#include "hydro/geometry/PlaceText.h"

namespace cutwater {
namespace {

/// What lies across one edge of a face, if one face does.
struct Crossing {
  int face, neighbour;
  bool agrees;
};

/// For each face its crossings, one after the other, and where they begin.
class Adjacency {
 public:
  Adjacency(const SurfaceMesh& mesh, int firstCut) : start_(mesh.faces.size() + 1, 0) {
    const std::vector<EdgeUse> uses = edgeUses(mesh);
    for (std::size_t i = 0, next = 0; i < uses.size(); i = next) {
      next = i + 1;
      while (next < uses.size() && uses[next].edge == uses[i].edge) ++next;
      // The lower vertex stands in the upper half.
      if (next - i != 2 || static_cast<int>(uses[i].edge >> 32) >= firstCut) continue;
      const EdgeUse &a = uses[i], &b = uses[i + 1];
      crossings_.push_back({a.face, b.face, a.rising != b.rising});
      crossings_.push_back({b.face, a.face, a.rising != b.rising});
    }
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.face < b.face; });
    for (const Crossing& c : crossings_) ++start_[static_cast<std::size_t>(c.face) + 1];
    for (std::size_t f = 1; f < start_.size(); ++f) start_[f] += start_[f - 1];
  }
  template <class Visit>
  void of(int face, Visit visit) const {
    const auto f = static_cast<std::size_t>(face);
    for (std::size_t i = start_[f]; i < start_[f + 1]; ++i) visit(crossings_[i]);
  }

 private:
  std::vector<Crossing> crossings_;
  std::vector<std::size_t> start_;
};

}  // namespace

std::vector<SurfacePatch> surfacePatches(const SurfaceMesh& mesh, const std::string& name,
                                         int firstCut) {
  const Adjacency adjacency(mesh, firstCut);
  std::vector<int> sense(mesh.faces.size(), 0);
  std::vector<SurfacePatch> patches;
  for (int first = 0; first < static_cast<int>(mesh.faces.size()); ++first) {
    if (sense[static_cast<std::size_t>(first)] != 0) continue;
    SurfacePatch patch;
    sense[static_cast<std::size_t>(first)] = 1;
    patch.faces.push_back(first);
    for (std::size_t done = 0; done < patch.faces.size(); ++done) {
      const int here = sense[static_cast<std::size_t>(patch.faces[done])];
      adjacency.of(patch.faces[done], [&](const Crossing& c) {
        const int wanted = c.agrees ? here : -here;
        int& there = sense[static_cast<std::size_t>(c.neighbour)];
        if (there == 0) {
          there = wanted;
          patch.faces.push_back(c.neighbour);
        } else if (there != wanted) {
          const Face& face = mesh.faces[static_cast<std::size_t>(c.face)];
          throw HydroError(Fault::HullInverted,
                           name +
                               ": the surface is one-sided, its faces cannot all be turned "
                               "outwards; first seen at " +
                               placeText(mesh.corner(face, 0)));
        }
      });
    }
    for (const int f : patch.faces) patch.turned.push_back(sense[static_cast<std::size_t>(f)] < 0);
    patches.push_back(std::move(patch));
  }
  return patches;
}

SurfaceMesh agreeing(SurfaceMesh mesh, const std::string& name) {
  for (const SurfacePatch& patch : surfacePatches(mesh, name)) {
    const auto face = [&](std::size_t i) -> Face& {
      return mesh.faces[static_cast<std::size_t>(patch.faces[i])];
    };
    double asIs = 0.0;
    for (std::size_t i = 0; i < patch.faces.size(); ++i)
      asIs += (patch.turned[i] ? -1.0 : 1.0) * vectorArea(mesh, face(i)).norm();
    for (std::size_t i = 0; i < patch.faces.size(); ++i)
      if (patch.turned[i] == (asIs > 0))
        std::reverse(face(i).v.begin(), face(i).v.begin() + face(i).size());
  }
  return mesh;
}

}  // namespace cutwater
