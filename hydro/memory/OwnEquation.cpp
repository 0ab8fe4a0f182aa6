#include "hydro/memory/OwnEquation.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

namespace cutwater {

namespace {

/// An analytic function, its argument and where it is small.
struct Sample {
  double omega;
  Complex value;
};

double turn(const Sample& from, const Sample& to) { return std::arg(to.value / from.value); }

/// Adds the change of argument between two samples to `total`, with as many more between them as it
/// takes to see it, and those to `seen`.
template <class Function>
void addTurn(const Function& f, const Sample& from, const Sample& to, int depth, double& total,
             std::vector<Sample>& seen) {
  constexpr double kSure = 0.7;  // [rad]
  const double middle = 0.5 * (from.omega + to.omega);
  const Sample between{middle, f(middle)};
  const double first = turn(from, between), second = turn(between, to);
  if (depth == 0 || !(std::abs(first) + std::abs(second) >= kSure)) {  // no number: no turn
    total += first + second;
    seen.push_back(to);
    return;
  }
  addTurn(f, from, between, depth - 1, total, seen);
  addTurn(f, between, to, depth - 1, total, seen);
}

}  // namespace

/// The equation of some modes at one speed.
class OwnEquation::AtSpeed {
 public:
  AtSpeed(const OwnEquation& own, double speed, bool lift, std::vector<int> modes)
      : own_(own), modes_(std::move(modes)) {
    const CoefficientTables& c = own.coefficients_;
    const RetardationMatrix& memory = own.model_.retardation();
    const double U = speed;
    inertia_ =
        c.ship.massMatrix() + 0.5 * (c.addedMass.atInfinity + c.addedMass.atInfinity.transpose());
    damping_ = U * memory.speedDamping();
    damping_.diagonal() += c.ship.supplementary.damping;
    stiffness_ = c.ship.restoring + U * U * memory.speedStiffness();
    stiffness_.diagonal() += c.ship.supplementary.stiffness;
    if (lift) {
      damping_(Sway, Sway) += own.lift_.side * std::abs(U);
      stiffness_(Sway, Yaw) -= own.lift_.side * std::abs(U) * U;
      damping_(Yaw, Yaw) += own.lift_.turn * std::abs(U);
    }
    const ExponentialSum& sum = own.model_.sum();
    const auto looksAt = [&](int j) {
      return std::find(modes_.begin(), modes_.end(), j) != modes_.end();
    };
    for (const ExponentialSum::Pair& pair : sum.pairs()) {
      if (!looksAt(pair.j) || !looksAt(pair.k)) continue;
      Residues residues{pair.j, pair.k, {}};
      for (std::size_t m = 0; m < sum.size(); ++m)
        residues.atPole.push_back(pair.atRest[m] + U * (pair.linear[m] + U * pair.squared[m]));
      residues_.push_back(std::move(residues));
    }
    scale_ = inertia_(modes_, modes_).eval().determinant();
  }

  CMat6 whole(Complex s) const {
    const std::vector<Complex>& poles = own_.model_.sum().poles();
    CMat6 memory = CMat6::Zero();
    std::vector<std::array<Complex, 2>> inverse(poles.size());
    for (std::size_t m = 0; m < poles.size(); ++m)
      inverse[m] = {0.5 / (s - poles[m]), 0.5 / (s - std::conj(poles[m]))};
    for (const Residues& r : residues_) {
      Complex sum = 0.0;
      for (std::size_t m = 0; m < poles.size(); ++m)
        sum += r.atPole[m] * inverse[m][0] + std::conj(r.atPole[m]) * inverse[m][1];
      memory(r.j, r.k) = sum;
    }
    return s * s * inertia_.cast<Complex>() + s * (damping_.cast<Complex>() + memory) +
           stiffness_.cast<Complex>();
  }

  std::vector<GrowingMotion> growing() const {
    std::vector<Sample> line;
    const int count = countGrowing(line);
    std::vector<GrowingMotion> found;
    if (count == 0) return found;
    for (const Complex s : starts(line)) {
      if (static_cast<int>(found.size()) >= count) break;
      search(s, found);
    }
    // What Newton's method has not found is there all the same, nearest to where det D is smallest.
    while (static_cast<int>(found.size()) < count) {
      const auto smallest = std::min_element(
          line.begin(), line.end(),
          [](const Sample& a, const Sample& b) { return std::abs(a.value) < std::abs(b.value); });
      found.push_back(motionAt(Complex(own_.least_, smallest->omega)));
    }
    return found;
  }

 private:
  struct Residues {
    int j, k;
    std::vector<Complex> atPole;
  };

  /// det D over what it is far away: 1 there.
  Complex determinant(Complex s) const {
    const Complex far = std::pow(s + own_.rate_, 2 * static_cast<int>(modes_.size())) * scale_;
    return CMat6(whole(s))(modes_, modes_).eval().determinant() / far;
  }

  /// Number of zeros with Re s > σ, and det D along the line from ω = 0 on.
  int countGrowing(std::vector<Sample>& line) const {
    const auto onLine = [&](double omega) { return determinant(Complex(own_.least_, omega)); };
    constexpr int kSteps = 48, kDepth = 12;
    double total = 0.0;
    Sample before{0.0, onLine(0.0)};
    line.push_back(before);
    for (int n = 1; n <= kSteps; ++n) {
      const double omega = own_.rate_ * 0.02 * (std::exp(0.25 * n) - 1.0);  // to 3000 √(g/L)
      const Sample next{omega, onLine(omega)};
      addTurn(onLine, before, next, kDepth, total, line);
      before = next;
    }
    total -= std::arg(before.value);  // far away it is 1
    if (!std::isfinite(total)) return 0;
    return std::max(0, static_cast<int>(std::lround(-total / kPi)));
  }

  /// Where zeros may be near: the dips along the line, and the real axis.
  std::vector<Complex> starts(const std::vector<Sample>& line) const {
    std::vector<Complex> result;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool dip =
          (i == 0 || std::abs(line[i].value) <= std::abs(line[i - 1].value)) &&
          (i + 1 == line.size() || std::abs(line[i].value) <= std::abs(line[i + 1].value));
      if (dip) result.emplace_back(own_.least_, line[i].omega);
    }
    for (const double real : {0.01, 0.1, 0.3, 1.0, 3.0})
      for (const double imaginary : {0.0, 0.3, 1.0, 3.0})
        result.push_back(own_.rate_ * Complex(real, imaginary));
    return result;
  }

  /// A growing motion that is not yet among those found; a complex one brings its conjugate.
  void search(Complex start, std::vector<GrowingMotion>& found) const {
    std::vector<Complex> known;
    for (const GrowingMotion& motion : found) known.push_back(motion.s);
    const std::optional<Complex> s = zeroNear(start, known);
    if (!s) return;
    found.push_back(motionAt(*s));
    if (std::abs(s->imag()) < 1e-6 * own_.rate_) return;
    found.push_back(found.back());
    found.back().s = std::conj(*s);
  }

  /// Newton's method for a zero of det D with Re s > σ, those known divided out.
  std::optional<Complex> zeroNear(Complex s, const std::vector<Complex>& known) const {
    const double h = 1e-5 * own_.rate_;
    for (int iteration = 0; iteration < 60; ++iteration) {
      const Complex slope = (determinant(s + h) - determinant(s - h)) / (2.0 * h);
      Complex inverse = slope / determinant(s);
      for (const Complex& other : known) inverse -= 1.0 / (s - other);
      Complex step = 1.0 / inverse;
      if (!std::isfinite(std::abs(step))) return {};
      const double longest = 0.3 * (std::abs(s) + own_.rate_);
      if (std::abs(step) > longest) step *= longest / std::abs(step);
      s -= step;
      if (s.real() < 0.1 * own_.least_) return {};
      if (std::abs(step) < 1e-8 * own_.rate_)
        return s.real() > own_.least_ ? std::optional(s) : std::nullopt;
    }
    return {};
  }

  /// The motion e^{st} and its cause: of the modes without which it would not grow, the one with
  /// the largest share of the kinetic energy. A slow turn drags a heel along, a slow dive a surge.
  GrowingMotion motionAt(Complex s) const {
    const std::vector<int> order = byEnergy(s);
    for (const int mode : order) {
      if (order.size() > 1 && growsWithout(mode, s)) continue;
      return {s, static_cast<Mode>(mode)};
    }
    return {s, static_cast<Mode>(order.front())};
  }

  /// The modes by their share of the kinetic energy, the largest first.
  std::vector<int> byEnergy(Complex s) const {
    const Eigen::MatrixXcd system = CMat6(whole(s))(modes_, modes_);
    const Eigen::VectorXd size = inertia_.diagonal()(modes_).cwiseSqrt();
    const Eigen::MatrixXcd scaled =
        size.cwiseInverse().asDiagonal() * system * size.cwiseInverse().asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(scaled, Eigen::ComputeThinV);
    const Eigen::VectorXd share = svd.matrixV().rightCols<1>().cwiseAbs();
    std::vector<int> order(modes_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::sort(order.begin(), order.end(), [&](int i, int j) { return share[i] > share[j]; });
    for (int& i : order) i = modes_[static_cast<std::size_t>(i)];
    return order;
  }

  /// With this mode held there is still a motion much like e^{st}.
  bool growsWithout(int mode, Complex s) const {
    AtSpeed held = *this;
    std::erase(held.modes_, mode);
    held.scale_ = inertia_(held.modes_, held.modes_).eval().determinant();
    const std::optional<Complex> found = held.zeroNear(s, {});
    return found && std::abs(*found - s) < 0.5 * std::abs(s);
  }

  const OwnEquation& own_;
  std::vector<int> modes_;
  Mat6 inertia_, damping_, stiffness_;
  std::vector<Residues> residues_;
  double scale_ = 1.0;
};

OwnEquation::OwnEquation(const CoefficientTables& coefficients, const RadiationModel& model)
    : coefficients_(coefficients),
      model_(model),
      lift_(coefficients, coefficients.ship.length()),
      rate_(std::sqrt(coefficients.ship.gravity / coefficients.ship.length())),
      least_(1e-3 * rate_) {}

std::vector<GrowingMotion> OwnEquation::growing(double speed, bool lift) const {
  if (!coefficients_.ship.symmetric)
    return AtSpeed(*this, speed, lift, {Surge, Sway, Heave, Roll, Pitch, Yaw}).growing();
  std::vector<GrowingMotion> all = AtSpeed(*this, speed, lift, {Sway, Roll, Yaw}).growing();
  if (lift) return all;  // which does not act in the other modes
  const std::vector<GrowingMotion> even =
      AtSpeed(*this, speed, lift, {Surge, Heave, Pitch}).growing();
  all.insert(all.end(), even.begin(), even.end());
  return all;
}

CMat6 OwnEquation::at(Complex s, double speed, bool lift) const {
  return AtSpeed(*this, speed, lift, {Surge, Sway, Heave, Roll, Pitch, Yaw}).whole(s);
}

}  // namespace cutwater
