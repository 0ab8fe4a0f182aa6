#include "hydro/excitation/ExcitationTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/base/ParallelFor.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/Interpolation.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/incident/IncidentWaveForce.h"
#include "hydro/incident/SmallPanels.h"

namespace cutwater {

namespace {

constexpr double kPhaseStep = 0.5;    // [rad] at the ends of the ship, node to node, in long waves
constexpr double kUsualSpeed = 10.0;  // [m/s] at which b^x is weighed against b
constexpr double kBasisError =
    1e-4;  // of the largest adjoint vector: what directions may leave out
constexpr std::size_t kVectorNodes = 128;  // of ω_e

/// Phase of a wave at the ends of a ship against its middle [rad].
double reachOf(double omega, double length, double gravity) {
  return 0.5 * length * omega * omega / gravity;
}

/// [rad] from node to node: waves shorter than the ship push it less and less, and may be as much
/// coarser.
double phaseStep(double reach) { return kPhaseStep * std::sqrt(std::max(1.0, reach / 8.0)); }

/// Orthonormal directions that hold all columns to `error` of the largest, the longest remainder
/// first.
Eigen::MatrixXd directions(Eigen::MatrixXd columns, double error, std::size_t most) {
  const double goal = error * columns.colwise().norm().maxCoeff();
  Eigen::MatrixXd basis(columns.rows(), 0);
  while (static_cast<std::size_t>(basis.cols()) < most) {
    Eigen::Index longest = 0;
    const double length = columns.colwise().norm().maxCoeff(&longest);
    if (length <= goal) break;
    const Eigen::VectorXd q = columns.col(longest) / length;
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols<1>() = q;
    columns -= q * (q.transpose() * columns).eval();
  }
  const Eigen::Index found = basis.cols();
  basis.conservativeResize(Eigen::NoChange, (found + 3) / 4 * 4);  // by fours, for the vector code
  basis.rightCols(basis.cols() - found).setZero();
  return basis;
}

/// ω_I of the grid, up to `highest`: each component's own if they are few, else steps of half a
/// radian of phase.
std::vector<double> gridFrequencies(const SeaState& sea, double length, double highest) {
  std::vector<double> own;
  for (const WaveComponent& wave : sea.components()) {
    if (wave.omega <= highest) own.push_back(wave.omega);
  }
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  std::vector<double> grid;
  if (own.empty()) return grid;
  const double last = own.back(), widest = (last - own.front()) / 3.0;  // a cubic has four nodes
  for (double omega = own.front(); omega < last;) {
    grid.push_back(omega);
    const double reach = reachOf(omega, length, sea.gravity());
    const double step =
        std::min({widest, 0.05 * last + 0.02, 0.5 * omega * phaseStep(reach) / reach});
    omega += step;
    if (last - omega < 0.01 * step) break;
  }
  grid.push_back(last);
  return own.size() <= grid.size() + 4 ? own : grid;
}

}  // namespace

ExcitationTable::ExcitationTable(const Coefficients& c, const SeaState& sea, ForwardSpeedForm form)
    : ExcitationTable(WaveExcitation(c, form), sea) {}

ExcitationTable::ExcitationTable(const WaveExcitation& direct, const SeaState& sea)
    : sea_(sea),
      form_(direct.form()),
      symmetric_(direct.coefficients().ship.symmetric),
      hasVectors_(!direct.coefficients().adjoint.empty() && !direct.panels().panels.empty()),
      length_(direct.panels().panels.empty() ? 1.0 : direct.coefficients().ship.length()),
      lastOmega_(direct.lastOmega()) {
  if (sea.components().empty()) return;
  const CoefficientTables& c = direct.coefficients();
  checkComponents(c);
  if (hasVectors_) {
    makeVectors(c);
  } else {
    width_ = 24;
  }
  makeRows(direct);
  error_ = measureError(direct);
}

// As WaveExcitation would at rest; what speeds a course may have is not known here.
void ExcitationTable::checkComponents(const CoefficientTables& c) const {
  if (c.omega.empty())
    throw HydroError(Fault::DatabaseIncomplete, "ExcitationTable: the database has no frequencies");
  if (sea_.components().size() > 1 || known(sea_.components().front().omega)) return;
  throw HydroError(
      Fault::ValueOutOfRange,
      fmt::format("ExcitationTable: wave component 0: omega = {:.6g} rad/s is above the database's "
                  "last, {:.6g}",
                  sea_.components().front().omega, lastOmega_));
}

void ExcitationTable::makeVectors(const CoefficientTables& c) {
  hasInfinity_ = c.adjoint.atInfinity.cols() > 0;
  last_ = c.omega[(hasInfinity_ ? resolvedCount(c) : c.omega.size()) - 1];
  vectorStep_ = last_ / static_cast<double>(kVectorNodes - 1);
  vectorCount_ = kVectorNodes;
  const bool hasX = !c.adjointX.empty() && form_ == ForwardSpeedForm::Report;
  std::vector<Coefficients::AdjointVectors> b, bx;
  for (std::size_t n = 0; n < vectorCount_ + (hasInfinity_ ? 1 : 0); ++n) {
    const double omega = n < vectorCount_ ? static_cast<double>(n) * vectorStep_ : HUGE_VAL;
    b.push_back(n < vectorCount_ ? adjointAt(c, omega) : c.adjoint.atInfinity);
    if (hasX) {
      bx.push_back(n < vectorCount_ ? adjointXAt(c, omega) : c.adjointX.atInfinity);
    } else if (form_ == ForwardSpeedForm::Tuck) {
      const CMat6 iT = Complex(0.0, 1.0) * tuckMatrix().cast<Complex>();
      bx.push_back(iT * b.back());
    } else {
      bx.push_back(Coefficients::AdjointVectors::Zero(6, b.back().cols()));
    }
  }
  makeBasis(b, bx);
  for (std::size_t p = 0; p < 2; ++p) rank_[p] = static_cast<std::size_t>(basis_[p].cols());
  width_ = 12 + 2 * (rank_[0] + rank_[1]);
  vectorSize_ = symmetric_ ? 12 * (rank_[0] + rank_[1]) : 24 * rank_[0];
  vectors_.assign(b.size() * vectorSize_, 0.0);
  for (std::size_t n = 0; n < b.size(); ++n) project(b[n], bx[n], &vectors_[n * vectorSize_]);
}

// Every mode's vectors of one parity, scaled by that mode's largest, are to be held alike.
void ExcitationTable::makeBasis(const std::vector<Coefficients::AdjointVectors>& b,
                                const std::vector<Coefficients::AdjointVectors>& bx) {
  const Eigen::Index panels = b.front().cols();
  for (std::size_t p = 0; p < (symmetric_ ? 2u : 1u); ++p) {
    std::vector<int> modes;
    for (int mode = 0; mode < 6; ++mode) {
      if (parityOf(mode) == p) modes.push_back(mode);
    }
    Eigen::MatrixXd columns(panels, static_cast<Eigen::Index>(4 * b.size() * modes.size()));
    Eigen::Index at = 0;
    for (const int mode : modes) {
      const Eigen::Index first = at;
      for (std::size_t n = 0; n < b.size(); ++n) {
        for (const auto* vectors : {&b[n], &bx[n]}) {
          const double scale = vectors == &bx[n] ? kUsualSpeed : 1.0;
          columns.col(at++) = scale * vectors->row(mode).real().transpose();
          columns.col(at++) = scale * vectors->row(mode).imag().transpose();
        }
      }
      const double size = columns.middleCols(first, at - first).colwise().norm().maxCoeff();
      if (size > 0.0) columns.middleCols(first, at - first) /= size;
    }
    basis_[p] = directions(std::move(columns), kBasisError, kMostDirections);
  }
  if (!symmetric_) basis_[1].resize(panels, 0);
}

// Rows b_j and b^x_j in the directions: Re then Im, over the rank of the mode's parity; twice for
// the port half of a symmetric hull.
void ExcitationTable::project(const Coefficients::AdjointVectors& b,
                              const Coefficients::AdjointVectors& bx, double* row) const {
  for (const auto* vectors : {&b, &bx}) {
    for (int mode = 0; mode < 6; ++mode) {
      const std::size_t p = parityOf(mode);
      const Eigen::VectorXcd q =
          (symmetric_ ? 2.0 : 1.0) * (vectors->row(mode) * basis_[p].cast<Complex>()).transpose();
      for (Eigen::Index i = 0; i < q.size(); ++i) *row++ = q[i].real();
      for (Eigen::Index i = 0; i < q.size(); ++i) *row++ = q[i].imag();
    }
  }
}

void ExcitationTable::makeRows(const WaveExcitation& direct) {
  const ShipParticulars& ship = direct.coefficients().ship;
  std::size_t size = 0;
  rowOmega_ = gridFrequencies(sea_, length_, lastOmega_);
  for (const double omega : rowOmega_) {
    const double reach = reachOf(omega, length_, sea_.gravity());
    const auto half = static_cast<std::size_t>(std::ceil(kPi * (reach / phaseStep(reach) + 4.0)));
    rows_.push_back({2 * half, size});
    size += 2 * half * width_;
  }
  values_.assign(size, 0.0);
  SmallPanels panels, faces;
  if (hasVectors_) {
    panels = {direct.panels(), ship.cog};
    faces = {direct.faces(), ship.cog};
  }
  const auto fill = [&](const AiryWave& wave, double* at) {
    if (hasVectors_) {
      put(faces.froudeKrylovForce(wave, ship.density) + direct.lacking().force(wave), at);
      enter(panels.incidentNormalVelocity(wave), at + 12);
    } else {
      const auto force = direct.at(wave.omega, wave.heading);
      put(force.froudeKrylov, at);
      put(force.diffraction, at + 12);
    }
  };
  parallelFor(rows_.size(), 0, [&](std::size_t i) { fillRow(i, fill); });
}

template <class Fill>
void ExcitationTable::fillRow(std::size_t i, const Fill& fill) {
  const Row& row = rows_[i];
  for (std::size_t h = 0; h < row.headings; ++h) {
    double* at = &values_[row.offset + h * width_];
    if (symmetric_ && h > row.headings / 2) {
      mirror(&values_[row.offset + (row.headings - h) * width_], at);
      continue;
    }
    const double beta = 2.0 * kPi * static_cast<double>(h) / static_cast<double>(row.headings);
    fill({rowOmega_[i], beta, sea_.gravity()}, at);
  }
}

void ExcitationTable::put(const CVec6& force, double* at) {
  for (int j = 0; j < 6; ++j) at[j] = force[j].real(), at[6 + j] = force[j].imag();
}

void ExcitationTable::enter(const IncidentVelocity& v, double* at) const {
  for (std::size_t p = 0; p < 2; ++p) {
    if (rank_[p] == 0) continue;
    const Eigen::VectorXcd& velocity = p == 0 ? v.even : v.odd;
    const Eigen::VectorXd re = velocity.real(), im = velocity.imag();
    Eigen::Map<Eigen::VectorXd> toRe(at, basis_[p].cols()), toIm(at + toRe.size(), toRe.size());
    toRe.noalias() = basis_[p].transpose() * re;
    toIm.noalias() = basis_[p].transpose() * im;
    at += 2 * toRe.size();
  }
}

// A wave from the other side: odd modes and the odd part of v change sign.
void ExcitationTable::mirror(const double* from, double* to) const {
  std::copy_n(from, width_, to);
  const std::size_t forces = hasVectors_ ? 12 : 24;
  for (std::size_t i = 1; i < forces; i += 2) to[i] = -to[i];
  for (std::size_t i = hasVectors_ ? 12 + 2 * rank_[0] : width_; i < width_; ++i) to[i] = -to[i];
}

double ExcitationTable::measureError(const WaveExcitation& direct) const {
  const bool moving =
      hasVectors_ && (form_ == ForwardSpeedForm::Tuck || !direct.coefficients().adjointX.empty());
  Eigen::Array<double, 6, 1> worst = Eigen::Array<double, 6, 1>::Zero(), largest = worst;
  std::vector<double> omegas;
  for (const WaveComponent& wave : sea_.components()) {
    if (known(wave.omega)) omegas.push_back(wave.omega);
  }
  if (omegas.empty()) return 0.0;
  constexpr int kPoints = 48;
  for (int i = 0; i < kPoints; ++i) {
    const auto at = static_cast<std::size_t>(i) * (omegas.size() - 1) / (kPoints - 1);
    const double omega = omegas[at], beta = 2.399963229728653 * i;
    double speed = moving ? 0.37 * (i % 41) : 0.0;
    const double met = Encounter(omega, speed, beta, sea_.gravity()).frequency();
    if (!hasInfinity_ && met > last_) speed = 0.0;  // nothing to compare with
    const CVec6 found = froudeKrylovOf(omega, beta) + diffractionOf(omega, beta, speed);
    const auto exact = direct.at(omega, beta, speed);
    worst = worst.max((found - exact.total()).array().abs());
    largest = largest.max(exact.total().array().abs());
  }
  double error = 0.0;
  for (int j = 0; j < 6; ++j) {
    if (largest[j] > 0.0) error = std::max(error, worst[j] / largest[j]);
  }
  return error;
}

}  // namespace cutwater
