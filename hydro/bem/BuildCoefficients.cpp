#include "hydro/bem/BuildCoefficients.h"

#include <omp.h>

#include <cmath>
#include <mutex>

#include "hydro/Errors.h"
#include "hydro/bem/DiffractionSweep.h"
#include "hydro/bem/Parallel.h"
#include "hydro/database/IrregularFrequencies.h"
#include "hydro/geometry/Lid.h"
#include "hydro/geometry/SolverPanels.h"

namespace cutwater {
namespace {

void check(const ShipParticulars& ship, const SolveSettings& settings) {
  if (ship.wetSurface.faces.empty())
    throw HydroError(Fault::MeshEmpty, "buildCoefficients: the wet surface has no faces");
  if (settings.omega.empty())
    throw HydroError(Fault::BadArgument, "buildCoefficients: no frequencies");
  double before = 0.0;
  for (const double omega : settings.omega) {
    if (!std::isfinite(omega) || omega <= before)
      throw HydroError(std::isfinite(omega) && omega > 0.0 ? Fault::FrequenciesNotIncreasing
                                                           : Fault::ValueOutOfRange,
                       "buildCoefficients: frequency " + std::to_string(omega) + " rad/s after " +
                           std::to_string(before) + "; they must rise from above 0");
    before = omega;
  }
  for (const double heading : settings.headings)
    if (!std::isfinite(heading))
      throw HydroError(Fault::ValueOutOfRange, "buildCoefficients: a heading is not finite");
  for (const double speed : settings.speeds)
    if (!std::isfinite(speed))
      throw HydroError(Fault::ValueOutOfRange, "buildCoefficients: a speed is not finite");
  before = 0.0;
  for (const double omega : settings.waveOmega) {
    if (!std::isfinite(omega) || omega <= before)
      throw HydroError(Fault::ValueOutOfRange, "buildCoefficients: wave frequency " +
                                                   std::to_string(omega) + " rad/s after " +
                                                   std::to_string(before) +
                                                   "; they must rise from above 0");
    before = omega;
  }
  if (settings.influence != Influence::Adjoint &&
      (settings.speeds.empty() || settings.headings.empty() || settings.waveOmega.empty()))
    throw HydroError(Fault::BadArgument,
                     "buildCoefficients: a table of diffraction forces needs speeds, headings and "
                     "wave frequencies");
  if (!(ship.density > 0.0) || !(ship.gravity > 0.0))
    throw HydroError(Fault::ValueOutOfRange,
                     "buildCoefficients: density " + std::to_string(ship.density) +
                         " kg/m³ and gravity " + std::to_string(ship.gravity) +
                         " m/s² must be above 0");
}

/// With G off the centre plane, even and odd modes couple: the whole hull then.
ShipParticulars solvable(const ShipParticulars& ship) {
  ShipParticulars whole = ship;
  const double diagonal = bounds(ship.wetSurface).diagonal();
  if (!ship.symmetric || std::abs(ship.cog.y()) <= 1e-9 * diagonal) return whole;
  whole.symmetric = false;
  whole.wetSurface = welded(joined(ship.wetSurface, mirroredInY(ship.wetSurface)), 1e-9 * diagonal);
  return whole;
}

std::string describe(const SolveSettings& settings, std::size_t lidPanels) {
  const auto word = [](bool b) { return b ? "true" : "false"; };
  const auto points = [](int n) { return n == 0 ? std::string("\"auto\"") : std::to_string(n); };
  return std::string("formulation = \"") + wordOf(kFormulationWords, settings.formulation) +
         "\"\nderivatives = \"" + wordOf(kDerivativesWords, settings.derivatives) +
         "\"\nsource_points = " + points(settings.sourcePoints) +
         "\ngalerkin_points = " + points(settings.galerkinPoints) +
         "\ncurved_panels = " + word(settings.curvedPanels) + "\nlid = " + word(settings.lid) +
         "\nlid_panels = " + std::to_string(lidPanels) +
         "\nx_derivatives = " + word(settings.xDerivatives) + "\ninfluence = \"" +
         wordOf(kInfluenceWords, settings.influence) + "\"\n";
}

/// FNV-1a over coordinates and corners: two databases of the same panels have the same hash.
std::string hashOf(const SurfaceMesh& mesh) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&hash](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211ull;
  };
  for (const Vec3& vertex : mesh.vertices) add(vertex.data(), 3 * sizeof(double));
  for (const Face& face : mesh.faces) add(face.v.data(), sizeof(face.v));
  std::string text(16, '0');
  for (std::size_t i = 0; i < 16; ++i) text[15 - i] = "0123456789abcdef"[(hash >> (4 * i)) & 15u];
  return text;
}

/// Highest frequency whose waves the panels at calm water resolve: K ℓ = 4, ℓ the longest edge of
/// the lid, without lid of the waterline. On the frigate of 433 panels a side with two lids and of
/// 1040 with one, the first ringing of A and B came at K ℓ = 4.1 to 4.4; a square panel of side ℓ
/// is half a wave at π, and at √2 π along its diagonal.
double resolved(const PanelMesh& mesh, double gravity) {
  const bool lid = !mesh.lid.empty();
  double longest = 0.0;
  for (const Panel& panel : lid ? mesh.lid : mesh.panels) {
    for (int i = 0; i < panel.corners; ++i) {
      const Vec3& a = panel.corner[static_cast<std::size_t>(i)];
      const Vec3& b = panel.corner[static_cast<std::size_t>((i + 1) % panel.corners)];
      const double edge = (b - a).norm();
      if (lid || std::max(-a.z(), -b.z()) < 1e-6 * edge) longest = std::max(longest, edge);
    }
  }
  return longest > 0.0 ? std::sqrt(4.0 * gravity / longest) : 0.0;
}

/// The frequencies that the mask leaves.
std::vector<double> regularFrequencies(const Coefficients& c) {
  const std::vector<int> masked = irregularFrequencies(c);
  std::vector<double> kept;
  for (std::size_t i = 0; i < c.omega.size(); ++i)
    if (masked.empty() || masked[i] == 0) kept.push_back(c.omega[i]);
  return kept;
}

/// One ship's sweep: what all frequencies share, and the result being filled. Each frequency writes
/// only its own places, so threads need no lock.
class Sweep {
 public:
  Sweep(Coefficients& out, const SolveSettings& settings, int threads)
      : out_(out),
        settings_(settings),
        matrices_(panels(out.ship, settings), influence(settings, threads)),
        normals_(matrices_.mesh(), out.ship.cog, out.ship.wetSurface),
        derivative_(out.ship.wetSurface, matrices_.mesh()),
        faces_(makePanels(triangulated(out.ship.wetSurface), out.ship.symmetric)) {
    const std::size_t count = out_.omega.size();
    out_.addedMass.resize(count);
    out_.damping.resize(count);
    if (settings.xDerivatives) {
      out_.addedMassX.resize(count);
      out_.dampingX.resize(count);
    }
    if (settings.influence == Influence::Adjoint) {
      out_.adjoint.resize(count);
      if (settings.xDerivatives) out_.adjointX.resize(count);
    }
    out_.froudeKrylov.assign(out_.headings.size(), std::vector<CVec6>(count));
    out_.diffraction = out_.froudeKrylov;
    out_.conditionEven.resize(count);
    if (matrices_.parities() == 2) out_.conditionOdd.resize(count);
    out_.provenance.settings = describe(settings, matrices_.mesh().lid.size());
    out_.resolvedOmega = resolved(matrices_.mesh(), out_.ship.gravity);
  }

  void solveLimits() {
    for (const FrequencyLimit limit : {FrequencyLimit::Zero, FrequencyLimit::Infinite}) {
      std::array<InfluenceSystem<double>, 2> pairs;
      for (int p = 0; p < matrices_.parities(); ++p)
        pairs[static_cast<std::size_t>(p)] = matrices_.atLimit(limit, static_cast<Parity>(p));
      const SymmetricSystem<double> system(std::move(pairs), matrices_.parities());
      const auto phi = radiationPotentials(system, normals_);
      const bool zero = limit == FrequencyLimit::Zero;
      const double density = out_.ship.density;
      (zero ? out_.addedMassZero : out_.addedMassInf) = impulseMatrix(phi, normals_, density);
      if (settings_.xDerivatives)
        (zero ? out_.addedMassXZero : out_.addedMassXInf) =
            impulseMatrixX(system, phi, normals_, derivative_, density);
      if (settings_.influence != Influence::Adjoint) continue;
      (zero ? out_.adjointZero : out_.adjointInf) = adjointVectors(system, normals_, density);
      if (settings_.xDerivatives)
        (zero ? out_.adjointXZero : out_.adjointXInf) =
            adjointVectorsX(system, normals_, derivative_, density);
    }
  }

  void solve(std::size_t i) {
    const double omega = out_.omega[i], K = omega * omega / out_.ship.gravity;
    const SymmetricSystem<Complex> system(matrices_.atWaveNumber(K), matrices_.parities());
    radiate(system, i);
    diffract(system, i);
    if (settings_.influence == Influence::Adjoint) {
      out_.adjoint[i] = adjointVectors(system, normals_, out_.ship.density);
      if (settings_.xDerivatives)
        out_.adjointX[i] = adjointVectorsX(system, normals_, derivative_, out_.ship.density);
    }
    out_.conditionEven[i] = system.condition(Parity::Even);
    if (matrices_.parities() == 2) out_.conditionOdd[i] = system.condition(Parity::Odd);
  }

  void tableDiffraction(int threads) {
    out_.diffractionTable = solveDiffractionTable({matrices_, normals_, derivative_, out_.ship},
                                                  settings_, regularFrequencies(out_), threads);
  }

 private:
  static InfluenceSettings influence(const SolveSettings& settings, int threads) {
    return {settings.formulation, settings.derivatives == Derivatives::Source,
            settings.sourcePoints, settings.galerkinPoints, threads};
  }

  static PanelMesh panels(const ShipParticulars& ship, const SolveSettings& settings) {
    PanelMesh mesh = solverPanels(ship.wetSurface, ship.symmetric, settings.curvedPanels);
    if (settings.lid) mesh.lid = makeLid(ship.wetSurface, ship.symmetric, settings.lidPanelLength);
    return mesh;
  }

  void radiate(const SymmetricSystem<Complex>& system, std::size_t i) {
    const double omega = out_.omega[i], density = out_.ship.density;
    const auto phi = radiationPotentials(system, normals_);
    const CMat6 Z = impulseMatrix(phi, normals_, density);
    out_.addedMass[i] = addedMass(Z);
    out_.damping[i] = damping(Z, omega);
    if (!settings_.xDerivatives) return;
    const CMat6 ZX = impulseMatrixX(system, phi, normals_, derivative_, density);
    out_.addedMassX[i] = addedMass(ZX);
    out_.dampingX[i] = damping(ZX, omega);
  }

  void diffract(const SymmetricSystem<Complex>& system, std::size_t i) {
    const ShipParticulars& ship = out_.ship;
    const PanelMesh& mesh = matrices_.mesh();
    std::vector<IncidentVelocity> velocities;
    for (std::size_t h = 0; h < out_.headings.size(); ++h) {
      const AiryWave wave{out_.omega[i], out_.headings[h], ship.gravity};
      out_.froudeKrylov[h][i] = froudeKrylovForce(faces_, wave, ship.cog, ship.density);
      velocities.push_back(incidentNormalVelocity(mesh, wave, ship.cog));
    }
    const auto forces = diffraction(system, normals_, velocities, ship.density);
    for (std::size_t h = 0; h < forces.size(); ++h)
      out_.diffraction[h][i] = out_.omega[i] * forces[h].omega;
  }

  Coefficients& out_;
  const SolveSettings& settings_;
  InfluenceMatrices matrices_;
  ModeNormals normals_;
  XDerivative derivative_;
  PanelMesh faces_;  // the surface without the gaps of flattening, for F_I
};

}  // namespace

Coefficients buildCoefficients(const ShipParticulars& ship, const SolveSettings& settings,
                               const SolveProgress& progress) {
  check(ship, settings);
  Coefficients out;
  out.ship = solvable(ship);
  out.omega = settings.omega;
  out.headings = settings.headings;
  out.curvedPanels = settings.curvedPanels;
  out.forwardSpeed = settings.forwardSpeed;
  out.waveOmega = settings.waveOmega;
  out.conditionLimitEven = settings.conditionLimitEven;
  out.conditionLimitOdd = settings.conditionLimitOdd;
  out.provenance.version = CUTWATER_VERSION;
  out.provenance.meshHash = hashOf(out.ship.wetSurface);

  const OneBlasThread oneBlasThread;
  const int threads = settings.threads > 0 ? settings.threads : omp_get_num_procs();
  Sweep sweep(out, settings, threads);
  sweep.solveLimits();
  const int total = static_cast<int>(out.omega.size());
  int done = 0;
  std::mutex guard;  // of `done` and of progress
  parallelFor(total, threads, [&](int i) {
    sweep.solve(static_cast<std::size_t>(i));
    const std::lock_guard lock(guard);
    ++done;
    if (progress) progress(done, total);
  });
  if (settings.influence != Influence::Adjoint) sweep.tableDiffraction(threads);
  return out;
}

}  // namespace cutwater
