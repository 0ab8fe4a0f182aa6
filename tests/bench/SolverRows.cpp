#include <filesystem>

#include "hydro/bem/matrices/InfluenceMatrices.h"
#include "hydro/bem/solution/Diffraction.h"
#include "hydro/database/CoefficientsFile.h"
#include "hydro/green/WaveTerm.h"
#include "hydro/solve/Solve.h"
#include "tests/bem/Bodies.h"
#include "tests/bench/Rows.h"

namespace cutwater::bench {
namespace {

PanelMesh meshOf(const ShipParticulars& ship, bool lid) {
  return test::panels(ship.wetSurface, true, lid);
}

/// Processor seconds of LU of even and odd matrices of n unknowns in single precision, as the
/// solver does it: one thread, in memory that is there already.
double luSeconds(int n) {
  const OneBlasThread one;
  auto workspace = Factorization<Complex>(Eigen::MatrixXcd::Random(n, n)).release();
  std::unique_ptr<Factorization<Complex>> factors;
  const Time time = timeOf([&] {
    factors = std::make_unique<Factorization<Complex>>(std::move(workspace.matrix),
                                                       std::move(workspace.factors));
  });
  return 2.0 * time.processor;
}

/// All LU factorizations of a sweep, one thread: without lid panels where the lid is idle.
double luFloor(const ShipParticulars& ship, const SolveSettings& settings) {
  const PanelMesh mesh = meshOf(ship, settings.lid);
  const auto hull = static_cast<int>(mesh.panels.size()),
             all = hull + static_cast<int>(mesh.lid.size());
  int idle = 0;
  for (const double omega : settings.omega)
    idle += settings.lid && omega * omega / ship.gravity <= lidFrom(mesh) ? 1 : 0;
  const auto busy = static_cast<int>(settings.omega.size()) - idle;
  return idle * luSeconds(hull) + busy * luSeconds(all);
}

double checksumOf(const SolverOutput& c) {
  double sum = 0.0;
  for (const Mat6& a : c.addedMass) sum += a.trace() / c.ship.mass;
  for (const Mat6& b : c.damping) sum += b.trace() / c.ship.mass;
  return sum;
}

void benchDatabase(std::string& csv, const std::string& name, int panels, int threads, bool lid,
                   double budget) {
  const ShipParticulars ship = frigate(panels);
  SolveSettings settings = sweep(60, threads);
  settings.lid = lid;
  Row row{name + (lid ? "" : ", no lid"), ship.wetSurface.faces.size(), threads};
  SolverOutput result;
  const Time time = timeOf([&] { result = buildCoefficients(ship, settings); });
  row.seconds = time.seconds;
  row.processor = time.processor;
  row.floor = luFloor(ship, settings);
  row.budget = budget;
  row.checksum = checksumOf(result);
  add(csv, row);
}

/// Seconds per frequency with lid, the set-up shared by 60: of a few frequencies about the middle
/// of the grid.
void benchFrequency(std::string& csv, int panels, int threads, int frequencies) {
  const ShipParticulars ship = frigate(panels);
  SolveSettings settings = sweep(0, threads), none = settings;
  for (int i = 0; i < frequencies; ++i) settings.omega.push_back(2.0 + 0.1 * i);
  const PanelMesh mesh = meshOf(ship, true);
  InfluenceSettings influence;
  influence.threads = threads;
  const Time setUp = timeOf([&] { const InfluenceMatrices matrices(mesh, influence); });
  SolverOutput result;
  Row row{"seconds per frequency", ship.wetSurface.faces.size(), threads};
  const Time all = timeOf([&] { result = buildCoefficients(ship, settings); });
  const auto each = [&](double total, double shared) {
    return (total - shared) / frequencies + shared / 60.0;
  };
  row.seconds = each(all.seconds, setUp.seconds);
  row.processor = each(all.processor, setUp.processor);
  row.floor = luSeconds(static_cast<int>(mesh.panels.size() + mesh.lid.size()));
  row.checksum = checksumOf(result);
  add(csv, row);
}

/// What one frequency takes, part by part, one thread; the set-up as it is, not shared.
void benchParts(std::string& csv, int panels) {
  const OneBlasThread one;
  const ShipParticulars ship = frigate(panels);
  const PanelMesh mesh = meshOf(ship, true);
  const std::size_t count = mesh.panels.size() + mesh.lid.size();
  const double K = 4.0 / ship.gravity;
  const auto put = [&](const char* part, double seconds, double checksum) {
    add(csv, {std::string("part: ") + part, mesh.panels.size(), 1, seconds, 0.0, 0.0, checksum});
  };
  std::unique_ptr<InfluenceMatrices> matrices;
  const double rankine =
      secondsOf([&] { matrices = std::make_unique<InfluenceMatrices>(mesh, InfluenceSettings{}); });
  put("Rankine integrals (once)", rankine,
      matrices->atLimit(FrequencyLimit::Zero, Parity::Even).R.sum());

  constexpr std::size_t kBatch = 4096;
  std::vector<double> X(kBatch), Y(kBatch), F(kBatch), FX(kBatch), J0(kBatch), J1(kBatch),
      Y0(kBatch), Y1(kBatch);
  for (std::size_t i = 0; i < kBatch; ++i) {
    X[i] = K * 120.0 * static_cast<double>(i % 64) / 64.0 + 0.1;
    Y[i] = K * 9.0 * static_cast<double>(i / 64) / 64.0;
  }
  const double wave = secondsOf([&] {
    for (std::size_t done = 0; done < count * count; done += kBatch)
      waveTerms(X.data(), Y.data(), kBatch,
                {F.data(), FX.data(), J0.data(), J1.data(), Y0.data(), Y1.data()});
  });
  put("wave terms (of assembly)", wave, F[17]);

  auto systems = matrices->atWaveNumber(K);
  const double assembly =
      secondsOf([&] { systems = matrices->atWaveNumber(K, IdleLid::Drop, std::move(systems)); });
  put("assembly", assembly, systems[0].L.sum().real());
  auto workspace = SymmetricSystem<Complex>(systems, 2).release();
  std::unique_ptr<SymmetricSystem<Complex>> system;
  const double lu = secondsOf([&] {
    system = std::make_unique<SymmetricSystem<Complex>>(std::move(systems), 2,
                                                        std::move(workspace.factors));
  });
  put("LU", lu, 0.0);
  const ModeNormals normals(mesh, ship.cog);
  const XDerivative stokes(ship.wetSurface, mesh);
  AdjointVectors b;
  put("solves", secondsOf([&] { b = adjointVectors(*system, normals, ship.density, &stokes); }),
      b.omega.cwiseAbs().sum());
  double condition = 0.0;
  const double estimate = secondsOf([&] { condition = system->condition(Parity::Even); });
  put("condition numbers", 2.0 * estimate, condition);

  SolveSettings settings = sweep(8, 1);
  const Coefficients database = solve(frigate(224), settings);
  const std::string path = (std::filesystem::temp_directory_path() / "cutwater_bench.h5").string();
  put("output (8 frequencies of 224 panels)", secondsOf([&] { writeCoefficients(database, path); }),
      0.0);
  std::filesystem::remove(path);
}

}  // namespace

void benchSolver(std::string& csv) {
  benchDatabase(csv, "medium mesh (433/side)", 433, 1, true, 0.0);
  for (const bool lid : {true, false}) {
    benchDatabase(csv, "medium mesh (433/side)", 433, 2, lid, 2.0);
    benchDatabase(csv, "database of Table 4, fine mesh (1040/side)", 1040, 2, lid, 10.0);
  }
  for (const int threads : {1, 2}) {
    benchFrequency(csv, 224, threads, 16);
    benchFrequency(csv, 433, threads, 16);
    benchFrequency(csv, 1040, threads, 8);
    benchFrequency(csv, 2000, threads, 4);
    benchFrequency(csv, 4000, threads, 2);
  }
  benchParts(csv, 433);
  benchParts(csv, 1040);
}

}  // namespace cutwater::bench
