#include "hydro/bem/Diffraction.h"

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

// In both functions the factor 2 of a symmetric hull, which the weights hold, is left to v.
template <typename Scalar>
Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectors(const SymmetricSystem<Scalar>& system,
                                                         const ModeNormals& normals,
                                                         double density) {
  const Complex factor(0.0, density * (normals.symmetric ? 0.5 : 1.0));
  Eigen::Matrix<Complex, 6, Eigen::Dynamic> b(6, normals.n.rows());
  for (const Parity parity : normals.parities())
    b(normals.modes(parity), Eigen::all) =
        factor * system.adjoints(parity, normals.weights(parity).template cast<Scalar>())
                     .transpose()
                     .template cast<Complex>();
  return b;
}

template <typename Scalar>
Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectorsX(const SymmetricSystem<Scalar>& system,
                                                          const ModeNormals& normals,
                                                          const XDerivative& stokes,
                                                          double density) {
  using Matrix = typename SymmetricSystem<Scalar>::Matrix;
  Eigen::Matrix<Complex, 6, Eigen::Dynamic> b(6, normals.n.rows());
  for (const Parity parity : normals.parities()) {
    const Matrix n = normals.of(parity).template cast<Scalar>();
    const Matrix w = normals.area.asDiagonal() * n;
    const Matrix x =
        system.hasXDerivative()
            ? system.xAdjoints(parity, w)
            : Matrix(normals.n.col(Surge).asDiagonal() * w +
                     system.adjoints(parity, stokes.stokes(parity).transpose().cast<Scalar>() * n));
    b(normals.modes(parity), Eigen::all) = -density * x.transpose().template cast<Complex>();
  }
  return b;
}

template Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectors(const SymmetricSystem<double>&,
                                                                  const ModeNormals&, double);
template Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectors(const SymmetricSystem<Complex>&,
                                                                  const ModeNormals&, double);
template Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectorsX(const SymmetricSystem<double>&,
                                                                   const ModeNormals&,
                                                                   const XDerivative&, double);
template Eigen::Matrix<Complex, 6, Eigen::Dynamic> adjointVectorsX(const SymmetricSystem<Complex>&,
                                                                   const ModeNormals&,
                                                                   const XDerivative&, double);

}  // namespace cutwater
