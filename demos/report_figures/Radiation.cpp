#include <fmt/format.h>

#include <algorithm>

#include "demos/report_figures/Report.h"
#include "hydro/database/Interpolation.h"

namespace cutwater::report {

namespace {

/// B_jj and U∂A_jj of one frequency as solved, in the report's units.
std::vector<double> solved(const CoefficientTables& c, std::size_t i, int mode) {
  const double unit = dampingUnit(c.ship, mode);
  return {c.damping[i](mode, mode) / unit, kSpeed * c.addedMassX[i](mode, mode) / unit};
}

/// The same as a database gives it back: beyond the waves that the panels resolve, its
/// continuation.
std::vector<double> read(const CoefficientTables& c, std::size_t i, int mode) {
  const double unit = dampingUnit(c.ship, mode), omega = c.omega[i];
  return {dampingAt(c, omega)(mode, mode) / unit,
          kSpeed * addedMassXAt(c, omega)(mode, mode) / unit};
}

void append(std::vector<double>& row, const std::vector<double>& values) {
  row.insert(row.end(), values.begin(), values.end());
}

double largest(const OverFrequency<Mat6>& matrices, int mode) {
  double most = 0.0;
  for (const Mat6& m : matrices) most = std::max(most, m(mode, mode));
  return most;
}

/// A_jj / max A_jj and B_jj / max B_jj of two modes, and the condition number of their system.
std::vector<double> normalised(const CoefficientTables& c, std::size_t i,
                               const std::vector<int>& modes, bool even) {
  std::vector<double> row;
  for (const int j : modes) row.push_back(c.addedMass[i](j, j) / largest(c.addedMass, j));
  for (const int j : modes) row.push_back(c.damping[i](j, j) / largest(c.damping, j));
  row.push_back((even ? c.conditionEven : c.conditionOdd)[i]);
  return row;
}

std::string columns(const std::vector<int>& modes, const std::string& ending) {
  std::string text;
  for (const char* matrix : {"A", "B"}) {
    for (const int j : modes) text += fmt::format(",{0}{1}{1}{2}", matrix, j + 1, ending);
  }
  return text + ",condition" + ending;
}

void writeConditions(const Job& job, const Sweeps& sweeps, int figure, bool even) {
  const std::vector<int> modes =
      even ? std::vector<int>{Heave, Pitch} : std::vector<int>{Roll, Yaw};
  command::Csv csv("omega_e" + columns(modes, "_sources") + columns(modes, "_lid"));
  for (std::size_t i = 0; i < sweeps.ours.omega.size(); ++i) {
    std::vector<double> row{sweeps.ours.omega[i]};
    append(row, normalised(sweeps.reports, i, modes, even));
    append(row, normalised(sweeps.ours, i, modes, even));
    csv.row(row);
  }
  csv.write(job.file(fmt::format("figure{:02d}.csv", figure)));
}

}  // namespace

void writeFigure6(const Job& job, const Sweeps& medium) {
  std::string header = "omega_e";
  std::vector<SolverOutput> curves;
  const auto curve = [&](const std::string& name, SolverOutput output) {
    header += ",B33_" + name + ",UdA33_" + name;
    curves.push_back(std::move(output));
  };
  for (const auto& [source, galerkin] : {std::pair{1, 1}, {4, 1}, {9, 1}}) {
    curve(fmt::format("sources_{}_{}", source, galerkin),
          buildCoefficients(job.medium().ship, reports(job, source, galerkin)));
  }
  curve("sources_4_4", medium.reports);
  for (const auto& [source, galerkin] : {std::pair{1, 1}, {4, 4}}) {
    SolveSettings settings = ours(job);
    settings.lid = false;
    settings.sourcePoints = source;
    settings.galerkinPoints = galerkin;
    curve(fmt::format("potential_{}_{}", source, galerkin),
          buildCoefficients(job.medium().ship, settings));
  }
  command::Csv csv(header + ",B33_database,UdA33_database");
  for (std::size_t i = 0; i < medium.ours.omega.size(); ++i) {
    std::vector<double> row{medium.ours.omega[i]};
    for (const SolverOutput& c : curves) append(row, solved(c, i, Heave));
    append(row, read(medium.ours, i, Heave));
    csv.row(row);
  }
  csv.write(job.file("figure06.csv"));
}

void writeFigures7To12(const Job& job, const std::vector<Sweeps>& sweeps) {
  for (std::size_t m = 0; m < sweeps.size(); ++m) {
    const int panels = job.meshes[m].panels, figure = panels < 300 ? 7 : panels < 600 ? 9 : 11;
    writeConditions(job, sweeps[m], figure, true);
    writeConditions(job, sweeps[m], figure + 1, false);
  }
}

void writeFigures15To20(const Job& job, const std::vector<Sweeps>& sweeps) {
  for (int mode = Surge; mode <= Yaw; ++mode) {
    std::string header = "omega_e";
    for (const Mesh& mesh : job.meshes) {
      for (const char* method : {"", "_sources"})
        header += fmt::format(",B{0}{0}_{1}{2},UdA{0}{0}_{1}{2}", mode + 1, mesh.panels, method);
    }
    command::Csv csv(header);
    for (std::size_t i = 0; i < sweeps.front().ours.omega.size(); ++i) {
      std::vector<double> row{sweeps.front().ours.omega[i]};
      for (const Sweeps& s : sweeps) {
        append(row, read(s.ours, i, mode));
        append(row, solved(s.reports, i, mode));
      }
      csv.row(row);
    }
    csv.write(job.file(fmt::format("figure{:02d}.csv", 15 + mode)));
  }
}

}  // namespace cutwater::report
