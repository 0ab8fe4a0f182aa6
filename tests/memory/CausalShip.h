#pragma once
#include <cmath>

#include "hydro/database/Coefficients.h"
#include "hydro/database/ForwardSpeed.h"

namespace cutwater::test {

/// B = ω⁴/(1 + ω²)⁴ and all that belongs to it in closed form, stretched in time:
///   K(τ) = k(aτ), k = e^{−t}(3 + 3t − 6t² + t³)/48, whose integral over all τ is 0
struct CausalKernel {
  double rate;  // a [1/s]

  double K(double tau) const {
    const double t = rate * tau;
    return std::exp(-t) * (3.0 + t * (3.0 + t * (-6.0 + t))) / 48.0;
  }
  double I(double tau) const {  // ∫₀^τ K
    const double t = rate * tau;
    return std::exp(-t) * t * (3.0 + t * (3.0 - t)) / 48.0 / rate;
  }
  double E(double tau) const {  // ∫_τ^∞ I
    const double t = rate * tau;
    return std::exp(-t) * (3.0 + t * (3.0 - t * t)) / 48.0 / (rate * rate);
  }
  Complex transform(double omega) const {  // ∫₀^∞ K e^{−iωτ} dτ
    const Complex p = 1.0 / Complex(1.0, omega / rate);
    return p * (3.0 + p * (3.0 + p * (-12.0 + 6.0 * p))) / (48.0 * rate);
  }
};

/// A ship whose K⁰ and ∂K are sums of two such kernels, K⁰ symmetric and positive; ∂B, ∂A like no
/// ship's, no two of their 36 entries alike.
struct CausalShip {
  static constexpr CausalKernel kSlow{1.5}, kFast{2.3};
  Mat6 slow, fast, slowX, fastX, addedMassInf, addedMassXInf;

  CausalShip() {
    const Mat6 any = Mat6::NullaryExpr([](Eigen::Index j, Eigen::Index k) {
      return std::cos(1.0 + 2.0 * static_cast<double>(j + 6 * k));
    });
    slow = any * any.transpose() + Mat6::Identity();
    fast = any.transpose() * any + Mat6::Identity();
    slowX = any;
    fastX = (any.array() * 7.0).sin().matrix();
    addedMassInf = 0.2 * slow + 0.3 * Mat6::Identity();
    addedMassXInf = 0.1 * any.transpose();
  }

  template <class Value>
  Mat6 rest(Value value) const {
    return slow * value(kSlow) + fast * value(kFast);
  }
  template <class Value>
  Mat6 x(Value value) const {
    return slowX * value(kSlow) + fastX * value(kFast);
  }

  SpeedCoefficients atSpeed(double omega, double speed, ForwardSpeedForm form) const {
    const auto re = [&](const CausalKernel& k) { return k.transform(omega).real(); };
    const auto im = [&](const CausalKernel& k) { return k.transform(omega).imag() / omega; };
    return cutwater::atSpeed(Mat6(addedMassInf + rest(im)), rest(re), Mat6(addedMassXInf + x(im)),
                             x(re), omega, speed, form);
  }

  Coefficients coefficients(double step, double last) const {
    Coefficients c;
    c.ship.volume = 1.0;
    c.forwardSpeed = ForwardSpeedForm::Report;
    const auto zero = [](const CausalKernel& k) { return k.E(0.0); };
    c.addedMass.atInfinity = addedMassInf;
    c.addedMassX.atInfinity = addedMassXInf;
    c.addedMass.atZero = addedMassInf + rest(zero);
    c.addedMassX.atZero = addedMassXInf + x(zero);
    for (int i = 1; i <= std::lround(last / step); ++i) {
      const double w = i * step;
      const auto re = [&](const CausalKernel& k) { return k.transform(w).real(); };
      const auto im = [&](const CausalKernel& k) { return k.transform(w).imag() / w; };
      c.omega.push_back(w);
      c.damping.values.push_back(rest(re));
      c.addedMass.values.push_back(addedMassInf + rest(im));
      c.dampingX.values.push_back(x(re));
      c.addedMassX.values.push_back(addedMassXInf + x(im));
    }
    return c;
  }
};

}  // namespace cutwater::test
