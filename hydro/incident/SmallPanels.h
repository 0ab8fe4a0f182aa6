#pragma once
#include <array>
#include <vector>

#include "hydro/geometry/panels/PanelMesh.h"
#include "hydro/incident/IncidentWaveForce.h"

namespace cutwater {

/// Waves on panels that are small against them, at less cost than IncidentWaveForce.h: for tables
/// of thousands of waves. A panel's mean of a wave is taken to second order in its size over the
/// wave length, of four panels at once.
/// THEORY.md, chapter 3.
class SmallPanels {
 public:
  SmallPanels() = default;
  SmallPanels(const PanelMesh& mesh, const Vec3& cog);

  /// F_I per metre of amplitude, as froudeKrylovForce.
  CVec6 froudeKrylovForce(const AiryWave& wave, double density) const;
  /// v of the diffracted wave, as incidentNormalVelocity.
  IncidentVelocity incidentNormalVelocity(const AiryWave& wave) const;

 private:
  /// Four panels; what there are too few of has no area.
  struct alignas(32) Four {
    double centre[3][4]{};  // from G in plan, from calm water in height [m]
    double normal[3][4]{};
    double flux[3][4]{};    // vector area of the surface for which it stands / area
    double spread[6][4]{};  // ∫(x − c)(x − c)ᵀ dS / area: xx, yy, zz, xy, xz, yz [m²]
    double arm[3][4]{};     // c − G [m]
    double area[4]{};       // [m²]
  };
  /// κ of e^{κ·x} = e^{i(k_x x + k_y y) + k z} [1/m].
  struct Wave {
    double kx, ky, kz;
  };
  static Wave waveOf(const AiryWave& wave);
  struct Means;
  static Means meansOf(const Four& panels, const Wave& wave);
  // Re, then Im, of the six modes.
  static std::array<double, 12> forces(const std::vector<Four>& panels, const Wave& wave);
  static void velocities(const std::vector<Four>& panels, const Wave& wave, double* re, double* im);

  std::vector<Four> fours_;
  std::size_t count_ = 0;
  bool symmetric_ = false;
};

}  // namespace cutwater
