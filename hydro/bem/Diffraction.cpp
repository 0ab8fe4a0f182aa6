#include "hydro/bem/Diffraction.h"

namespace cutwater {

CVec6 diffraction(const SymmetricSystem<Complex>& system, const ModeNormals& normals,
                  const IncidentVelocity& v, double omega, double density) {
  const Complex factor(0.0, omega * density);
  CVec6 force = CVec6::Zero();
  for (int p = 0; p < system.parities(); ++p) {
    const auto parity = static_cast<Parity>(p);
    const auto phi = system.potentials(parity, parity == Parity::Even ? v.even : v.odd);
    force(normals.modes(parity)) = factor * (normals.weights(parity).transpose() * phi);
  }
  return force;
}

Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectors(const SymmetricSystem<Complex>& system,
                                                         const ModeNormals& normals, double omega,
                                                         double density) {
  // The weights of a symmetric hull already hold the factor 2 that Coefficients::adjoint leaves to
  // v.
  const Complex factor(0.0, omega * density * (normals.symmetric ? 0.5 : 1.0));
  Eigen::Matrix<Complex, 6, Eigen::Dynamic> b(6, normals.n.rows());
  for (int p = 0; p < system.parities(); ++p) {
    const auto parity = static_cast<Parity>(p);
    b(normals.modes(parity), Eigen::all) =
        factor * system.adjoints(parity, normals.weights(parity).cast<Complex>()).transpose();
  }
  return b;
}

}  // namespace cutwater
