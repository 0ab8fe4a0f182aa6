#include "tests/verification/free_ship/FreeFrigate.h"

#include <cmath>

#include "hydro/forces/FreeResponse.h"

namespace cutwater::test {

std::shared_ptr<const Hydrodynamics> coarseFrigate() {
  static const auto frigate = readHydrodynamics(CUTWATER_SOLVED "/frigate.h5");
  return frigate;
}

ShipSettings freeShip(double speed, bool hullLift) {
  ShipSettings settings;
  settings.start.speed = speed;
  settings.model.mode = HullPressure::Linear;
  settings.model.hullLift = hullLift;
  settings.model.resistance = false;
  return settings;
}

OneShip::OneShip(std::shared_ptr<const Hydrodynamics> hydrodynamics, const SeaState& sea,
                 const ShipSettings& settings, double gravity)
    : bullet(gravity),
      seaway(bullet.world, sea),
      ship(seaway.addShip(std::move(hydrodynamics), settings)) {}

double steadyEnergy(const Hydrodynamics& hydrodynamics, const Vec6& velocity) {
  const Mat6 mass =
      hydrodynamics.ship().massMatrix() + hydrodynamics.freeResponse().addedMassAtRest();
  return 0.5 * velocity.dot(mass * velocity);
}

Vec6 steadyWay(double ahead, double leeway, double turn) {
  Vec6 velocity = Vec6::Zero();
  velocity[Surge] = ahead;
  velocity[Sway] = leeway;
  velocity[Yaw] = turn;
  return velocity;
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& values) {
  const Eigen::VectorXd size = rows.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-9);
  solver.compute(rows * size.asDiagonal());
  return size.asDiagonal() * Eigen::MatrixXd(solver.solve(values));
}

double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::vector<double> above(double omega, double step, const std::vector<double>& values) {
  const int reach = static_cast<int>(std::lround(200.0 / step));
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i) {
    const double t = i * step, place = kPi * i / reach;
    const double sinc = i == 0 ? omega / kPi : std::sin(omega * t) / (kPi * t);
    weights.push_back(sinc * (0.42 + 0.5 * std::cos(place) + 0.08 * std::cos(2.0 * place)));
    sum += weights.back();
  }
  std::vector<double> kept;
  const std::size_t length = weights.size(), middle = static_cast<std::size_t>(reach);
  for (std::size_t i = 0; i + length <= values.size(); ++i) {
    double slow = 0.0;
    for (std::size_t m = 0; m < length; ++m) slow += weights[m] * values[i + m];
    kept.push_back(values[i + middle] - slow / sum);
  }
  return kept;
}

}  // namespace cutwater::test
