#include <fmt/format.h>

#include <algorithm>

#include "hydro/Errors.h"
#include "hydro/database/CutwaterGroup.h"

namespace cutwater {

namespace {

class Check {
 public:
  Check(const Coefficients& c, const std::string& where) : c_(c), where_(where) {}

  void increasing(const char* name, const std::vector<double>& values, double above) const {
    checkIncreasing(where_, name, values, above);
  }

  void sizes() const {
    const std::size_t n = c_.omega.size();
    if (n == 0) throw HydroError(Fault::DatabaseIncomplete, where_ + ": no frequencies");
    expect("added_mass", c_.addedMass.size(), n);
    expect("damping", c_.damping.size(), n);
    optional("added_mass_x", c_.addedMassX.size(), n);
    expect("damping_x", c_.dampingX.size(), c_.addedMassX.size());
    optional("condition_even", c_.conditionEven.size(), n);
    optional("condition_odd", c_.conditionOdd.size(), n);
    optional("masked", c_.masked.size(), n);
    for (const auto* part : {&c_.froudeKrylov, &c_.diffraction}) {
      const char* name = part == &c_.diffraction ? "diffraction" : "froude_krylov";
      expect(name, part->size(), c_.headings.size());
      for (const auto& heading : *part) expect(name, heading.size(), n);
    }
  }

  void adjoints() const {
    const std::size_t n = c_.omega.size(), panels = c_.ship.wetSurface.faces.size();
    optional("adjoint", c_.adjoint.size(), n);
    optional("adjoint_x", c_.adjointX.size(), n);
    const auto columns = [](const Coefficients::AdjointVectors& b) {
      return static_cast<std::size_t>(b.cols());
    };
    for (const auto& b : c_.adjoint) expect("adjoint", columns(b), panels);
    for (const auto& b : c_.adjointX) expect("adjoint_x", columns(b), panels);
    optional("adjoint_zero", columns(c_.adjoint.atZero), panels);
    optional("adjoint_x_zero", columns(c_.adjointX.atZero), panels);
    optional("adjoint_inf", columns(c_.adjoint.atInfinity), panels);
    optional("adjoint_x_inf", columns(c_.adjointX.atInfinity), panels);
  }

  void table() const {
    const DiffractionTable& t = c_.diffractionTable;
    expect("diffraction_table/values", t.values.size(),
           t.speeds.size() * t.headings.size() * t.waveOmega.size());
    increasing("diffraction_table/wave_omega", t.waveOmega, 0.0);
  }

  void mask() const {
    for (std::size_t i = 0; i < c_.masked.size(); ++i) {
      if (c_.masked[i] == 0 || c_.masked[i] == 1) continue;
      throw HydroError(Fault::ValueOutOfRange,
                       fmt::format("{}: masked[{}] = {}, must be 0 or 1", where_, i, c_.masked[i]));
    }
    for (const auto* envelope : {&c_.conditionLimitEven, &c_.conditionLimitOdd}) {
      std::vector<double> omega;
      for (const auto& point : *envelope) omega.push_back(point.first);
      increasing(envelope == &c_.conditionLimitOdd ? "condition_limit_odd" : "condition_limit_even",
                 omega, -1.0);
    }
  }

  void status() const {
    const bool finished = c_.status == CoefficientStatus::Finished;
    const bool unfinished = c_.status == CoefficientStatus::Unfinished;
    if (finished && !c_.hasConsistentLimit()) {
      throw HydroError(Fault::DatabaseIncomplete,
                       where_ + ": status is finished, but A(inf) is not the consistent one");
    }
    if (unfinished == c_.unfinishedBecause.empty()) {
      throw HydroError(
          Fault::DatabaseIncomplete,
          where_ + ": the reason of unfinished coefficients is missing, or of others given");
    }
  }

  /// A rotation and a scale: what is mirrored or sheared is no file's axes. 1e-6: rotations that
  /// somebody rounded pass.
  void file() const {
    const FilePlacement& file = c_.ship.file;
    const double off =
        (file.rotation * file.rotation.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff();
    const char* why = nullptr;
    if (!(off <= 1e-6)) why = "its axes are not at right angles or not of length 1";
    if (why == nullptr && file.rotation.determinant() < 0.0) why = "its axes are mirrored";
    if (why != nullptr) {
      throw HydroError(Fault::ValueOutOfRange,
                       fmt::format("{}: ship/file/rotation is no rotation: {}", where_, why));
    }
    if (file.metresPerUnit > 0.0) return;
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: ship/file/metres_per_unit = {}, must be above 0", where_,
                                 file.metresPerUnit));
  }

  void mesh(const SurfaceMesh& mesh, const char* name) const {
    const auto count = static_cast<int>(mesh.vertices.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t i = 0; i < 4; ++i) {
        const int v = mesh.faces[f].v[i];
        if ((v >= 0 && v < count) || (i == 3 && v == -1)) continue;
        throw HydroError(
            Fault::MeshIndexOutOfRange,
            fmt::format("{}: {}: face {} names vertex {} of {}", where_, name, f, v, count));
      }
    }
  }

 private:
  void expect(const char* name, std::size_t found, std::size_t expected) const {
    if (found == expected) return;
    throw HydroError(Fault::DatabaseIncomplete, fmt::format("{}: {} has {} entries, {} expected",
                                                            where_, name, found, expected));
  }
  void optional(const char* name, std::size_t found, std::size_t expected) const {
    if (found != 0) expect(name, found, expected);
  }

  const Coefficients& c_;
  const std::string& where_;
};

}  // namespace

void checkIncreasing(const std::string& where, const std::string& name,
                     const std::vector<double>& values, double above) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > (i == 0 ? above : values[i - 1])) continue;
    const std::string rule =
        i == 0 ? fmt::format("the first must be above {}", std::max(above, 0.0))
               : fmt::format("must be above the one before, {}: frequencies increase strictly",
                             values[i - 1]);
    throw HydroError(Fault::FrequenciesNotIncreasing,
                     fmt::format("{}: {}[{}] = {} rad/s: {}", where, name, i, values[i], rule));
  }
}

void checkCoefficients(const Coefficients& c, const std::string& where) {
  checkFinite(c, where);
  const Check check(c, where);
  check.increasing("omega", c.omega, 0.0);
  check.sizes();
  check.adjoints();
  check.table();
  check.mask();
  check.status();
  check.file();
  check.mesh(c.ship.hull, "hull");
  check.mesh(c.ship.wetSurface, "wet surface");
  if (!(c.ship.density > 0.0 && c.ship.gravity > 0.0)) {
    throw HydroError(Fault::ValueOutOfRange,
                     fmt::format("{}: density {} kg/m3 and gravity {} m/s2 must be > 0", where,
                                 c.ship.density, c.ship.gravity));
  }
  requireUsable(c.ship.drag, where);
  if (c.ship.engine) requireUsable(*c.ship.engine, where);
  if (c.ship.rudder) requireUsable(*c.ship.rudder, where);
}

}  // namespace cutwater
