#include "hydro/bem/matrices/PanelPairs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

/// Relative error allowed to n × n points on a wave at calm water. Below, waves fade as e^{−Y}, but
/// what deep panels make of short waves nearly cancels: only √ of it counts. Frigate, 433 panels a
/// side, up to 4.2 rad/s: from 0.01 to 0.004 heave damping moves by 3 %, the others by less than
/// 1 %; with e^{−Y} in full and 0.002 it is off by half.
constexpr double kWaveError = 0.005;

/// n Gauss points on ∫ e^{iθs} ds, s = −1..1, are off by θ²ⁿ times this, leading term.
constexpr std::array<double, PanelPairs::kMostPoints - 1> kGaussError{1.0 / 6.0, 1.0 / 270.0,
                                                                      1.0 / 31500.0};

/// Of the 7 points of degree 5 the same for θ⁶, waves along the diagonal, where they are worst.
constexpr double kSevenPointError = 1.0 / 12500.0;

double top(const Panel& panel) {
  double z = panel.corner[0].z();
  for (int i = 1; i < panel.corners; ++i)
    z = std::max(z, panel.corner[static_cast<std::size_t>(i)].z());
  return std::min(z, 0.0);
}

/// 1, 4, 9 → 1, 2, 3.
int perSide(const char* name, int points) {
  if (points != 1 && points != 4 && points != 9)
    throw HydroError(Fault::BadArgument,
                     std::string(name) + " = " + std::to_string(points) + ", not 1, 4 or 9");
  return points == 1 ? 1 : points == 4 ? 2 : 3;
}

}  // namespace

PanelPairs::PanelPairs(PanelMesh mesh, const InfluenceSettings& settings)
    : mesh_(std::move(mesh)),
      settings_(settings),
      hull_(static_cast<int>(mesh_.panels.size())),
      all_(hull_ + static_cast<int>(mesh_.lid.size())),
      galerkin_(perSide("galerkin_points", settings.galerkinPoints)),
      fixedPoints_(settings.sourcePoints == 0 ? 0
                                              : perSide("source_points", settings.sourcePoints)),
      panels_(mesh_.panels) {
  if (settings.xDerivative && !isSource())
    throw HydroError(Fault::BadArgument, "derivatives = \"source\" needs formulation = \"source\"");
  panels_.insert(panels_.end(), mesh_.lid.begin(), mesh_.lid.end());
  for (const Panel& panel : panels_) {
    size_.push_back(diameter(panel));
    top_.push_back(top(panel));
    moments_.emplace_back(panel);
    centroid_.push_back({{panel.centroid, panel.area}});
    seven_.push_back(sevenPoints(panel));
    points_.emplace_back();
    for (int n = 1; n <= kMostPoints; ++n)
      points_.back()[static_cast<std::size_t>(n - 1)] = panelQuadrature(panel, n);
  }
}

Vec3 PanelPairs::direction(const Pair& pair) const {
  if (!isSource()) return panel(pair.source).normal;
  const Vec3 n = imageInY(panel(pair.field).normal, pair.mirrored);
  return {-n.x(), -n.y(), n.z()};
}

bool PanelPairs::isNear(const Pair& pair) const {
  const Vec3 apart =
      imageInZ(imageInY(panel(pair.field).centroid, pair.mirrored)) - panel(pair.source).centroid;
  const double reach = kNearRatio * std::max(size(pair.field), size(pair.source));
  return apart.squaredNorm() < reach * reach;
}

PanelPairs::WaveOn PanelPairs::waveOn(int from, int panel, double K) const {
  return {0.5 * K * size(panel), std::exp(0.5 * K *
                                          (panels_[static_cast<std::size_t>(from)].centroid.z() +
                                           top_[static_cast<std::size_t>(panel)]))};
}

int PanelPairs::pointsPerSide(int from, int panel, double K) const {
  if (fixedPoints_ > 0) return fixedPoints_;
  const WaveOn wave = waveOn(from, panel, K);
  double error = wave.size;
  for (int n = 1; n < kMostPoints; ++n) {
    error *= wave.theta * wave.theta;
    if (error * kGaussError[static_cast<std::size_t>(n - 1)] < kWaveError) return n;
  }
  return kMostPoints;
}

const std::vector<QuadraturePoint>& PanelPairs::fewPoints(int from, int panel, double K) const {
  const auto& seven = seven_[static_cast<std::size_t>(panel)];
  if (this->panel(panel).corners == 3) return seven;
  const WaveOn wave = waveOn(from, panel, K);
  const double square = wave.theta * wave.theta, fourth = wave.size * square * square;
  if (fourth * kGaussError[1] < kWaveError) return points(panel, 2);
  return fourth * square * kSevenPointError < kWaveError ? seven : points(panel, 3);
}

int PanelPairs::fieldPointsPerSide(const Pair& pair, double K) const {
  if (galerkin_ == 1) return 1;
  return std::min(2, pointsPerSide(pair.source, pair.field, K));
}

}  // namespace cutwater
