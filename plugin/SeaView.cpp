#include "plugin/SeaView.h"

#include <algorithm>
#include <cmath>

CUTWATER_PLUGIN_BEGIN

namespace {

constexpr std::size_t kPlacesAtOnce = 64;

}  // namespace

void SeaWatch::set(const std::shared_ptr<const SeaState>& sea, double time) noexcept {
  const std::lock_guard lock(mutex_);
  if (sea) sea_ = sea;
  time_ = time;
}

SeaWatch::Seen SeaWatch::seen() const noexcept {
  const std::lock_guard lock(mutex_);
  return {sea_, time_, frame_};
}

void SeaWatch::setLevel(double level) noexcept {
  const std::lock_guard lock(mutex_);
  frame_.seaLevel = level;
}

SeaView::SeaView(std::shared_ptr<const SeaWatch> watch)
    : watch_(std::move(watch)), motion_(SeaState()) {
  update();
}

void SeaView::update() {
  const SeaWatch::Seen seen = watch_->seen();
  time_ = seen.time;
  frame_ = seen.frame;
  if (seen.sea == sea_) return;
  sea_ = seen.sea;
  motion_ = WaterMotion(*sea_);
}

void SeaView::at(std::span<const btVector3> places, const Water& water, double density) noexcept {
  if (places.empty()) return;
  double x[kPlacesAtOnce], y[kPlacesAtOnce], z[kPlacesAtOnce], zeta[kPlacesAtOnce];
  double slope[2][kPlacesAtOnce], v[3][kPlacesAtOnce], head[kPlacesAtOnce];
  const Vec3 origin = frame_.placeToEarth(places.front());
  for (std::size_t first = 0; first < places.size(); first += kPlacesAtOnce) {
    const std::size_t count = std::min(kPlacesAtOnce, places.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 at = frame_.placeToEarth(places[first + i]);
      x[i] = at.x() - origin.x();
      y[i] = at.y() - origin.y();
      z[i] = at.z();
    }
    const auto part = [&](double* from, bool wanted) {
      return std::span<double>(from, wanted ? count : 0);
    };
    const bool normals = !water.normal.empty(), flows = !water.velocity.empty();
    motion_.at(
        time_, origin.x(), origin.y(), {{x, count}, {y, count}, {z, count}},
        {part(zeta, true), part(slope[0], normals), part(slope[1], normals), part(v[0], flows),
         part(v[1], flows), part(v[2], flows), part(head, !water.pressure.empty())});
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t to = first + i;
      if (!water.surface.empty())
        water.surface[to] = frame_.place({origin.x() + x[i], origin.y() + y[i], zeta[i]});
      if (normals)
        water.normal[to] = frame_.direction(Vec3(-slope[0][i], -slope[1][i], 1.0).normalized());
      if (flows) water.velocity[to] = frame_.length(Vec3(v[0][i], v[1][i], v[2][i]));
      if (!water.pressure.empty())
        water.pressure[to] = static_cast<btScalar>(density * sea_->gravity() * head[i]);
    }
  }
}

const std::vector<SeaView::Wave>& SeaView::waves(const btVector3& about) {
  waves_.clear();
  const Vec3 at = frame_.placeToEarth(about);
  const double unit = frame_.metresPerUnit;
  const double across = frame_.up == WorldFrame::Up::Z ? 1.0 : -1.0;  // of E's y on the world's
  for (std::size_t i = 0; i < sea_->components().size(); ++i) {
    const WaveComponent& wave = sea_->components()[i];
    const double k = sea_->waveNumber(i), growth = sea_->growth(i, time_);
    const double kx = k * std::cos(wave.heading), ky = -k * std::sin(wave.heading);
    const double phase = wave.omega * time_ - kx * at.x() - ky * at.y() + wave.phase;
    const auto add = [&](double harmonic, double amplitude) {
      waves_.push_back({static_cast<float>(harmonic * kx * unit),
                        static_cast<float>(harmonic * across * ky * unit),
                        static_cast<float>(amplitude / unit),
                        static_cast<float>(std::remainder(harmonic * phase, 2.0 * kPi))});
    };
    if (!sea_->stokes()) {
      add(1.0, growth * wave.amplitude);
      continue;
    }
    const auto series = sea_->stokes()->series(growth);
    for (std::size_t n = 0; n < StokesWave::kHarmonics; ++n)
      add(static_cast<double>(n + 1), series.elevation[n]);
  }
  return waves_;
}

CUTWATER_PLUGIN_END
