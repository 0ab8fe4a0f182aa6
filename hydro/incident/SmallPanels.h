#pragma once
#include <vector>

#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/incident/IncidentWaveForce.h"

/// Waves on panels that are small against them, at less cost than IncidentWaveForce.h: for tables
/// of thousands of waves.
namespace cutwater {

/// What a panel's mean of a wave needs: to second order in its size over the wave length.
struct SmallPanel {
  Vec3 centre, normal;  ///< from G in plan, from calm water in height
  Vec3 flux;            ///< vector area of the surface for which it stands / area
  double area = 0.0;
  Eigen::Matrix3d spread;  ///< ∫(x − c)(x − c)ᵀ dS / area
  Vec3 arm;                ///< c − G
};

std::vector<SmallPanel> smallPanels(const PanelMesh& mesh, const Vec3& cog);

/// F_I per metre of amplitude, as froudeKrylovForce.
CVec6 froudeKrylovForce(const std::vector<SmallPanel>& panels, const AiryWave& wave, bool symmetric,
                        double density);

/// v of the diffracted wave, as of a PanelMesh.
IncidentVelocity incidentNormalVelocity(const std::vector<SmallPanel>& panels, const AiryWave& wave,
                                        bool symmetric);

}  // namespace cutwater
