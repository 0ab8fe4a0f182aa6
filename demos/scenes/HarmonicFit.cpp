#include "demos/scenes/HarmonicFit.h"

#include <Eigen/Dense>
#include <cmath>

namespace cutwater::command {

HarmonicFit harmonicFit(const std::vector<double>& phase, const std::vector<double>& time,
                        const std::vector<double>& value) {
  const double middle = 0.5 * (time.front() + time.back());
  const double half = std::max(0.5 * (time.back() - time.front()), 1e-12);
  const auto row = [&](std::size_t i) {
    return Eigen::Vector4d(1.0, (time[i] - middle) / half, std::cos(phase[i]), -std::sin(phase[i]));
  };
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < time.size(); ++i) {
    normal += row(i) * row(i).transpose();
    right += row(i) * value[i];
  }
  const Eigen::Vector4d fit = normal.ldlt().solve(right);
  double squares = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double left = value[i] - fit.dot(row(i));
    squares += left * left;
  }
  const double slope = fit[1] / half;
  return {Complex(fit[2], fit[3]), fit[0] - slope * middle, slope,
          std::sqrt(squares / static_cast<double>(time.size()))};
}

}  // namespace cutwater::command
