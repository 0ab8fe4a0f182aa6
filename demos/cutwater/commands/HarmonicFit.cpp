#include "demos/cutwater/commands/HarmonicFit.h"

#include <Eigen/Dense>
#include <cmath>

namespace cutwater::command {

Complex harmonicFit(double omega, const std::vector<double>& time,
                    const std::vector<double>& value) {
  const double middle = 0.5 * (time.front() + time.back());
  const double half = std::max(0.5 * (time.back() - time.front()), 1e-12);
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double phase = omega * time[i];
    const Eigen::Vector4d row(1.0, (time[i] - middle) / half, std::cos(phase), -std::sin(phase));
    normal += row * row.transpose();
    right += row * value[i];
  }
  const Eigen::Vector4d fit = normal.ldlt().solve(right);
  return {fit[2], fit[3]};
}

}  // namespace cutwater::command
