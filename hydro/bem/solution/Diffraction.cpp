#include "hydro/bem/solution/Diffraction.h"

namespace cutwater {

std::vector<DiffractionParts> diffraction(const SymmetricSystem<Complex>& system,
                                          const ModeNormals& normals,
                                          const std::vector<IncidentVelocity>& waves,
                                          double density, const XDerivative* stokes) {
  const auto count = static_cast<Eigen::Index>(waves.size());
  const double sides = normals.symmetric ? 2.0 : 1.0;
  std::vector<DiffractionParts> forces(waves.size());
  for (const Parity parity : normals.parities()) {
    Eigen::MatrixXcd v(normals.n.rows(), count);
    for (Eigen::Index h = 0; h < count; ++h) {
      const IncidentVelocity& wave = waves[static_cast<std::size_t>(h)];
      v.col(h) = parity == Parity::Even ? wave.even : wave.odd;
    }
    const std::vector<int> modes = normals.modes(parity);
    const Eigen::MatrixXcd phi = system.potentials(parity, v);
    const Eigen::MatrixXcd omega =
        Complex(0.0, density) * (normals.weights(parity).transpose() * phi);
    Eigen::MatrixXcd speed = Eigen::MatrixXcd::Zero(omega.rows(), count);
    if (stokes != nullptr)
      speed = -density * sides *
              (normals.of(parity).transpose() *
               xIntegrals<Complex>(system, normals, *stokes, parity, v, phi));
    for (Eigen::Index h = 0; h < count; ++h) {
      forces[static_cast<std::size_t>(h)].omega(modes) = omega.col(h);
      forces[static_cast<std::size_t>(h)].speed(modes) = speed.col(h);
    }
  }
  return forces;
}

// The factor 2 of a symmetric hull, which the weights hold, is left to v.
template <typename Scalar>
AdjointVectors adjointVectors(const SymmetricSystem<Scalar>& system, const ModeNormals& normals,
                              double density, const XDerivative* stokes) {
  using Matrix = typename SymmetricSystem<Scalar>::Matrix;
  const double half = normals.symmetric ? 0.5 : 1.0;
  AdjointVectors b;
  b.omega.resize(6, normals.n.rows());
  if (stokes != nullptr) b.speed.resize(6, normals.n.rows());
  for (const Parity parity : normals.parities()) {
    const std::vector<int> modes = normals.modes(parity);
    const auto count = static_cast<Eigen::Index>(modes.size());
    const Eigen::MatrixXd n = normals.of(parity), w = normals.area.asDiagonal() * n;
    Eigen::MatrixXd wX(n.rows(), 0);
    if (stokes != nullptr)
      wX = system.hasXDerivative() ? w : Eigen::MatrixXd(stokes->stokes(parity).transpose() * n);
    const Matrix a = system.bothAdjoints(parity, normals.weights(parity).template cast<Scalar>(),
                                         wX.template cast<Scalar>());
    b.omega(modes, Eigen::all) =
        Complex(0.0, density * half) * a.leftCols(count).transpose().template cast<Complex>();
    if (stokes == nullptr) continue;
    Matrix x = a.rightCols(count);
    if (!system.hasXDerivative()) x += (normals.n.col(Surge).asDiagonal() * w).cast<Scalar>();
    b.speed(modes, Eigen::all) = -density * x.transpose().template cast<Complex>();
  }
  return b;
}

CMat6 forcesOnUnitMotions(const ModeVectors& b, const ModeNormals& normals) {
  const double sides = normals.symmetric ? 2.0 : 1.0;
  CMat6 sum = CMat6::Zero();
  for (const Parity parity : normals.parities()) {
    const std::vector<int> modes = normals.modes(parity);
    sum(modes, modes) = sides * b(modes, Eigen::all) * normals.velocities(parity);
  }
  return sum;
}

template AdjointVectors adjointVectors(const SymmetricSystem<double>&, const ModeNormals&, double,
                                       const XDerivative*);
template AdjointVectors adjointVectors(const SymmetricSystem<Complex>&, const ModeNormals&, double,
                                       const XDerivative*);

}  // namespace cutwater
