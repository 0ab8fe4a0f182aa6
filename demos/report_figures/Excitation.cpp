#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "demos/report_figures/Report.h"
#include "hydro/base/EnumNames.h"
#include "hydro/bem/reference/DiffractionSweep.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/geometry/panels/WetSurface.h"
#include "hydro/response/FrequencyResponse.h"

namespace cutwater::report {

namespace {

/// One means of diffraction forces: the tables that have them, and the processor time for them.
struct Means {
  std::string name;
  std::shared_ptr<const CoefficientTables> tables;
  double cpu;
};

/// A curve of a figure: complex forces per metre of amplitude, motions, at each wave frequency.
struct Curve {
  std::vector<CVec6> force, motion;
};

std::vector<double> bothHeadings() { return {kHeadings[0], kHeadings[1]}; }

/// Table 4's grid, whole even in a shortened run: what lies between its frequencies is the finding.
std::vector<double> grid() {
  std::vector<double> omega;
  for (int i = 1; i <= 60; ++i) omega.push_back(0.1 * i);
  return omega;
}

/// Direct first; all four of one system, without lid.
std::vector<Means> fourMeans(const Job& job) {
  const ShipParticulars& ship = job.medium().ship;
  SolveSettings settings;
  settings.forwardSpeed = ForwardSpeedForm::Report;
  settings.omega = job.omega();
  settings.speeds = {kSpeed};
  settings.headings = bothHeadings();
  settings.waveOmega = job.waveOmega();
  settings.lid = false;

  const CpuTime sweep;
  const SolverOutput adjoint = buildCoefficients(ship, settings);
  const double adjointTime = sweep.seconds();
  SolverOutput bare = adjoint;
  bare.adjoint = {};
  bare.adjointX = {};

  settings.omega = grid();
  const InfluenceMatrices matrices(WetSurface(ship.wetSurface, ship.symmetric).panels());
  const ModeNormals normals(matrices.mesh(), ship.cog);
  const XDerivative stokes(ship.wetSurface, matrices.mesh());
  const OneBlasThread oneThread;
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<Means> means;
  for (const Influence influence : {Influence::Direct, Influence::Matrix, Influence::Inverse}) {
    settings.influence = influence;
    const CpuTime cpu;
    const auto tables = std::make_shared<SolverOutput>(bare);
    tables->diffractionTable =
        solveDiffractionTable({matrices, normals, stokes, ship}, settings, settings.omega, threads);
    means.push_back({nameOf(kInfluenceNames, influence), tables, cpu.seconds()});
  }
  means.push_back({nameOf(kInfluenceNames, Influence::Adjoint),
                   std::make_shared<SolverOutput>(adjoint), adjointTime});
  return means;
}

Curve curve(const Means& means, double heading, const std::vector<double>& waveOmega) {
  const CoefficientTables& c = *means.tables;
  const WaveExcitation excitation(c);
  const FrequencyResponse response(c);
  Curve result;
  for (const double omega : waveOmega) {
    const double omegaE = std::abs(encounterFrequency(omega, kSpeed, heading, c.ship.gravity));
    result.force.push_back(excitation.at(omega, heading, kSpeed).total());
    result.motion.push_back(omegaE < kLeastEncounterFrequency
                                ? CVec6::Zero().eval()
                                : response.at(omega, heading, kSpeed));
  }
  return result;
}

/// |F_j| in Δga/L or Δga, |η_j| in a or ka.
std::vector<double> forces(const CVec6& force, const ShipParticulars& ship) {
  std::vector<double> row;
  for (int j = 0; j < 6; ++j)
    row.push_back(std::abs(force[j]) / (ship.mass * ship.gravity) * (j < Roll ? kLength : 1.0));
  return row;
}
std::vector<double> motions(const CVec6& motion, double omega, const ShipParticulars& ship) {
  std::vector<double> row;
  for (int j = 0; j < 6; ++j)
    row.push_back(std::abs(motion[j]) / (j < Roll ? 1.0 : omega * omega / ship.gravity));
  return row;
}

std::string header(const char* quantity, const std::vector<Means>& means) {
  std::string text = "omega_i,omega_e";
  for (const Means& one : means)
    for (int j = 1; j <= 6; ++j) text += fmt::format(",{}{}_{}", quantity, j, one.name);
  return text;
}

void writePair(const Job& job, int figure, double heading, const std::vector<Means>& means,
               const std::vector<Curve>& curves) {
  const ShipParticulars& ship = job.medium().ship;
  command::Csv forceCsv(header("F", means)), motionCsv(header("eta", means));
  const std::vector<double> waveOmega = job.waveOmega();
  for (std::size_t i = 0; i < waveOmega.size(); ++i) {
    const double omega = waveOmega[i];
    const double omegaE = encounterFrequency(omega, kSpeed, heading, ship.gravity);
    std::vector<double> forceRow{omega, omegaE}, motionRow = forceRow;
    for (const Curve& one : curves) {
      const auto force = forces(one.force[i], ship);
      const auto motion = motions(one.motion[i], omega, ship);
      forceRow.insert(forceRow.end(), force.begin(), force.end());
      motionRow.insert(motionRow.end(), motion.begin(), motion.end());
    }
    forceCsv.row(forceRow);
    if (std::abs(omegaE) >= kLeastEncounterFrequency) motionCsv.row(motionRow);
  }
  forceCsv.write(job.file(fmt::format("figure{}.csv", figure)));
  motionCsv.write(job.file(fmt::format("figure{}.csv", figure + 2)));
}

/// Largest |F_j − direct F_j|, or of η_j, of each mode, % of its maximum; waves the panels resolve.
struct Apart {
  Vec6 force = Vec6::Zero(), motion = Vec6::Zero();
  double worstOmega = 0.0;  ///< ω_I where the forces are farthest apart
};

Apart apart(const Curve& curve, const Curve& direct, const std::vector<double>& waveOmega,
            std::size_t resolved) {
  const auto peak = [](const std::vector<CVec6>& values) {
    Vec6 most = Vec6::Zero();
    for (const CVec6& value : values) most = most.cwiseMax(value.cwiseAbs());
    return most;
  };
  const Vec6 forcePeak = peak(direct.force), motionPeak = peak(direct.motion);
  Apart result;
  for (std::size_t i = 0; i < resolved; ++i) {
    const Vec6 force =
        100.0 * (curve.force[i] - direct.force[i]).cwiseAbs().cwiseQuotient(forcePeak);
    const Vec6 motion =
        100.0 * (curve.motion[i] - direct.motion[i]).cwiseAbs().cwiseQuotient(motionPeak);
    if (force.maxCoeff() > result.force.maxCoeff()) result.worstOmega = waveOmega[i];
    result.force = result.force.cwiseMax(force);
    result.motion = result.motion.cwiseMax(motion);
  }
  return result;
}

void addDifferences(command::Csv& csv, double heading, const std::vector<Means>& means,
                    const std::vector<Curve>& curves, const std::vector<double>& waveOmega) {
  const CoefficientTables& direct = *means.front().tables;
  const auto resolved =
      static_cast<std::size_t>(std::count_if(waveOmega.begin(), waveOmega.end(), [&](double omega) {
        return encounterFrequency(omega, kSpeed, heading, direct.ship.gravity) <=
               direct.resolvedOmega;
      }));
  for (std::size_t m = 0; m < curves.size(); ++m) {
    const Apart far = apart(curves[m], curves.front(), waveOmega, resolved);
    std::vector<double> row(far.force.begin(), far.force.end());
    row.insert(row.end(), far.motion.begin(), far.motion.end());
    row.push_back(far.worstOmega);
    row.push_back(waveOmega[resolved - 1]);
    row.push_back(means[m].cpu);
    csv.row(row, fmt::format("{:.0f},{},", heading / kDegree, means[m].name));
  }
}

}  // namespace

void writeFigures21To24(const Job& job, const Sweeps& medium) {
  command::Csv differences(
      "heading_deg,influence,F1_percent,F2_percent,F3_percent,F4_percent,F5_percent,F6_percent,"
      "eta1_percent,eta2_percent,eta3_percent,eta4_percent,eta5_percent,eta6_percent,"
      "worst_force_at_omega_i,up_to_omega_i,cpu_s");
  const std::vector<double> waveOmega = job.waveOmega();
  std::vector<Means> means = fourMeans(job);
  means.push_back({"lid", std::make_shared<Coefficients>(medium.ours),
                   0.0});  // what our database gives by default
  for (const double heading : bothHeadings()) {
    std::vector<Curve> curves;
    for (const Means& one : means) curves.push_back(curve(one, heading, waveOmega));
    addDifferences(differences, heading, means, curves, waveOmega);
    writePair(job, heading < 1.0 ? 21 : 22, heading, means, curves);
  }
  differences.write(job.file("differences.csv"));
}

}  // namespace cutwater::report
