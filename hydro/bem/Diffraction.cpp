#include "hydro/bem/Diffraction.h"

namespace cutwater {

std::vector<CVec6> diffraction(const SymmetricSystem<Complex>& system, const ModeNormals& normals,
                               const std::vector<IncidentVelocity>& waves, double omega,
                               double density) {
  const Complex factor(0.0, omega * density);
  const auto count = static_cast<Eigen::Index>(waves.size());
  Eigen::MatrixXcd forces = Eigen::MatrixXcd::Zero(6, count);
  for (const Parity parity : normals.parities()) {
    Eigen::MatrixXcd v(normals.n.rows(), count);
    for (Eigen::Index h = 0; h < count; ++h) {
      const IncidentVelocity& wave = waves[static_cast<std::size_t>(h)];
      v.col(h) = parity == Parity::Even ? wave.even : wave.odd;
    }
    forces(normals.modes(parity), Eigen::all) =
        factor * (normals.weights(parity).transpose() * system.potentials(parity, v));
  }
  std::vector<CVec6> result;
  for (Eigen::Index h = 0; h < count; ++h) result.emplace_back(forces.col(h));
  return result;
}

CVec6 diffraction(const SymmetricSystem<Complex>& system, const ModeNormals& normals,
                  const IncidentVelocity& v, double omega, double density) {
  return diffraction(system, normals, std::vector{v}, omega, density).front();
}

Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectors(const SymmetricSystem<Complex>& system,
                                                         const ModeNormals& normals,
                                                         double density) {
  // The weights of a symmetric hull already hold the factor 2 that Coefficients::adjoint leaves to
  // v.
  const Complex factor(0.0, density * (normals.symmetric ? 0.5 : 1.0));
  Eigen::Matrix<Complex, 6, Eigen::Dynamic> b(6, normals.n.rows());
  for (int p = 0; p < system.parities(); ++p) {
    const auto parity = static_cast<Parity>(p);
    b(normals.modes(parity), Eigen::all) =
        factor * system.adjoints(parity, normals.weights(parity).cast<Complex>()).transpose();
  }
  return b;
}

}  // namespace cutwater
