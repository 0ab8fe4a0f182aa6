#pragma once
#include <ctime>
#include <string>
#include <vector>

#include "demos/cutwater/output/Csv.h"
#include "hydro/bem/BuildCoefficients.h"
#include "hydro/ship/Afloat.h"

/// The tables and figures of [M03] for our stand-in of the report's frigate; report_figures.cpp.
namespace cutwater::report {

constexpr double kLength = 124.5;           ///< L between perpendiculars [m]
constexpr double kKnot = 1852.0 / 3600.0;   ///< [m/s]
constexpr double kSpeed = 20.0 * kKnot;     ///< U of all figures [m/s]
constexpr double kDegree = kPi / 180.0;     ///< [rad]
inline const std::vector<double> kHeadings  ///< β of Table 4 [rad]
    {30.0 * kDegree, 150.0 * kDegree, 165.0 * kDegree, 180.0 * kDegree};

/// One of the three meshes afloat, G above its centre of buoyancy, no supplementary terms.
struct Mesh {
  int panels;  ///< a side, as in the report and in the file's name
  ShipParticulars ship;
  Hydrostatics afloat;
};

/// What is asked for.
struct Job {
  std::string folder;        ///< for the CSV files
  std::vector<Mesh> meshes;  ///< 224, 433, 1040, or one of them
  int every = 1;             ///< every n-th frequency

  std::string file(const std::string& name) const { return folder + "/" + name; }
  /// The report's for Figures 6 and 21 to 24, if it is there.
  const Mesh& medium() const { return meshes[meshes.size() / 2]; }
  /// ω_e of Table 4, 0.1 … 6.0 rad/s, every `every`-th.
  std::vector<double> omega() const;
  /// ω_I of Table 4, 0.20 … 2.0 rad/s, likewise.
  std::vector<double> waveOmega() const;
};

/// @param shipFile  SHIP.toml of the frigate; the other meshes are beside the one it names.
/// @param panels    0: all three.  @throws HydroError.
std::vector<Mesh> readMeshes(const std::string& shipFile, int panels);

/// Our way: potential formulation, ∂φ/∂x by Stokes' theorem, lid.
SolveSettings ours(const Job& job);
/// The report's: sources, ∂φ/∂x = Hσ, fixed Gauss points, no lid.
SolveSettings reports(const Job& job, int sourcePoints, int galerkinPoints);

/// Δ r_jj² √(g/L), r = 1 m for translations: what the report divides B_jj and U∂A_jj by [N s/m, N m
/// s].
double dampingUnit(const ShipParticulars& ship, int mode);

/// Processor time of all threads since it was made [s].
class CpuTime {
 public:
  double seconds() const {
    return static_cast<double>(std::clock() - start_) / static_cast<double>(CLOCKS_PER_SEC);
  }

 private:
  std::clock_t start_ = std::clock();
};

/// Both sweeps of one mesh, ω_e of the job.
struct Sweeps {
  Coefficients ours;     ///< finished, as `cutwater solve` writes it
  SolverOutput reports;  ///< 4 source, 4 Galerkin points
};

void writeTable2(const Job& job);
void writeTable3(const Job& job);
/// Writes the three databases as well.  @return ours and the report's sweep of each mesh.
std::vector<Sweeps> writeTable4(const Job& job);
void writeFigure6(const Job& job, const Sweeps& medium);
void writeFigures7To12(const Job& job, const std::vector<Sweeps>& sweeps);
void writeFigures15To20(const Job& job, const std::vector<Sweeps>& sweeps);
/// And differences.csv: how far the four means of Influence are from Direct, and their times.
void writeFigures21To24(const Job& job, const Sweeps& medium);
/// Retardation functions K⁰_jj, U K^U_jj, U² K^UU_jj over 20 s, report's form, in units of Δ r_jj²
/// g/L.
void writeFigures25To30(const Job& job, const Sweeps& medium);
/// Still water on the medium mesh held in heave (F₃/Δg − 1), roll and pitch (arms F/Δg [m]), beside
/// its linearisation.
void writeFigures34To36(const Job& job);

}  // namespace cutwater::report
