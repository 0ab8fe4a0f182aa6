#include "hydro/geometry/MeshEdges.h"

#include <algorithm>

namespace cutwater {

std::vector<EdgeUse> edgeUses(const SurfaceMesh& mesh) {
  std::vector<EdgeUse> uses;
  for (int k = 0; k < static_cast<int>(mesh.faces.size()); ++k) {
    const Face& f = mesh.faces[static_cast<std::size_t>(k)];
    for (int i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      uses.push_back({static_cast<std::uint64_t>(std::min(a, b)) << 32 |
                          static_cast<std::uint64_t>(std::max(a, b)),
                      k, a < b});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::pair(a.edge, a.face) < std::pair(b.edge, b.face);
  });
  return uses;
}

std::vector<OpenEdge> looseEdges(const SurfaceMesh& mesh) {
  const std::vector<EdgeUse> uses = edgeUses(mesh);
  std::vector<OpenEdge> loose;
  for (std::size_t i = 0, next = 0; i < uses.size(); i = next) {
    next = i + 1;
    while (next < uses.size() && uses[next].edge == uses[i].edge) ++next;
    if ((next - i) % 2 == 0) continue;
    const int low = static_cast<int>(uses[i].edge >> 32),
              high = static_cast<int>(uses[i].edge & 0xffffffffu);
    loose.push_back({uses[i].rising ? low : high, uses[i].rising ? high : low, uses[i].face});
  }
  return loose;
}

}  // namespace cutwater
