// Writes FOLDER/ship.h5 and FOLDER/ship.csv: one made-up ship as a database and, number by number
// in our own units and conventions, as text. read_with_h5py.py compares the two.
#include <cstdio>
#include <string>

#include "hydro/database/CoefficientsFile.h"
#include "tests/database/SampleShip.h"

namespace {

using namespace cutwater;

class Dump {
 public:
  explicit Dump(const std::string& path) : file_(std::fopen(path.c_str(), "w")) {
    std::fprintf(file_, "name,i,j,k,re,im\n");
  }
  Dump(const Dump&) = delete;
  Dump& operator=(const Dump&) = delete;
  ~Dump() { std::fclose(file_); }
  void row(const char* name, std::size_t i, int j, int k, Complex x) {
    std::fprintf(file_, "%s,%zu,%d,%d,%.17g,%.17g\n", name, i, j, k, x.real(), x.imag());
  }
  void rows(const char* name, std::size_t i, const Mat6& m) {
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) row(name, i, j + 1, k + 1, m(j, k));
    }
  }

 private:
  std::FILE* file_;
};

void dump(const Coefficients& c, const ImpulseResponse& retardation, const std::string& path) {
  Dump to(path);
  to.row("rho", 0, 0, 0, c.ship.density);
  to.row("g", 0, 0, 0, c.ship.gravity);
  to.row("volume", 0, 0, 0, c.ship.volume);
  to.row("step", 0, 0, 0, retardation.step);
  for (int i = 0; i < 3; ++i) {
    to.row("cg", 0, i, 0, c.ship.cog(i));
    to.row("cb", 0, i, 0, c.ship.centreOfBuoyancy(i));
  }
  to.rows("C", 0, c.ship.restoring);
  to.rows("Ainf", 0, c.addedMass.atInfinity);
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    to.row("omega", i, 0, 0, c.omega[i]);
    to.rows("A", i, c.addedMass[i]);
    to.rows("B", i, c.damping[i]);
  }
  for (std::size_t i = 0; i < retardation.values.size(); ++i)
    to.rows("K", i, retardation.values[i]);
  for (std::size_t h = 0; h < c.headings.size(); ++h) {
    to.row("beta", h, 0, 0, c.headings[h]);
    for (std::size_t i = 0; i < c.omega.size(); ++i) {
      for (int j = 0; j < 6; ++j) {
        to.row("FI", i, j + 1, static_cast<int>(h), c.froudeKrylov[h][i](j));
        to.row("FD", i, j + 1, static_cast<int>(h), c.diffraction[h][i](j));
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  const Coefficients ship = test::sampleShip();
  const ImpulseResponse retardation{0.25, {ship.damping[0], ship.damping[1], ship.damping[2]}};
  writeCoefficients(ship, folder + "/ship.h5", retardation);
  dump(ship, retardation, folder + "/ship.csv");
}
