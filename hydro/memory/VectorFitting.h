#pragma once
#include <Eigen/Core>
#include <vector>

#include "hydro/Conventions.h"

/// Rational functions with common poles fitted to many frequency responses at once.
namespace cutwater {

/// One frequency response H(iω) of a real function of time, with weights of its parts at each ω.
/// THEORY.md, chapter 7.
struct Response {
  Eigen::VectorXcd value;
  Eigen::VectorXd weightRe, weightIm;
  double atZero = 0.0;  ///< H(0), kept exactly if `holdsZero`
  bool holdsZero = false;
  double slope = 0.0;  ///< dH/d(iω) at 0, kept exactly if `holdsSlope`; only beside H(0)
  bool holdsSlope = false;
};

/// Σ over columns: of a real pole 1/(iω − s); of a pair, s and s* counted once with Im s > 0, the
/// sum and i times the difference of both, whose factors are Re and Im of half the residue R of
/// Re{R e^{sτ}}.
Eigen::MatrixXcd rationalBasis(const std::vector<double>& omega, const std::vector<Complex>& poles);

/// Poles, all in the left half plane, that fit all responses together, by vector fitting [Gustavsen
/// & Semlyen 1999; Deschrijver et al. 2008 for many responses].
/// @param count  of poles, a pair counted twice; even.
std::vector<Complex> fitPoles(const std::vector<double>& omega,
                              const std::vector<Response>& responses, std::size_t count,
                              int iterations);

/// Residues R of Re Σ R_m e^{s_m τ} for each response, [response][pole]: weighted least squares.
std::vector<std::vector<Complex>> fitResidues(const std::vector<double>& omega,
                                              const std::vector<Response>& responses,
                                              const std::vector<Complex>& poles);

}  // namespace cutwater
