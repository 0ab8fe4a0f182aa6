#pragma once
#include <array>
#include <vector>

#include "hydro/database/Coefficients.h"
#include "hydro/incident/IncidentWaveForce.h"
#include "hydro/waves/Encounter.h"
#include "hydro/waves/SeaState.h"

namespace cutwater {

class WaveExcitation;

/// Forces of all components of a sea on a ship of any course and speed, shared by all ships of a
/// kind.
///
/// F_I and the incident velocity v on the panels depend on ω_I and β alone, the adjoint vectors b,
/// b^x on ω_e alone: F_D = ω′ b(ω_e)·v + U b^x(ω_e)·v, v* and the conjugate of the force where
/// ω′ < 0. The panels' velocities are kept in the few directions that the adjoint vectors see (some
/// 40 of each parity instead of hundreds of panels), on a grid of ω_I and β fine enough for the
/// waves' phase at the ends of the ship, half a radian a step, with local cubics between; the
/// vectors on an even grid of ω_e, likewise. Immutable, any thread may read. At load some tenths of
/// a second and 10 MB for a sea of 200 components; a call costs about a microsecond.
class ExcitationTable {
 public:
  /// Of one component, per metre of its amplitude.
  struct Amplitude {
    CVec6 froudeKrylov, diffraction;
  };

  /// @param direct  forces of the same ship one by one, which need only live for this call.
  /// Components above WaveExcitation::lastOmega have no force: 0 (SeaTables::beyond says how many).
  /// @throws HydroError ValueOutOfRange for a sea of one wave, if it is such a component; as
  ///         WaveExcitation::at for a database without adjoint vectors, whose tables must hold
  ///         all headings and whose diffraction is that at rest at every speed.
  ExcitationTable(const WaveExcitation& direct, const SeaState& sea);
  /// @param form  of the forward-speed terms.
  ExcitationTable(const Coefficients& coefficients, const SeaState& sea, ForwardSpeedForm form);

  const SeaState& sea() const noexcept { return sea_; }
  /// The two parts of one component, apart.
  /// @param component of the sea.  @param course ψ̄ [rad].  @param speed U [m/s].
  /// @param leeway  V to port [m/s]: felt in the encounter frequency alone.
  /// Not a number where course or speed is not finite.
  CVec6 froudeKrylov(std::size_t component, double course) const noexcept;
  CVec6 diffraction(std::size_t component, double course, double speed,
                    double leeway = 0.0) const noexcept;
  Amplitude at(std::size_t component, double course, double speed) const noexcept {
    return {froudeKrylov(component, course), diffraction(component, course, speed)};
  }

  /// Largest distance from direct evaluation at points between the grid's, over the largest force
  /// of that mode in this sea, both for waves of unit amplitude; measured when made.
  double error() const noexcept { return error_; }

 private:
  // Of one ω_I: all headings, in values_, width_ numbers a heading.
  struct Row {
    std::size_t headings = 0, offset = 0;
  };
  struct Columns {  // of a row's numbers
    std::size_t first, count;
  };
  static constexpr std::size_t kForceColumns = 12;    // of one force
  static constexpr std::size_t kMostDirections = 64;  // of each parity

  /// Which directions a mode sees: 0 even (all of an unsymmetric hull), 1 odd.
  std::size_t parityOf(int mode) const noexcept { return symmetric_ && mode % 2 == 1 ? 1 : 0; }
  void checkComponents(const CoefficientTables& c) const;
  bool known(double omega) const noexcept { return omega <= lastOmega_; }
  void makeVectors(const CoefficientTables& c);
  void makeBasis(const std::vector<Coefficients::AdjointVectors>& b,
                 const std::vector<Coefficients::AdjointVectors>& bx);
  void project(const Coefficients::AdjointVectors& b, const Coefficients::AdjointVectors& bx,
               double* row) const;
  void makeRows(const WaveExcitation& direct);
  template <class Fill>
  void fillRow(std::size_t i, const Fill& fill);
  static void put(const CVec6& force, double* at);
  void enter(const IncidentVelocity& v, double* at) const;
  void mirror(const double* from, double* to) const;
  double measureError(const WaveExcitation& direct) const;
  void interpolate(double omega, double beta, const Columns& columns, double* sum) const noexcept;
  struct VectorNodes {  // of ω_e
    std::array<double, 4> weights;
    std::array<std::size_t, 4> nodes;
  };
  VectorNodes vectorNodes(double omegaE) const noexcept;
  CVec6 fromDirections(double* q, const Encounter& met) const noexcept;
  CVec6 froudeKrylovOf(double omega, double beta) const noexcept;
  CVec6 diffractionOf(double omega, double beta, double speed, double leeway = 0.0) const noexcept;

  SeaState sea_;
  ForwardSpeedForm form_;
  bool symmetric_ = false, hasVectors_ = false;
  double length_ = 1.0;
  double lastOmega_ = 0.0;                // ω_I of the last wave that has a force
  std::array<Eigen::MatrixXd, 2> basis_;  // panels × directions, even and odd
  std::array<std::size_t, 2> rank_{};
  std::size_t width_ = 12;        // F_I, then Re q, Im q of both parities; or F_D at rest
  std::vector<double> rowOmega_;  // ω_I of the rows
  std::vector<Row> rows_;
  std::vector<double> values_;
  double last_ = 0.0, vectorStep_ = 1.0;  // ω_e grid
  bool hasInfinity_ = false;
  std::size_t vectorCount_ = 0;  // nodes of ω_e; one more for ∞
  // Per node: b, then b^x, of each mode, Re and Im over its parity's directions.
  std::vector<double> vectors_;
  std::size_t vectorSize_ = 0;
  double error_ = 0.0;
};

}  // namespace cutwater
