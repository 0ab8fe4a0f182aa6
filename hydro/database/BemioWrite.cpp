#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "hydro/Errors.h"
#include "hydro/database/BemioLayout.h"
#include "hydro/database/Interpolation.h"

namespace cutwater {

namespace {

using Excitation = std::vector<std::vector<CVec6>>;  // [heading][frequency], normalised

/// Direction in degrees that waves of heading β travel towards, counter-clockwise, in (−180, 180].
double waveDirection(double beta) {
  const double degrees = std::remainder(-beta * 180.0 / kPi, 360.0);
  return degrees <= -180.0 ? degrees + 360.0 : degrees + 0.0;  // + 0.0 turns −0 into 0
}

class BemioWriter {
 public:
  BemioWriter(hdf5::Writer& writer, const Coefficients& c) : writer_(writer), c_(c) {
    for (double omega : c.omega) period_.push_back(2.0 * kPi / omega);
    for (double beta : c.headings) direction_.push_back(waveDirection(beta));
    order_.resize(c.headings.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return direction_[a] < direction_[b]; });
  }

  void writeParameters() {
    const std::string group = "simulation_parameters/";
    writer_.text("bem_data/code", "Cutwater");
    scalar(group + "rho", c_.ship.density, "Water density", "kg/m^3");
    scalar(group + "g", c_.ship.gravity, "Gravitational acceleration", "m/s^2");
    scalar(group + "scaled", 0.0, "0: normalised by rho, rho w, rho g; the reader multiplies", "");
    column(group + "w", c_.omega, "Wave frequencies", "rad/s");
    column(group + "T", period_, "Wave periods", "s");
    std::vector<double> sorted;
    for (std::size_t h : order_) sorted.push_back(direction_[h]);
    if (!sorted.empty())
      column(group + "wave_dir", sorted, "Direction waves travel towards", "deg");
    writer_.text(group + "water_depth", "infinite");
  }

  void writeProperties() {
    const std::string group = "body1/properties/";
    const ShipParticulars& ship = c_.ship;
    writer_.text(group + "name", ship.name.empty() ? "ship" : ship.name);
    scalar(group + "body_number", 1.0, "Number of the body", "");
    scalar(group + "disp_vol", ship.volume, "Displaced volume", "m^3");
    scalar(group + "dof", 6.0, "Degrees of freedom", "");
    scalar(group + "dof_start", 1.0, "First degree of freedom", "");
    scalar(group + "dof_end", 6.0, "Last degree of freedom", "");
    column(group + "cg", {ship.cog.begin(), ship.cog.end()}, "Centre of gravity", "m");
    column(group + "cb", {ship.centreOfBuoyancy.begin(), ship.centreOfBuoyancy.end()},
           "Centre of buoyancy", "m");
  }

  void writeRadiation(const ImpulseResponse& retardation) {
    const std::string group = "body1/hydro_coeffs/";
    const double rho = c_.ship.density;
    matrix(group + "linear_restoring_stiffness", c_.ship.restoring / (rho * c_.ship.gravity),
           "Hydrostatic stiffness / (rho g)");
    matrix(group + "added_mass/inf_freq", c_.addedMass.atInfinity / rho,
           "Added mass at infinity / rho");
    std::vector<Mat6> a, b;
    for (std::size_t i = 0; i < c_.omega.size(); ++i) {
      a.push_back(c_.addedMass[i] / rho);
      b.push_back(c_.damping[i] / (rho * c_.omega[i]));
    }
    series(group + "added_mass/", "all", "components/", period_, a, "Added mass / rho");
    series(group + "radiation_damping/", "all", "components/", period_, b, "Damping / (rho w)");
    if (!retardation.values.empty()) writeRetardation(retardation);
  }

  void writeExcitation() {
    if (c_.headings.empty()) return;
    const std::string group = "body1/hydro_coeffs/excitation/";
    const Excitation fk = normalised(c_.froudeKrylov), scattering = normalised(c_.diffraction);
    Excitation total = fk;
    for (std::size_t h = 0; h < total.size(); ++h) {
      for (std::size_t i = 0; i < total[h].size(); ++i) total[h][i] += scattering[h][i];
    }
    excitation(group, total);
    excitation(group + "froude-krylov/", fk);
    excitation(group + "scattering/", scattering);
    if (c_.status != CoefficientStatus::Unfinished) writeExcitationResponse(total);
  }

 private:
  void scalar(const std::string& name, double value, const char* description, const char* units) {
    writer_.numbers(name, {1, 1}, {&value, 1}, description, units);
  }
  void column(const std::string& name, const std::vector<double>& values, const char* description,
              const char* units) {
    writer_.numbers(name, {values.size(), 1}, values, description, units);
  }
  void matrix(const std::string& name, const Mat6& m, const char* description) {
    const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> rows = m;
    writer_.numbers(name, {6, 6}, {rows.data(), 36}, description, "");
  }
  /// (n, 2): abscissa, value.
  template <class Value>
  void component(const std::string& name, const std::vector<double>& abscissa, Value value) {
    std::vector<double> pairs;
    for (std::size_t i = 0; i < abscissa.size(); ++i) {
      pairs.insert(pairs.end(), {abscissa[i], value(i)});
    }
    writer_.numbers(name, {abscissa.size(), 2}, pairs, "abscissa, value", "");
  }

  void series(const std::string& group, const char* all, const char* components,
              const std::vector<double>& abscissa, const std::vector<Mat6>& values,
              const char* description) {
    std::vector<double> data;
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) {
        for (const Mat6& m : values) data.push_back(m(j, k));
        component(fmt::format("{}{}{}_{}", group, components, j + 1, k + 1), abscissa,
                  [&](std::size_t i) { return values[i](j, k); });
      }
    }
    writer_.numbers(group + all, {6, 6, values.size()}, data, description, "");
  }

  void writeRetardation(const ImpulseResponse& retardation) {
    const std::string group = "body1/hydro_coeffs/radiation_damping/impulse_response_fun/";
    std::vector<double> t;
    std::vector<Mat6> k;
    for (const Mat6& value : retardation.values) {
      t.push_back(retardation.step * static_cast<double>(t.size()));
      k.push_back(value / c_.ship.density);
    }
    series(group, "K", "components/K/", t, k, "Retardation function / rho");
    column(group + "t", t, "Time", "s");
    column(group + "w", c_.omega, "Frequencies it was made from", "rad/s");
  }

  /// / (ρ g), headings sorted, crest over the origin.
  Excitation normalised(const Excitation& force) const {
    Excitation result;
    const double scale = 1.0 / (c_.ship.density * c_.ship.gravity);
    for (std::size_t h : order_) {
      const double beta = c_.headings[h];
      const double along = c_.ship.cog.x() * std::cos(beta) - c_.ship.cog.y() * std::sin(beta);
      result.emplace_back();
      for (std::size_t i = 0; i < c_.omega.size(); ++i) {
        const double k = c_.omega[i] * c_.omega[i] / c_.ship.gravity;
        result.back().push_back(scale * std::polar(1.0, -k * along) * force[h][i]);
      }
    }
    return result;
  }

  void excitation(const std::string& group, const Excitation& force) {
    part(group, "re", force, [](Complex x) { return x.real(); });
    part(group, "im", force, [](Complex x) { return x.imag(); });
    part(group, "mag", force, [](Complex x) { return std::abs(x); });
    part(group, "phase", force, [](Complex x) { return std::arg(x); });
  }

  template <class Part>
  void part(const std::string& group, const char* name, const Excitation& force, Part of) {
    std::vector<double> data;
    for (int j = 0; j < 6; ++j) {
      for (std::size_t h = 0; h < force.size(); ++h) {
        for (const CVec6& x : force[h]) data.push_back(of(x(j)));
        component(fmt::format("{}components/{}/{}_{}", group, name, j + 1, h + 1), period_,
                  [&](std::size_t i) { return of(force[h][i](j)); });
      }
    }
    writer_.numbers(group + name, {6, force.size(), c_.omega.size()}, data,
                    "Excitation / (rho g) per metre, crest over the origin",
                    std::string(name) == "phase" ? "rad" : "");
  }

  void writeExcitationResponse(const Excitation& total);

  hdf5::Writer& writer_;
  const Coefficients& c_;
  std::vector<double> period_, direction_;
  std::vector<std::size_t> order_;  // headings by wave_dir
};

/// f(t) = (1/π) ∫₀^Ω [re cos ωt − im sin ωt] dω by the trapezoidal rule on a grid five times as
/// fine as the data, which are interpolated by local cubics (held constant below the first).
void BemioWriter::writeExcitationResponse(const Excitation& total) {
  const std::string group = "body1/hydro_coeffs/excitation/impulse_response_fun/";
  const double last = c_.omega.back(), n = static_cast<double>(c_.omega.size());
  const double range = kPi * n / last, step = kPi / (4.0 * last);  // π/Δω; eight points a period
  const auto half = static_cast<Eigen::Index>(range / step),
             fine = static_cast<Eigen::Index>(5.0 * n);
  const Eigen::VectorXd t =
      step * Eigen::VectorXd::LinSpaced(2 * half + 1, -static_cast<double>(half),
                                        static_cast<double>(half));
  const Eigen::VectorXd w = Eigen::VectorXd::LinSpaced(fine + 1, 0.0, last);
  const auto rows = static_cast<Eigen::Index>(total.size());
  Eigen::MatrixXcd spectrum(fine + 1, 6 * rows);  // column of mode j, heading h: j rows + h
  for (Eigen::Index i = 0; i <= fine; ++i) {
    const LocalCubic local = localCubic(c_.omega, std::clamp(w(i), c_.omega.front(), last));
    const double weight = (i == 0 || i == fine ? 0.5 : 1.0) * (w(1) - w(0)) / kPi;
    for (Eigen::Index column = 0; column < 6 * rows; ++column) {
      Complex sum = 0.0;
      for (std::size_t p = 0; p < local.count; ++p) {
        sum += local.weight[p] *
               total[static_cast<std::size_t>(column % rows)][local.first + p](column / rows);
      }
      spectrum(i, column) = weight * sum;
    }
  }
  const Eigen::MatrixXd phase = t * w.transpose();
  const Eigen::MatrixXd f = phase.array().cos().matrix() * spectrum.real() -
                            phase.array().sin().matrix() * spectrum.imag();
  const std::vector<double> times(t.begin(), t.end());
  for (Eigen::Index column = 0; column < 6 * rows; ++column) {
    component(fmt::format("{}components/f/{}_{}", group, column / rows + 1, column % rows + 1),
              times, [&](std::size_t i) { return f(static_cast<Eigen::Index>(i), column); });
  }
  writer_.numbers(group + "f", {6, total.size(), times.size()},
                  {f.data(), static_cast<std::size_t>(f.size())},
                  "Excitation impulse response / (rho g)", "");
  column(group + "t", times, "Time", "s");
  column(group + "w", {w.begin(), w.end()}, "Frequencies integrated over", "rad/s");
}

}  // namespace

void writeBemio(hdf5::Writer& writer, const Coefficients& coefficients,
                const ImpulseResponse& retardation) {
  for (const Mat6& value : retardation.values) {
    if (value.allFinite() && retardation.step > 0.0) continue;
    throw HydroError(Fault::ValueOutOfRange,
                     "writeCoefficients: the retardation table is not finite or its step not > 0");
  }
  BemioWriter bemio(writer, coefficients);
  bemio.writeParameters();
  bemio.writeProperties();
  bemio.writeRadiation(retardation);
  bemio.writeExcitation();
}

}  // namespace cutwater
