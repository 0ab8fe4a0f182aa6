#pragma once
#include "hydro/geometry/panels/PanelMesh.h"

namespace cutwater {

/// A wave e^{κ·(x − origin)} integrated over a flat panel.
/// THEORY.md, chapter 3.
struct PanelWave {
  Complex sum;              ///< ∫ e^{κ·(x − origin)} dS [m²]
  Eigen::Vector3cd moment;  ///< ∫ (x − centroid) e^{κ·(x − origin)} dS [m³]
};

/// Exact for any wave length, by the divergence theorem in the panel's plane: with a·κ = 1, a in
/// the plane, and m_e the outward normals of the edges,
///     ∫ e^{κ·x} dS = Σ_e a·m_e ∫_e e^{κ·x} dl,
///     ∫ s e^{κ·x} dS = Σ_e a·m_e ∫_e s e^{κ·x} dl − a ∫ e^{κ·x} dS.
/// Where the panel is smaller than 0.05/|κ| that would cancel: 3 × 3 Gauss points there.
/// Error below 1e-9 of the panel's area, of the moment 1e-9 of area × size.
/// @param kappa [1/m]; of AiryWave: k(−i cos β, i sin β, 1).
PanelWave panelWave(const Panel& panel, const Eigen::Vector3cd& kappa, const Vec3& origin);

}  // namespace cutwater
