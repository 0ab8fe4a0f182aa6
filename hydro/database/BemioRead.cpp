#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/Errors.h"
#include "hydro/database/BemioContradictions.h"
#include "hydro/database/BemioLayout.h"
#include "hydro/database/CutwaterGroup.h"

namespace cutwater {

namespace {

using hdf5::Array;
using hdf5::Shape;

constexpr const char* kParameters = "simulation_parameters/";
constexpr const char* kExcitation = "body1/hydro_coeffs/excitation/";

class BemioReader {
 public:
  BemioReader(const hdf5::Reader& file, std::vector<std::string>& missing)
      : file_(file), missing_(missing) {}

  Coefficients read() {
    readParameters();
    readProperties();
    readRadiation();
    if (file_.has(std::string(kExcitation) + "re") &&
        file_.has(std::string(kParameters) + "wave_dir")) {
      readExcitation();
    } else {
      missing_.emplace_back("no excitation");
    }
    return std::move(c_);
  }

 private:
  [[noreturn]] void malformed(const std::string& what) const {
    throw HydroError(Fault::FileMalformed, fmt::format("{}: {}", file_.path(), what));
  }
  Array numbers(const std::string& name, std::size_t count) const {
    Array array = file_.numbers(name);
    if (array.data.size() != count) {
      malformed(fmt::format("{} has {} numbers, {} expected", name, array.data.size(), count));
    }
    return array;
  }
  double scalar(const std::string& name) const { return numbers(name, 1).data[0]; }
  Vec3 vector(const std::string& name) const { return Vec3(numbers(name, 3).data.data()); }
  std::string textOr(const std::string& name, const std::string& otherwise) const {
    return file_.has(name) && file_.isText(name) ? file_.text(name) : otherwise;
  }

  void readParameters() {
    const std::string group = kParameters;
    c_.provenance.code = textOr("bem_data/code", "of unknown origin");
    c_.ship.density = scalar(group + "rho");
    c_.ship.gravity = scalar(group + "g");
    if (file_.has(group + "scaled") && scalar(group + "scaled") != 0.0) {
      throw HydroError(Fault::FormatNotSupported,
                       file_.path() +
                           ": simulation_parameters/scaled = 1; only normalised "
                           "coefficients (scaled = 0) are read");
    }
    c_.omega = file_.numbers(group + "w").data;
    if (c_.omega.empty()) malformed("simulation_parameters/w is empty");
    checkIncreasing(file_.path(), group + "w", c_.omega, 0.0);
    readDepth(group + "water_depth");
  }

  void readDepth(const std::string& name) {
    if (!file_.has(name) || file_.isText(name)) return;
    const double depth = scalar(name), k = c_.omega.front() * c_.omega.front() / c_.ship.gravity;
    if (std::isfinite(depth) && k * depth < kPi) {
      missing_.push_back(
          fmt::format("water depth {:g} m is not deep for w = {:g} rad/s, taken as "
                      "infinite",
                      depth, c_.omega.front()));
    }
  }

  void readProperties() {
    const std::string group = "body1/properties/";
    ShipParticulars& ship = c_.ship;
    ship.name = textOr(group + "name", "body1");
    ship.volume = scalar(group + "disp_vol");
    ship.cog = vector(group + "cg");
    ship.centreOfBuoyancy = vector(group + "cb");
    ship.mass = ship.density * ship.volume;
    ship.gyradii = Vec3::Zero();
    // Symmetric for a free body, so a MATLAB writer's transposition does not matter.
    const Array c = numbers(std::string(kBemioCoefficients) + "linear_restoring_stiffness", 36);
    for (int i = 0; i < 36; ++i) {
      ship.restoring(i / 6, i % 6) =
          c.data[static_cast<std::size_t>(i)] * ship.density * ship.gravity;
    }
    missing_.emplace_back("no hull, gyradii, x-derivatives or adjoint vectors");
    missing_.emplace_back("mass taken as density x volume");
    if (file_.has("body2")) missing_.emplace_back("several bodies: body1 alone is read");
  }

  /// (6, 6 Nb[, n]) × factor(i): the six columns of body 1's own motions.
  template <class Factor>
  std::vector<Mat6> series(const std::string& name, std::size_t n, Factor factor) const {
    const Array array = file_.numbers(name);
    const bool shaped = array.shape.size() >= 2 && array.shape[0] == 6 && array.shape[1] >= 6 &&
                        array.shape[1] % 6 == 0 && array.data.size() == 6 * array.shape[1] * n;
    if (!shaped) malformed(fmt::format("{} is not (6, 6 bodies, {})", name, n));
    std::vector<Mat6> result(n);
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
          const double value = array.data[(j * array.shape[1] + k) * n + i];
          if (!std::isfinite(value)) notFinite(name, j, fmt::format("k = {}", k + 1), n, i);
          result[i](static_cast<int>(j), static_cast<int>(k)) = factor(i) * value;
        }
      }
    }
    return result;
  }

  /// @param j  from 0.  @param n  how many frequencies the dataset has; i is one of them.
  [[noreturn]] void notFinite(const std::string& name, std::size_t j, const std::string& column,
                              std::size_t n, std::size_t i) const {
    const bool limit = n == 1 && c_.omega.size() != 1;
    const std::string at = limit ? "infinity" : fmt::format("{:.6g} rad/s", c_.omega[i]);
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: {} is not finite at j = {}, {}, omega = {}", file_.path(),
                                 name, j + 1, column, at));
  }

  void readRadiation() {
    const std::string group = kBemioCoefficients;
    const double rho = c_.ship.density;
    const std::size_t n = c_.omega.size();
    const auto byDensity = [rho](std::size_t) { return rho; };
    c_.addedMass.values = series(group + "added_mass/all", n, byDensity);
    c_.addedMass.atInfinity = series(group + "added_mass/inf_freq", 1, byDensity).front();
    c_.damping.values = series(group + "radiation_damping/all", n,
                               [&](std::size_t i) { return rho * c_.omega[i]; });
    c_.addedMass.atZero = c_.addedMass.values.front();
    refuseMemoryOf(bemioContradictions(c_));
    missing_.push_back(fmt::format("A(0) taken as A({:g} rad/s)", c_.omega.front()));
  }

  /// What no memory can come of is left to the frequency domain.
  void refuseMemoryOf(const std::vector<std::string>& contradictions) {
    if (contradictions.empty()) return;
    c_.status = CoefficientStatus::Unfinished;
    c_.unfinishedBecause = fmt::format("{}", fmt::join(contradictions, "; "));
    missing_.push_back("for the frequency domain only: " + c_.unfinishedBecause);
  }

  /// Complex amplitudes [heading][frequency] in our units and phase; empty if absent, or NaN in one
  /// of the two parts.
  std::vector<std::vector<CVec6>> excitation(const std::string& group) const {
    const std::size_t n = c_.omega.size(), headings = c_.headings.size();
    if (!file_.has(group + "re") || !file_.has(group + "im")) return {};
    const Array re = numbers(group + "re", 6 * headings * n);
    const Array im = numbers(group + "im", 6 * headings * n);
    std::vector result(headings, std::vector<CVec6>(n));
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t h = 0; h < headings; ++h) {
        for (std::size_t i = 0; i < n; ++i) {
          const std::size_t at = (j * headings + h) * n + i;
          if (!std::isfinite(re.data[at]) || !std::isfinite(im.data[at])) {
            if (group != kExcitation) return {};  // a part that the other code did not compute
            notFinite(group + "re or im", j, fmt::format("heading {}", h + 1), n, i);
          }
          result[h][i](static_cast<int>(j)) = toOurs(h, i) * Complex(re.data[at], im.data[at]);
        }
      }
    }
    return result;
  }

  /// ρg, and the crest moved from the origin of the axes to G.
  Complex toOurs(std::size_t heading, std::size_t i) const {
    const double beta = c_.headings[heading], k = c_.omega[i] * c_.omega[i] / c_.ship.gravity;
    const double along = c_.ship.cog.x() * std::cos(beta) - c_.ship.cog.y() * std::sin(beta);
    return std::polar(c_.ship.density * c_.ship.gravity, k * along);
  }

  void readExcitation() {
    c_.headings = file_.numbers(std::string(kParameters) + "wave_dir").data;
    for (double& heading : c_.headings) {
      const double degrees = std::remainder(-heading, 360.0);
      heading = (degrees <= -180.0 ? 180.0 : degrees) * kPi / 180.0;
    }
    const std::string group = kExcitation;
    const auto total = excitation(group);
    if (total.empty()) malformed("excitation/im is missing");
    c_.froudeKrylov = excitation(group + "froude-krylov/");
    c_.diffraction = total;
    if (c_.froudeKrylov.empty()) {
      c_.froudeKrylov.assign(total.size(), std::vector<CVec6>(c_.omega.size(), CVec6::Zero()));
      missing_.emplace_back("no Froude-Krylov part: all excitation counts as diffraction");
    }
    for (std::size_t h = 0; h < total.size(); ++h) {
      for (std::size_t i = 0; i < total[h].size(); ++i)
        c_.diffraction[h][i] -= c_.froudeKrylov[h][i];
    }
    sortHeadings();
  }

  void sortHeadings() {
    std::vector<std::size_t> order(c_.headings.size());
    for (std::size_t h = 0; h < order.size(); ++h) order[h] = h;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return c_.headings[a] < c_.headings[b]; });
    const Coefficients unsorted = c_;
    for (std::size_t h = 0; h < order.size(); ++h) {
      c_.headings[h] = unsorted.headings[order[h]];
      c_.froudeKrylov[h] = unsorted.froudeKrylov[order[h]];
      c_.diffraction[h] = unsorted.diffraction[order[h]];
    }
  }

  const hdf5::Reader& file_;
  std::vector<std::string>& missing_;
  Coefficients c_;
};

}  // namespace

Coefficients readBemio(const hdf5::Reader& reader, std::vector<std::string>& missing) {
  if (!reader.has("simulation_parameters") || !reader.has("body1")) {
    throw HydroError(Fault::FormatNotSupported,
                     reader.path() +
                         ": HDF5, but neither a Cutwater database nor a BEMIO file "
                         "(no /cutwater, no simulation_parameters and body1)");
  }
  return BemioReader(reader, missing).read();
}

}  // namespace cutwater
