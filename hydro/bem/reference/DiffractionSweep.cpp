#include "hydro/bem/reference/DiffractionSweep.h"

#include <algorithm>
#include <cmath>

#include "hydro/base/ParallelFor.h"
#include "hydro/database/ForwardSpeed.h"

namespace cutwater {
namespace {

using Systems = std::array<InfluenceSystem<Complex>, 2>;

struct Condition {
  std::size_t place;  ///< in the table
  AiryWave wave;
  Encounter met;
};

/// Conditions of one ω_e, which share a system.
struct Group {
  double omegaE;
  std::vector<Condition> conditions;
};

/// ω_e that differ by round-off only are the same system.
constexpr double kSame = 1e-9;  // [rad/s]

std::vector<Group> groups(const DiffractionTable& table, double gravity) {
  std::vector<Condition> all;
  for (const double speed : table.speeds)
    for (const double heading : table.headings)
      for (const double omega : table.waveOmega)
        all.push_back({all.size(), AiryWave{omega, heading, gravity},
                       Encounter(omega, speed, heading, gravity)});
  std::stable_sort(all.begin(), all.end(), [](const Condition& a, const Condition& b) {
    return a.met.frequency() < b.met.frequency();
  });
  std::vector<Group> result;
  for (const Condition& c : all) {
    const double omegaE = c.met.frequency();
    if (result.empty() || omegaE > result.back().omegaE + kSame) result.push_back({omegaE, {}});
    result.back().conditions.push_back(c);
  }
  return result;
}

/// Of a system without lid, at ω = 0, one as large as the others: idle lid rows.
InfluenceSystem<Complex> extended(const InfluenceSystem<double>& hull, Eigen::Index all) {
  const Eigen::Index n = hull.L.rows();
  InfluenceSystem<Complex> system;
  system.formulation = hull.formulation;
  system.L = -Eigen::MatrixXcd::Identity(all, all);
  system.L.topLeftCorner(n, n) = hull.L.cast<Complex>();
  const bool source = hull.formulation == Formulation::Source;
  system.R = Eigen::MatrixXcd::Zero(source ? n : all, source ? all : n);
  system.R.topLeftCorner(n, n) = hull.R.cast<Complex>();
  if (hull.H.size() == 0) return system;
  system.H = Eigen::MatrixXcd::Zero(n, all);
  system.H.leftCols(n) = hull.H.cast<Complex>();
  return system;
}

Systems mix(const Systems& a, const Systems& b, double t) {
  Systems mixed = a;
  for (std::size_t p = 0; p < 2; ++p) {
    mixed[p].L += t * (b[p].L - a[p].L);
    mixed[p].R += t * (b[p].R - a[p].R);
    if (a[p].H.size() > 0) mixed[p].H += t * (b[p].H - a[p].H);
  }
  return mixed;
}

class DiffractionSweep {
 public:
  DiffractionSweep(const SolverParts& parts, const SolveSettings& settings,
                   const std::vector<double>& grid, DiffractionTable& table)
      : parts_(parts), settings_(settings), table_(table) {
    nodes_.push_back(0.0);
    nodes_.insert(nodes_.end(), grid.begin(), grid.end());
  }

  /// All groups between node `interval` and the next; after the last node: each by itself.
  void solve(std::size_t interval, const std::vector<Group>& groups) const {
    const double from = nodes_[interval];
    const bool beyond = interval + 1 == nodes_.size();
    const double to = beyond ? 0.0 : nodes_[interval + 1];
    std::vector<const Group*> inside;
    for (const Group& group : groups)
      if (group.omegaE >= from && (beyond || group.omegaE < to)) inside.push_back(&group);
    if (inside.empty()) return;
    if (beyond || settings_.influence == Influence::Direct) {
      for (const Group* group : inside) force(factored(systemsAt(group->omegaE)), *group);
      return;
    }
    const Systems low = systemsAt(from), high = systemsAt(to);
    if (settings_.influence == Influence::Matrix) {
      for (const Group* group : inside)
        force(factored(mix(low, high, (group->omegaE - from) / (to - from))), *group);
      return;
    }
    const SymmetricSystem<Complex> atLow = factored(low), atHigh = factored(high);
    for (const Group* group : inside)
      force(SymmetricSystem<Complex>::betweenInverses(atLow, atHigh,
                                                      (group->omegaE - from) / (to - from)),
            *group);
  }

  std::size_t intervals() const { return nodes_.size(); }

 private:
  Systems systemsAt(double omega) const {
    const InfluenceMatrices& matrices = parts_.matrices;
    if (omega > kSame)
      return matrices.atWaveNumber(omega * omega / parts_.ship.gravity, IdleLid::Keep);
    const auto all =
        static_cast<Eigen::Index>(matrices.mesh().panels.size() + matrices.mesh().lid.size());
    Systems systems;
    for (int p = 0; p < matrices.parities(); ++p)
      systems[static_cast<std::size_t>(p)] =
          extended(matrices.atLimit(FrequencyLimit::Zero, static_cast<Parity>(p)), all);
    return systems;
  }

  SymmetricSystem<Complex> factored(Systems systems) const {
    return {std::move(systems), parts_.matrices.parities()};
  }

  void force(const SymmetricSystem<Complex>& system, const Group& group) const {
    std::vector<IncidentVelocity> waves;
    for (const Condition& c : group.conditions)
      waves.push_back(atEncounter(
          incidentNormalVelocity(parts_.matrices.mesh(), c.wave, parts_.ship.cog), c.met));
    const bool tuck = settings_.forwardSpeed == ForwardSpeedForm::Tuck;
    const auto forces = diffraction(system, parts_.normals, waves, parts_.ship.density,
                                    tuck ? nullptr : &parts_.stokes);
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const Condition& c = group.conditions[i];
      const CVec6 speed = tuck ? tuckSpeedForce(forces[i].omega) : forces[i].speed;
      table_.values[c.place] = c.met.diffractionForce(forces[i].omega, speed);
    }
  }

  const SolverParts& parts_;
  const SolveSettings& settings_;
  DiffractionTable& table_;
  std::vector<double> nodes_;  // ω = 0 and the grid
};

}  // namespace

DiffractionTable solveDiffractionTable(const SolverParts& parts, const SolveSettings& settings,
                                       const std::vector<double>& grid, int threads) {
  DiffractionTable table{settings.speeds, settings.headings, settings.waveOmega, {}};
  table.values.resize(table.speeds.size() * table.headings.size() * table.waveOmega.size());
  const std::vector<Group> all = groups(table, parts.ship.gravity);
  const DiffractionSweep sweep(parts, settings, grid, table);
  parallelFor(sweep.intervals(), threads, [&](std::size_t i) { sweep.solve(i, all); });
  return table;
}

}  // namespace cutwater
