#pragma once
#include <vector>

#include "hydro/database/Coefficients.h"
#include "hydro/memory/RetardationFunction.h"
#include "hydro/memory/SpeedParts.h"

namespace cutwater {

/// Memory of a ship under way: K⁰ [unit of B / s], K^U [unit of B / m], K^UU [unit of B · s/m²].
using SpeedKernels = SpeedParts<Mat6>;

/// The retardation functions of a ship, at rest and under way:
///     const RetardationMatrix K(coefficients);
///     K.at(2.0);                 // K⁰ after 2 s
///     K.kernels(2.0).at(8.0);    // K at 8 m/s
/// With D(τ) = (2/π)∫(∂B/ω) sin ωτ dω, I⁰(τ) = ∫₀^τ K⁰ and T of database/ForwardSpeed.h
///     K⁰   = (2/π)∫ B cos ωτ dω                                                  [M03] (34)
///     K^U  = −D + I⁰ Tᵀ                                                    [M03] (35), (37), (39)
///     K^UU = (∫_τ^∞ D ds) Tᵀ                                                   [M03] (38), (40)
///     b(U) = U(A^∞Tᵀ − ∂A^∞),   c(U) = −U² ∂A(0) Tᵀ,   ∂A(0) = ∂A^∞ + ∫₀^∞ D dτ  [M03] (41)-(45)
/// so that −ω²A^∞ + iω(b + K̂(ω)) + c = −ω²A(U, ω) + iωB(U, ω) at every ω, for both forms of the
/// forward-speed terms (Tuck's: ∂B = TB, ∂A = TA). D equals the report's (2/π)∫[∂A − ∂A^∞] cos ωτ
/// dω, as a causal function has both; taken from ∂B it begins at 0 and its tail dies one power
/// faster. ∂A^∞ is that which belongs to ∂A(ω) and ∂B(ω): ∂A(ω) + (1/ω)∫₀^∞ ∂K sin ωτ dτ, averaged
/// over the middle of the band (MiddleBand.h).
///
/// A and B are symmetrised first: they are symmetric but for the solver's discretisation error, and
/// a symmetric positive B gives a memory that cannot create energy. ∂A and ∂B are not symmetric.
/// Pairs that vanish by symmetry, |B_jk| below 1e-8 of √(B_jj B_kk) at their maxima, are left out.
/// Frequencies above Coefficients::resolvedOmega are left to the tails, which keep B positive:
/// couplings that would outlast their modes are lessened beyond the data.
/// THEORY.md, chapter 7.
class RetardationMatrix {
 public:
  /// @param form  of the forward-speed terms.
  /// @throws HydroError DatabaseIncomplete: unfinished coefficients; else as RetardationFunction.
  RetardationMatrix(const Coefficients& coefficients, ForwardSpeedForm form);
  /// In the database's own form.
  explicit RetardationMatrix(const Coefficients& coefficients)
      : RetardationMatrix(coefficients, coefficients.forwardSpeed) {}

  Mat6 at(double tau) const;                 ///< K⁰(τ) [unit of B / s]
  Mat6 integral(double tau) const;           ///< ∫₀^τ K⁰ dτ [unit of B]
  Mat6 sineTransform(double omega) const;    ///< ∫₀^∞ K⁰ sin ωτ dτ [unit of B]
  bool isZero(int j, int k) const noexcept;  ///< the pair is left out of K⁰; j, k = 0..5

  /// False: the report's form, and the database holds no ∂A, ∂B. K^U, K^UU, b and c are then zero.
  bool hasSpeedTerms() const noexcept { return hasSpeedTerms_; }
  ForwardSpeedForm form() const noexcept { return form_; }
  SpeedKernels kernels(double tau) const;
  /// ∫ of the three over τ from a to b ≥ a [s]: K⁰ and K^U exact, K^UU by three Gauss points.
  SpeedKernels integrals(double a, double b) const;
  /// ∫₀^∞ of the three e^{−iωτ} dτ, from B, ∂B and their sine transforms.  @param omega  > 0.
  using Transforms = SpeedParts<CMat6>;
  Transforms transforms(double omega) const;
  /// ∫₀^∞ K^U dτ [unit of B · s/m]; ∫₀^∞ K⁰ dτ = 0.
  Mat6 linearTotal() const;
  /// ∫_a^b ∫₀^τ K⁰ ds dτ [unit of A]; b = ∞ for a ship's whole past.  ∫₀^∞ is A(0) − A(∞).
  Mat6 momentumIntegral(double a, double b) const;
  const Mat6& speedDamping() const noexcept { return speedDamping_; }  ///< b/U [unit of B · s/m]
  const Mat6& speedStiffness() const noexcept { return speedStiffness_; }  ///< c/U² [kg/m ...]
  const Mat6& addedMassXInf() const noexcept { return addedMassXInf_; }    ///< ∂A^∞, consistent

  /// A(∞) = A(ω) + (1/ω)∫₀^∞ K⁰ sin ωτ dτ, symmetrised: the same for every ω > 0 if A, B and the
  /// tail are right.
  /// @param addedMass A at that ω.
  Mat6 addedMassInf(double omega, const Mat6& addedMass) const;

  /// B(ω) and ∂B(ω) as the memory has them: interpolated, and continued beyond the last frequency
  /// it uses.
  Mat6 damping(double omega) const;
  Mat6 dampingX(double omega) const;
  /// ∂A(ω) = ∂A^∞ − (1/ω)∫₀^∞ ∂K sin ωτ dτ likewise.
  Mat6 addedMassX(double omega) const;

  /// Ω [rad/s], the last frequency of the data in use; 0 without any memory.
  double lastOmega() const noexcept {
    return entries_.empty() ? 0.0 : entries_.front().function.nodes_.back();
  }

  /// K⁰ at 0, Δτ, 2Δτ, … up to `duration` [s], for the database file.
  /// @throws HydroError ValueOutOfRange unless 0 < step ≤ duration ≤ 10⁶ step.
  ImpulseResponse table(double step, double duration) const;

  /// T [s] beyond which K⁰ is negligible: of every pair no more than 0.1 % of ∫|K⁰| lies beyond it,
  /// measured by √(∫|K_jj| ∫|K_kk|). At most π/Δω, Δω the median step of the data: beyond that the
  /// data do not determine K.
  double duration() const noexcept { return duration_; }

 private:
  struct Entry {
    int j, k;
    RetardationFunction function;
  };
  using Entries = std::vector<Entry>;
  enum class Level { Value, Integral, Remaining };  // K, ∫₀^τ K, ∫_τ^∞ ∫₀^s K
  Mat6 sum(const Entries& entries, Level level, double tau) const;
  Mat6 atRest(Level level, double tau) const;  // of K⁰
  Mat6 ofX(Level level, double tau) const;     // of ∂K in place of K⁰; Tuck's form: of T K⁰
  Mat6 squared(double tau) const;
  Mat6 linearBeyond(double tau) const;  // ∫_τ^∞ K^U
  // The same of what `value` says of each function.
  template <class Value>
  Mat6 ofAll(const Entries& entries, Value value) const;
  template <class Value>
  Mat6 atRest(Value value) const;
  template <class Value>
  Mat6 ofX(Value value) const;
  Mat6 sineTransformX(double omega) const;
  void keepTailsPositive();
  void addSpeedTerms(const Coefficients& coefficients, const Vec6& scale);
  double findDuration() const;

  Entries entries_;   // of B, j ≤ k
  Entries entriesX_;  // of ∂B, report's form
  ForwardSpeedForm form_;
  bool hasSpeedTerms_ = false;
  Mat6 rise_ = Mat6::Zero();  // ∂A(0) − ∂A^∞ = ∫₀^∞ D
  Mat6 addedMassXInf_ = Mat6::Zero(), speedDamping_ = Mat6::Zero(), speedStiffness_ = Mat6::Zero();
  double duration_ = 0.0;
};

}  // namespace cutwater
