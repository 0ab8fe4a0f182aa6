#pragma once
#include "hydro/bem/solution/Diffraction.h"
#include "hydro/geometry/panels/Lid.h"
#include "hydro/geometry/panels/SolverPanels.h"
#include "hydro/geometry/shapes/Shapes.h"

namespace cutwater::test {

inline constexpr double kGravity = 9.80665;

/// Panels of a wet surface with its lid, or without.
inline PanelMesh panels(const SurfaceMesh& wet, bool symmetric, bool lid,
                        PanelShape shape = PanelShape::Flat) {
  PanelMesh mesh = solverPanels(wet, symmetric, shape);
  if (lid) mesh.lid = makeLid(wet, symmetric);
  return mesh;
}

/// The same hull panels, port and starboard, as a hull without symmetry.
inline PanelMesh bothSides(const PanelMesh& port) {
  PanelMesh whole = port;
  whole.symmetric = false;
  for (const Panel& panel : port.panels) {
    std::vector<Vec3> corners(panel.corner.rend() - panel.corners, panel.corner.rend());
    for (Vec3& corner : corners) corner.y() *= -1.0;
    whole.panels.push_back(flatPanel(corners));
  }
  return whole;
}

inline SymmetricSystem<Complex> systemAt(const InfluenceMatrices& matrices, double K) {
  return {matrices.atWaveNumber(K), matrices.parities()};
}

inline SymmetricSystem<double> systemAt(const InfluenceMatrices& matrices, FrequencyLimit limit) {
  std::array<InfluenceSystem<double>, 2> pairs;
  for (int p = 0; p < matrices.parities(); ++p)
    pairs[static_cast<std::size_t>(p)] = matrices.atLimit(limit, static_cast<Parity>(p));
  return {std::move(pairs), matrices.parities()};
}

/// F_D at U = 0, crest over G.
inline CVec6 solvedDiffraction(const SymmetricSystem<Complex>& system, const ModeNormals& normals,
                               const IncidentVelocity& v, double omega, double density) {
  return omega * diffraction(system, normals, std::vector{v}, density).front().omega;
}

/// Z = A − iB/ω of unit density: real part added mass, imaginary part −B/ω.
template <typename Where>
auto impulse(const InfluenceMatrices& matrices, const ModeNormals& normals, Where where) {
  return impulseMatrix(radiationPotentials(systemAt(matrices, where), normals), normals, 1.0);
}

}  // namespace cutwater::test
