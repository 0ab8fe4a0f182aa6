#include "hydro/forces/ExcitationTable.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "hydro/Errors.h"
#include "hydro/database/ForwardSpeed.h"
#include "hydro/database/Interpolation.h"
#include "hydro/forces/WaveExcitation.h"
#include "hydro/geometry/PanelQuadrature.h"
#include "hydro/geometry/SolverPanels.h"
#include "hydro/waves/IncidentWaveForce.h"
#include "hydro/waves/VectorSine.h"

namespace cutwater {

namespace {

constexpr double kPhaseStep = 0.5;    // [rad] at the ends of the ship, node to node, in long waves
constexpr double kUsualSpeed = 10.0;  // [m/s] at which b^x is weighed against b
constexpr double kBasisError =
    1e-4;  // of the largest adjoint vector: what directions may leave out
constexpr std::size_t kMostDirections = 64;
constexpr std::size_t kVectorNodes = 128;  // of ω_e
constexpr int kParityModes[2][3] = {{Surge, Heave, Pitch}, {Sway, Roll, Yaw}};

/// Phase of a wave at the ends of a ship against her middle [rad].
double reachOf(double omega, double length, double gravity) {
  return 0.5 * length * omega * omega / gravity;
}

/// [rad] from node to node: waves shorter than the ship push her less and less, and may be as much coarser.
double phaseStep(double reach) { return kPhaseStep * std::sqrt(std::max(1.0, reach / 8.0)); }

/// Weights of four evenly spaced nodes −1, 0, 1, 2 at x in [0, 1].
std::array<double, 4> evenCubic(double x) noexcept {
  const double a = x + 1.0, b = x - 1.0, c = x - 2.0;
  return {-x * b * c / 6.0, a * b * c / 2.0, -a * x * c / 2.0, a * x * b / 6.0};
}

double lengthOf(const SurfaceMesh& mesh) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& v : mesh.vertices) low = std::min(low, v.x()), high = std::max(high, v.x());
  return high > low ? high - low : 1.0;
}

/// sum += weight · row, `count` a multiple of four.
CUTWATER_VECTOR void addRow(double* sum, const double* row, double weight,
                            std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; i += 4) {
    const Four v = loadFour(sum + i) + weight * loadFour(row + i);
    std::memcpy(sum + i, &v, sizeof v);
  }
}

/// Σ b q of complex numbers given as runs of Re and Im, `count` of each, a multiple of four.
CUTWATER_VECTOR void complexDot(const double* b, const double* q, std::size_t count, double* re,
                                double* im) noexcept {
  Four real = {}, imaginary = {};
  for (std::size_t i = 0; i < count; i += 4) {
    const Four x = loadFour(b + i), y = loadFour(b + count + i);
    const Four u = loadFour(q + i), v = loadFour(q + count + i);
    real += x * u - y * v;
    imaginary += x * v + y * u;
  }
  *re = sumOf(real);
  *im = sumOf(imaginary);
}

/// Orthonormal directions that hold all columns to `error` of the largest, the longest remainder first.
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

/// What a panel's mean of a wave needs: to second order in its size over the wave length.
struct SmallPanel {
  Vec3 centre, normal;  // from G in plan, from calm water in height
  double area = 0.0;
  Eigen::Matrix3d spread;  // ∫(x − c)(x − c)ᵀ dS / area
  Vec3 arm;                // c − G
};

std::vector<SmallPanel> smallPanels(const PanelMesh& mesh, const Vec3& cog) {
  std::vector<SmallPanel> panels;
  for (const Panel& p : mesh.panels) {
    SmallPanel small{p.centroid - Vec3(cog.x(), cog.y(), 0.0), p.normal, p.area,
                     Eigen::Matrix3d::Zero(), p.centroid - cog};
    for (const QuadraturePoint& point : panelQuadrature(p, 3)) {
      const Vec3 r = point.x - p.centroid;
      small.spread += point.weight / p.area * r * r.transpose();
    }
    panels.push_back(small);
  }
  return panels;
}

SmallPanel starboard(SmallPanel p) {
  for (Vec3* v : {&p.centre, &p.normal, &p.arm}) v->y() = -v->y();
  for (const int i : {0, 2}) p.spread(i, 1) = p.spread(1, i) = -p.spread(i, 1);
  return p;
}

/// κ = k(−i cos β, i sin β, 1) and the mean of e^{κ·x} over a panel, and of (x − c) e^{κ·x}.
struct PlaneWave {
  Eigen::Vector3cd kappa;
  explicit PlaneWave(const AiryWave& wave) {
    const double k = wave.omega * wave.omega / wave.gravity;
    kappa = k * Eigen::Vector3cd(Complex(0.0, -std::cos(wave.heading)),
                                 Complex(0.0, std::sin(wave.heading)), 1.0);
  }
  Complex mean(const SmallPanel& p, Eigen::Vector3cd& moment) const {
    const double phase = kappa.x().imag() * p.centre.x() + kappa.y().imag() * p.centre.y();
    const Complex at =
        std::exp(kappa.z().real() * p.centre.z()) * Complex(std::cos(phase), std::sin(phase));
    const Eigen::Vector3cd bent = p.spread.cast<Complex>() * kappa;
    moment = at * bent;
    return at * (1.0 + 0.5 * (kappa.x() * bent.x() + kappa.y() * bent.y() + kappa.z() * bent.z()));
  }
};

/// F_I per metre of amplitude, as froudeKrylovForce.
CVec6 pressure(const std::vector<SmallPanel>& panels, const AiryWave& wave, bool symmetric,
               double density) {
  const PlaneWave e(wave);
  CVec6 sum = CVec6::Zero();
  const auto add = [&](const SmallPanel& p) {
    Eigen::Vector3cd arm;
    const Complex mean = e.mean(p, arm);
    arm += mean * p.arm;
    const Vec3& n = p.normal;
    sum.head<3>() += p.area * mean * n;
    sum[3] += p.area * (arm.y() * n.z() - arm.z() * n.y());
    sum[4] += p.area * (arm.z() * n.x() - arm.x() * n.z());
    sum[5] += p.area * (arm.x() * n.y() - arm.y() * n.x());
  };
  for (const SmallPanel& p : panels) {
    add(p);
    if (symmetric) add(starboard(p));
  }
  return -density * wave.gravity * sum;
}

/// As incidentNormalVelocity.
IncidentVelocity normalVelocity(const std::vector<SmallPanel>& panels, const AiryWave& wave,
                                bool symmetric) {
  const PlaneWave e(wave);
  const Complex amplitude(0.0, -wave.gravity / wave.omega);
  const auto count = static_cast<Eigen::Index>(panels.size());
  IncidentVelocity v{Eigen::VectorXcd(count), Eigen::VectorXcd(symmetric ? count : 0)};
  const auto mean = [&](const SmallPanel& p) {
    Eigen::Vector3cd unused;
    const Complex across =
        e.kappa.x() * p.normal.x() + e.kappa.y() * p.normal.y() + e.kappa.z() * p.normal.z();
    return amplitude * across * e.mean(p, unused);
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    const SmallPanel& p = panels[static_cast<std::size_t>(i)];
    const Complex port = mean(p);
    v.even[i] = port;
    if (!symmetric) continue;
    const Complex other = mean(starboard(p));
    v.even[i] = 0.5 * (port + other);
    v.odd[i] = 0.5 * (port - other);
  }
  return v;
}

/// work(0) … work(count − 1) on all cores; what it throws comes out of here.
template <class Work>
void shared(std::size_t count, Work work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t i; (i = next++) < count;) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> pool;
  for (unsigned t = 1; t < std::min<std::size_t>(std::thread::hardware_concurrency(), count); ++t)
    pool.emplace_back(run);
  run();
  for (std::thread& thread : pool) thread.join();
  if (failure) std::rethrow_exception(failure);
}

/// ω_I of the grid: each component's own if they are few, else steps of half a radian of phase.
std::vector<double> gridFrequencies(const SeaState& sea, double length) {
  std::vector<double> own;
  for (const WaveComponent& wave : sea.components()) own.push_back(wave.omega);
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  std::vector<double> grid;
  if (own.empty()) return grid;
  for (double omega = own.front();;) {
    grid.push_back(omega);
    if (omega >= own.back()) break;
    const double reach = reachOf(omega, length, sea.gravity());
    const double step = std::min(0.05 * own.back() + 0.02, 0.5 * omega * phaseStep(reach) / reach);
    omega = std::min(omega + step, own.back());
  }
  return own.size() <= grid.size() + 4 ? own : grid;
}

}  // namespace

ExcitationTable::ExcitationTable(const Coefficients& c, const SeaState& sea,
                                 std::optional<ForwardSpeedForm> form)
    : sea_(sea),
      form_(form.value_or(c.forwardSpeed)),
      symmetric_(c.ship.symmetric),
      hasVectors_(!c.adjoint.empty() && !c.ship.wetSurface.faces.empty()),
      length_(lengthOf(c.ship.wetSurface)) {
  if (sea.components().empty()) return;
  if (hasVectors_) {
    makeVectors(c);
  } else {
    width_ = 24;
  }
  makeRows(c);
  error_ = measureError(c);
}

void ExcitationTable::makeVectors(const Coefficients& c) {
  hasInfinity_ = c.adjointInf.cols() > 0;
  last_ = c.omega[(hasInfinity_ ? resolvedCount(c) : c.omega.size()) - 1];
  vectorStep_ = last_ / static_cast<double>(kVectorNodes - 1);
  vectorCount_ = kVectorNodes;
  const bool hasX = !c.adjointX.empty() && form_ == ForwardSpeedForm::Report;
  std::vector<Coefficients::AdjointVectors> b, bx;
  for (std::size_t n = 0; n < vectorCount_ + (hasInfinity_ ? 1 : 0); ++n) {
    const double omega = n < vectorCount_ ? static_cast<double>(n) * vectorStep_ : HUGE_VAL;
    b.push_back(n < vectorCount_ ? adjointAt(c, omega) : c.adjointInf);
    if (hasX) {
      bx.push_back(n < vectorCount_ ? adjointXAt(c, omega) : c.adjointXInf);
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
    std::vector<int> modes(kParityModes[p], kParityModes[p] + 3);
    if (!symmetric_) modes = {0, 1, 2, 3, 4, 5};
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

// Rows b_j and b^x_j in the directions: Re then Im, over the rank of the mode's parity; twice for the port
// half of a symmetric hull.
void ExcitationTable::project(const Coefficients::AdjointVectors& b,
                              const Coefficients::AdjointVectors& bx, double* row) const {
  for (const auto* vectors : {&b, &bx}) {
    for (int mode = 0; mode < 6; ++mode) {
      const std::size_t p = symmetric_ && mode % 2 == 1 ? 1 : 0;
      const Eigen::VectorXcd q =
          (symmetric_ ? 2.0 : 1.0) * (vectors->row(mode) * basis_[p].cast<Complex>()).transpose();
      for (Eigen::Index i = 0; i < q.size(); ++i) *row++ = q[i].real();
      for (Eigen::Index i = 0; i < q.size(); ++i) *row++ = q[i].imag();
    }
  }
}

void ExcitationTable::makeRows(const Coefficients& c) {
  std::size_t size = 0;
  for (const double omega : gridFrequencies(sea_, length_)) {
    const double reach = reachOf(omega, length_, sea_.gravity());
    const auto half = static_cast<std::size_t>(std::ceil(kPi * (reach / phaseStep(reach) + 4.0)));
    rows_.push_back({omega, 2 * half, size});
    size += 2 * half * width_;
  }
  values_.assign(size, 0.0);
  const WaveExcitation direct(c, form_);
  std::vector<SmallPanel> panels, faces;
  if (hasVectors_) {
    panels = smallPanels(solverPanels(c.ship.wetSurface, symmetric_, c.curvedPanels), c.ship.cog);
    faces = smallPanels(makePanels(triangulated(c.ship.wetSurface), symmetric_), c.ship.cog);
  }
  shared(rows_.size(), [&](std::size_t i) {
    const Row& row = rows_[i];
    for (std::size_t h = 0; h < row.headings; ++h) {
      double* at = &values_[row.offset + h * width_];
      if (symmetric_ && h > row.headings / 2) {
        mirror(&values_[row.offset + (row.headings - h) * width_], at);
        continue;
      }
      const double beta = 2.0 * kPi * static_cast<double>(h) / static_cast<double>(row.headings);
      const AiryWave wave{row.omega, beta, sea_.gravity()};
      if (hasVectors_) {
        put(pressure(faces, wave, symmetric_, c.ship.density), at);
        enter(normalVelocity(panels, wave, symmetric_), at + 12);
      } else {
        const auto force = direct.at(row.omega, beta);
        put(force.froudeKrylov, at);
        put(force.diffraction, at + 12);
      }
    }
  });
}

void ExcitationTable::put(const CVec6& force, double* at) {
  for (int j = 0; j < 6; ++j) at[j] = force[j].real(), at[6 + j] = force[j].imag();
}

void ExcitationTable::enter(const IncidentVelocity& v, double* at) const {
  for (std::size_t p = 0; p < 2; ++p) {
    if (rank_[p] == 0) continue;
    const Eigen::VectorXcd q = basis_[p].transpose().cast<Complex>() * (p == 0 ? v.even : v.odd);
    for (Eigen::Index i = 0; i < q.size(); ++i) *at++ = q[i].real();
    for (Eigen::Index i = 0; i < q.size(); ++i) *at++ = q[i].imag();
  }
}

// A wave from the other side: odd modes and the odd part of v change sign.
void ExcitationTable::mirror(const double* from, double* to) const {
  std::copy_n(from, width_, to);
  const std::size_t forces = hasVectors_ ? 12 : 24;
  for (std::size_t i = 1; i < forces; i += 2) to[i] = -to[i];
  for (std::size_t i = hasVectors_ ? 12 + 2 * rank_[0] : width_; i < width_; ++i) to[i] = -to[i];
}

void ExcitationTable::addHeadings(const Row& row, double beta, double share,
                                  double* sum) const noexcept {
  const auto count = static_cast<double>(row.headings);
  const double turn = beta / (2.0 * kPi), x = (turn - std::floor(turn)) * count;
  const double floor = std::floor(x);
  const auto weights = evenCubic(x - floor);
  const auto first = static_cast<std::size_t>(floor) + row.headings - 1;
  for (std::size_t n = 0; n < 4; ++n) {
    const double* at = &values_[row.offset + (first + n) % row.headings * width_];
    addRow(sum, at, share * weights[n], width_);
  }
}

CVec6 ExcitationTable::diffraction(double* q, double omegaE, double speed) const noexcept {
  const double omega = std::abs(omegaE);
  const bool overtaking = omegaE < 0.0;
  std::array<double, 4> weights{};
  std::array<std::size_t, 4> nodes{};
  if (omega >= last_) {
    const double u = last_ / omega, rest = hasInfinity_ ? u * u : 1.0;
    weights = {rest, hasInfinity_ ? 1.0 - rest : 0.0, 0.0, 0.0};
    nodes = {vectorCount_ - 1, hasInfinity_ ? vectorCount_ : 0, 0, 0};
  } else {
    const double x = omega / vectorStep_;
    const double low = std::clamp(std::floor(x), 1.0, static_cast<double>(vectorCount_ - 3));
    weights = evenCubic(x - low);
    for (std::size_t n = 0; n < 4; ++n) nodes[n] = static_cast<std::size_t>(low) - 1 + n;
  }
  if (overtaking) {  // of v*, and the force's conjugate
    for (std::size_t p = 0, at = rank_[0]; p < 2; ++p, at += rank_[0] + rank_[1])
      for (std::size_t i = 0; i < rank_[p]; ++i) q[at + i] = -q[at + i];
  }
  CVec6 force = CVec6::Zero();
  for (std::size_t n = 0; n < 4; ++n) {
    if (weights[n] == 0.0) continue;
    const double* b = &vectors_[nodes[n] * vectorSize_];
    for (int part = 0; part < 2; ++part) {
      const double share = weights[n] * (part == 0 ? omega : speed);
      for (int mode = 0; mode < 6; ++mode) {
        const std::size_t p = symmetric_ && mode % 2 == 1 ? 1 : 0;
        double re = 0.0, im = 0.0;
        complexDot(b, q + (p == 0 ? 0 : 2 * rank_[0]), rank_[p], &re, &im);
        force[mode] += share * Complex(re, im);
        b += 2 * rank_[p];
      }
    }
  }
  if (overtaking) force = force.conjugate().eval();
  return force;
}

ExcitationTable::Amplitude ExcitationTable::at(std::size_t component, double course,
                                               double speed) const noexcept {
  const WaveComponent& wave = sea_.components()[component];
  return atWave(wave.omega, wave.heading + course, speed);
}

ExcitationTable::Amplitude ExcitationTable::atWave(double omega, double beta,
                                                   double speed) const noexcept {
  std::array<double, 12 + 4 * kMostDirections> sum;
  std::fill_n(sum.begin(), width_, 0.0);
  const auto above = std::upper_bound(rows_.begin(), rows_.end(), omega,
                                      [](double w, const Row& row) { return w < row.omega; });
  const auto right = static_cast<std::size_t>(above - rows_.begin());
  const std::size_t count = std::min<std::size_t>(4, rows_.size());
  const std::size_t first = std::min(rows_.size() - count, right < 2 ? 0 : right - 2);
  for (std::size_t i = first; i < first + count; ++i) {
    double weight = 1.0;
    for (std::size_t n = first; n < first + count; ++n) {
      if (n != i) weight *= (omega - rows_[n].omega) / (rows_[i].omega - rows_[n].omega);
    }
    if (weight != 0.0) addHeadings(rows_[i], beta, weight, sum.data());
  }
  Amplitude result;
  for (int j = 0; j < 6; ++j) {
    const auto i = static_cast<std::size_t>(j);
    result.froudeKrylov[j] = Complex(sum[i], sum[6 + i]);
    result.diffraction[j] = Complex(sum[12 + i], sum[18 + i]);
  }
  if (hasVectors_) {
    const double omegaE = encounterFrequency(omega, speed, beta, sea_.gravity());
    result.diffraction = diffraction(sum.data() + 12, omegaE, speed);
  }
  return result;
}

double ExcitationTable::measureError(const Coefficients& c) const {
  const WaveExcitation direct(c, form_);
  const bool moving = hasVectors_ && (form_ == ForwardSpeedForm::Tuck || !c.adjointX.empty());
  Eigen::Array<double, 6, 1> worst = Eigen::Array<double, 6, 1>::Zero(), largest = worst;
  constexpr int kPoints = 48;
  for (int i = 0; i < kPoints; ++i) {
    const auto at = static_cast<std::size_t>(i) * (sea_.components().size() - 1) / (kPoints - 1);
    const double omega = sea_.components()[at].omega;
    const double beta = 2.399963229728653 * i, speed = moving ? 0.37 * (i % 41) : 0.0;
    const Amplitude found = atWave(omega, beta, speed);
    const auto exact = direct.at(omega, beta, speed);
    worst = worst.max((found.froudeKrylov + found.diffraction - exact.total()).array().abs());
    largest = largest.max(exact.total().array().abs());
  }
  double error = 0.0;
  for (int j = 0; j < 6; ++j) {
    if (largest[j] > 0.0) error = std::max(error, worst[j] / largest[j]);
  }
  return error;
}

}  // namespace cutwater
