#include <chrono>
#include <filesystem>
#include <map>

#include "demos/report_figures/Report.h"
#include "hydro/bem/solution/Diffraction.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/excitation/WaveExcitation.h"
#include "hydro/finish/Finish.h"
#include "hydro/geometry/panels/Lid.h"
#include "hydro/geometry/panels/WetSurface.h"

namespace cutwater::report {

void writeTable2(const Job& job) {
  command::Csv csv(
      "mesh,panels_port,nominal_panel_m2,volume_m3,lcb_aft_of_fp_m,cb_wrt_waterline_m,"
      "wetted_m2,gm_transverse_m");
  for (const Mesh& mesh : job.meshes) {
    const auto panels = static_cast<double>(mesh.ship.wetSurface.faces.size());
    const Hydrostatics& h = mesh.afloat;
    csv.row({panels, 0.5 * h.wettedArea / panels, h.volume, 0.5 * kLength - h.buoyancy.x(),
             h.buoyancy.z(), h.wettedArea, h.gmT},
            std::to_string(mesh.panels) + ",");
  }
  csv.write(job.file("table2.csv"));
}

namespace {

/// Processor time [s] by task, in the order of the solver's steps.
class Breakdown {
 public:
  /// The result of `work`, whose time is added to `task`.
  template <class Work>
  auto timed(const std::string& task, double share, Work work) {
    const Lap lap{*this, task, share, {}};
    return work();  // not copied: some of the matrices cannot be
  }
  const std::vector<std::pair<std::string, double>>& tasks() const { return tasks_; }

 private:
  struct Lap {
    Breakdown& times;
    const std::string& task;
    double share;
    CpuTime cpu;
    ~Lap() { times.add(task, share * cpu.seconds()); }
  };

  void add(const std::string& task, double seconds) {
    for (auto& [name, sum] : tasks_) {
      if (name == task) {
        sum += seconds;
        return;
      }
    }
    tasks_.emplace_back(task, seconds);
  }

  std::vector<std::pair<std::string, double>> tasks_;
};

/// The matrix of the whole hull out of those of its halves: [pp, ps; ps, pp].
Eigen::MatrixXcd wholeHull(const Eigen::MatrixXcd& even, const Eigen::MatrixXcd& odd) {
  const Eigen::Index n = even.rows();
  Eigen::MatrixXcd whole(2 * n, 2 * n);
  whole.topLeftCorner(n, n) = whole.bottomRightCorner(n, n) = 0.5 * (even + odd);
  whole.topRightCorner(n, n) = whole.bottomLeftCorner(n, n) = 0.5 * (even - odd);
  return whole;
}

/// Our steps of one frequency, averaged over `omegas`; no lid, so that there are as many unknowns
/// as the report has.
void timeOurs(const Mesh& mesh, const std::vector<double>& omegas, Breakdown& times) {
  const ShipParticulars& ship = mesh.ship;
  const InfluenceMatrices matrices = times.timed("Rankine integrals (once)", 1.0, [&] {
    return InfluenceMatrices(WetSurface(ship.wetSurface, ship.symmetric).panels());
  });
  const ModeNormals normals(matrices.mesh(), ship.cog);
  const XDerivative stokes(ship.wetSurface, matrices.mesh());
  const double share = 1.0 / static_cast<double>(omegas.size());
  for (const double omega : omegas) {
    auto systems = times.timed("wave terms and assembly", share,
                               [&] { return matrices.atWaveNumber(omega * omega / ship.gravity); });
    Eigen::MatrixXcd whole = wholeHull(systems[0].L, systems[1].L);
    const SymmetricSystem<Complex> system = times.timed("LU of even and odd matrices", share, [&] {
      return SymmetricSystem<Complex>(std::move(systems), 2);
    });
    times.timed("condition numbers", share,
                [&] { return system.condition(Parity::Even) + system.condition(Parity::Odd); });
    const auto phi = times.timed("radiation: solves and added mass", share, [&] {
      auto potentials = radiationPotentials(system, normals);
      impulseMatrix(potentials, normals, ship.density);
      return potentials;
    });
    times.timed("x derivatives by Stokes' theorem", share,
                [&] { return impulseMatrixX(system, phi, normals, stokes, ship.density); });
    times.timed("adjoint vectors", share,
                [&] { return adjointVectors(system, normals, ship.density, &stokes); });
    const std::vector<IncidentVelocity> waves{incidentNormalVelocity(
        matrices.mesh(), AiryWave{omega, kHeadings[1], ship.gravity}, ship.cog)};
    times.timed("one wave's diffraction, even and odd", share,
                [&] { return diffraction(system, normals, waves, ship.density, &stokes); });
    times.timed("LU of the whole hull's matrix instead", share, [&] {
      return Factorization<Complex>(std::move(whole))
          .solve(Eigen::MatrixXcd::Ones(2 * matrices.hullPanels(), 1));
    });
  }
}

/// The report's: Green functions and H, inverses.
void timeReports(const Mesh& mesh, const std::vector<double>& omegas, Breakdown& times) {
  const ShipParticulars& ship = mesh.ship;
  const std::string sources = "sources, 4 x 4 points: ";
  const InfluenceMatrices matrices = times.timed(sources + "Rankine integrals (once)", 1.0, [&] {
    return InfluenceMatrices(WetSurface(ship.wetSurface, ship.symmetric).panels(),
                             {Formulation::Source, true, 4, 4, 1});
  });
  const double share = 1.0 / static_cast<double>(omegas.size());
  for (const double omega : omegas) {
    const auto systems = times.timed(sources + "wave terms and assembly", share, [&] {
      return matrices.atWaveNumber(omega * omega / ship.gravity);
    });
    times.timed(sources + "inverses of even and odd matrices", share, [&] {
      const auto n = systems[0].L.rows();
      const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(n, n);
      return (Factorization<Complex>(systems[0].L).solve(one) +
              Factorization<Complex>(systems[1].L).solve(one))
          .norm();
    });
  }
}

}  // namespace

void writeTable3(const Job& job) {
  const OneBlasThread oneThread;
  std::vector<double> omegas;
  for (double omega = 0.5; omega < 6.0; omega += 1.0 * job.every) omegas.push_back(omega);
  std::vector<Breakdown> columns;
  std::string header = "task_cpu_seconds_per_frequency";
  for (const Mesh& mesh : job.meshes) {
    header += ",panels_" + std::to_string(mesh.panels);
    columns.emplace_back();
    timeOurs(mesh, omegas, columns.back());
    timeReports(mesh, omegas, columns.back());
  }
  command::Csv csv(header);
  for (std::size_t i = 0; i < columns.front().tasks().size(); ++i) {
    std::vector<double> row;
    for (const Breakdown& column : columns) row.push_back(column.tasks()[i].second);
    csv.row(row, "\"" + columns.front().tasks()[i].first + "\",");
  }
  csv.write(job.file("table3.csv"));
}

namespace {

/// Excitation of all conditions of Table 4 from the database.  @return their number.
int readConditions(const Coefficients& database, const std::vector<double>& waveOmega) {
  const WaveExcitation excitation(database);
  int count = 0;
  for (int knots = 0; knots <= 30; knots += 5) {
    for (const double heading : kHeadings) {
      for (const double omega : waveOmega) {
        excitation.at(omega, heading, knots * kKnot);
        ++count;
      }
    }
  }
  return count;
}

}  // namespace

std::vector<Sweeps> writeTable4(const Job& job) {
  command::Csv csv(
      "panels,lid_panels,omega_e_first,omega_e_last,omega_e_count,speed_first_knots,"
      "speed_last_knots,speed_count,headings_deg,omega_i_first,omega_i_last,omega_i_count,"
      "conditions,build_cpu_s,build_wall_s,conditions_cpu_s,file_bytes,"
      "resolved_omega,resolved_omega_without_lid");
  std::vector<Sweeps> sweeps;
  const std::vector<double> waveOmega = job.waveOmega();
  for (const Mesh& mesh : job.meshes) {
    const CpuTime cpu;
    const auto begin = std::chrono::steady_clock::now();
    SolverOutput output = buildCoefficients(mesh.ship, ours(job));
    const double build = cpu.seconds();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    Coefficients database = finish(std::move(output));
    const CpuTime reading;
    const int conditions = readConditions(database, waveOmega);
    const double read = reading.seconds();
    const std::string name = job.file("frigate_" + std::to_string(mesh.panels) + ".h5");
    writeCoefficients(database, name);
    SolverOutput sources = buildCoefficients(mesh.ship, reports(job, 4, 4));
    const std::vector<double>& omega = database.omega;
    const auto number = [](double value) { return csvNumber(value) + ","; };
    csv.row({static_cast<double>(conditions), build, wall.count(), read,
             static_cast<double>(std::filesystem::file_size(name)), database.resolvedOmega,
             sources.resolvedOmega},
            std::to_string(mesh.panels) + "," +
                std::to_string(makeLid(mesh.ship.wetSurface, mesh.ship.symmetric).size()) + "," +
                number(omega.front()) + number(omega.back()) + std::to_string(omega.size()) +
                ",0,30,7,30 150 165 180," + number(waveOmega.front()) + number(waveOmega.back()) +
                std::to_string(waveOmega.size()) + ",");
    sweeps.push_back({std::move(database), std::move(sources)});
  }
  csv.write(job.file("table4.csv"));
  return sweeps;
}

}  // namespace cutwater::report
