#include "hydro/database/CutwaterGroup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hydro/Errors.h"
#include "hydro/base/EnumNames.h"

namespace cutwater {

namespace {

using hdf5::Array;
using hdf5::Shape;

/// Numbers of one field in a row, to be written or to be read back in the same order.
class Flat {
 public:
  explicit Flat(Array array) : array_(std::move(array)) {}
  std::size_t extent(std::size_t i) const { return array_.shape.at(i); }
  double next() { return array_.data[at_++]; }

 private:
  Array array_;
  std::size_t at_ = 0;
};

// pack(value, numbers) appends the numbers of one element; unpack takes them back. shapeOf is the
// element's own shape.
void pack(double x, std::vector<double>& to) { to.push_back(x); }
void pack(const std::pair<double, double>& x, std::vector<double>& to) {
  to.insert(to.end(), {x.first, x.second});
}
void pack(const Complex& x, std::vector<double>& to) { to.insert(to.end(), {x.real(), x.imag()}); }
void unpack(double& x, Flat& from) { x = from.next(); }
void unpack(std::pair<double, double>& x, Flat& from) {
  x.first = from.next();
  x.second = from.next();
}
void unpack(int& x, Flat& from) {
  const double found = from.next();
  // a damaged number must not overflow; the checks then refuse −2
  x = std::abs(found) < 2e9 && found == std::floor(found) ? static_cast<int>(found) : -2;
}
void unpack(Complex& x, Flat& from) {
  const double re = from.next();
  x = {re, from.next()};
}
template <class Derived>
void pack(const Eigen::MatrixBase<Derived>& m, std::vector<double>& to) {
  for (Eigen::Index r = 0; r < m.rows(); ++r) {
    for (Eigen::Index c = 0; c < m.cols(); ++c) pack(m(r, c), to);
  }
}
template <class Derived>
void unpack(Eigen::MatrixBase<Derived>& m, Flat& from) {
  for (Eigen::Index r = 0; r < m.rows(); ++r) {
    for (Eigen::Index c = 0; c < m.cols(); ++c) unpack(m(r, c), from);
  }
}
void pack(const Face& face, std::vector<double>& to) {
  to.insert(to.end(), face.v.begin(), face.v.end());
}
void unpack(Face& face, Flat& from) {
  for (int& v : face.v) unpack(v, from);
}
template <class T>
void pack(const std::vector<T>& list, std::vector<double>& to) {
  for (const T& item : list) pack(item, to);
}

template <class T>
std::vector<T> listOf(const std::optional<T>& value) {
  return value ? std::vector<T>{*value} : std::vector<T>{};
}

Shape shapeOf(double) { return {}; }
Shape shapeOf(const Face&) { return {4}; }
Shape shapeOf(const std::pair<double, double>&) { return {2}; }
template <class Derived>
Shape shapeOf(const Eigen::MatrixBase<Derived>& m) {
  Shape shape{static_cast<std::size_t>(m.rows())};
  if (m.cols() != 1) shape.push_back(static_cast<std::size_t>(m.cols()));
  if (Eigen::NumTraits<typename Derived::Scalar>::IsComplex) shape.push_back(2);
  return shape;
}
template <class T>
Shape shapeOf(const std::vector<T>& list) {
  Shape shape = shapeOf(list.empty() ? T() : list.front());
  shape.insert(shape.begin(), list.size());
  return shape;
}

/// Gives `value` the lengths that the file says; elements of fixed size must have theirs.
template <class T>
void resize(T&, const Shape&, std::size_t) {}
void resize(Eigen::Matrix<Complex, 6, Eigen::Dynamic>& m, const Shape& shape, std::size_t level) {
  m.resize(6, static_cast<Eigen::Index>(shape.at(level + 1)));
}
template <class T>
void resize(std::vector<T>& list, const Shape& shape, std::size_t level) {
  list.resize(shape.at(level));
  for (T& item : list) resize(item, shape, level + 1);
}
template <class T>
void unpack(std::vector<T>& list, Flat& from) {
  for (T& item : list) unpack(item, from);
}

class GroupWriter {
 public:
  explicit GroupWriter(hdf5::Writer& writer) : writer_(writer) {}
  template <class T>
  void operator()(const std::string& name, const T& value) {
    Shape shape = shapeOf(value);
    if (shape.empty()) shape = {1};
    std::vector<double> data;
    pack(value, data);
    writer_.numbers("cutwater/" + name, shape, data);
  }
  void operator()(const std::string& name, const bool& value) { (*this)(name, value ? 1.0 : 0.0); }
  /// A list of one, or of none.
  template <class T>
  void operator()(const std::string& name, const std::optional<T>& value) {
    (*this)(name, listOf(value));
  }
  void operator()(const std::string& name, const PanelShape& value) {
    (*this)(name, static_cast<double>(value));
  }
  void operator()(const std::string& name, const std::string& value) {
    writer_.text("cutwater/" + name, value);
  }
  void operator()(const std::string& name, const ForwardSpeedForm& value) {
    (*this)(name, std::string(nameOf(kForwardSpeedNames, value)));
  }
  void operator()(const std::string& name, const CoefficientStatus& value) {
    (*this)(name, std::string(nameOf(kCoefficientStatusNames, value)));
  }

 private:
  hdf5::Writer& writer_;
};

class GroupReader {
 public:
  explicit GroupReader(const hdf5::Reader& reader) : reader_(reader) {}
  template <class T>
  void operator()(const std::string& name, T& value) {
    Array array = reader_.numbers("cutwater/" + name);
    const Shape found = array.shape;
    std::size_t total = 1;
    for (std::size_t extent : found) total *= extent;
    try {
      // An empty list keeps no shape of its elements; anything else must come back as it is.
      if (total != 0) resize(value, found, 0);
      Shape expected = shapeOf(value);
      if (expected.empty()) expected = {1};
      if (total != 0 && expected != found) throw std::out_of_range("shape");
    } catch (const std::out_of_range&) {
      throw HydroError(Fault::FileMalformed,
                       fmt::format("{}: cutwater/{} has the wrong shape", reader_.path(), name));
    }
    Flat flat(std::move(array));
    if (total != 0) unpack(value, flat);
  }
  void operator()(const std::string& name, bool& value) {
    double number = 0.0;
    (*this)(name, number);
    value = number != 0.0;
  }
  template <class T>
  void operator()(const std::string& name, std::optional<T>& value) {
    std::vector<T> list;
    (*this)(name, list);
    value.reset();
    if (!list.empty()) value = list.front();
  }
  void operator()(const std::string& name, PanelShape& value) {
    int number = 0;
    (*this)(name, number);
    if (number < 0 || number > static_cast<int>(PanelShape::Auto))
      throw HydroError(Fault::FileMalformed,
                       fmt::format("{}: cutwater/{} = {}", reader_.path(), name, number));
    value = static_cast<PanelShape>(number);
  }
  void operator()(const std::string& name, std::string& value) {
    value = reader_.text("cutwater/" + name);
  }
  void operator()(const std::string& name, ForwardSpeedForm& value) {
    named(name, kForwardSpeedNames, value);
  }
  void operator()(const std::string& name, CoefficientStatus& value) {
    named(name, kCoefficientStatusNames, value);
  }

 private:
  template <class Names, class Enum>
  void named(const std::string& name, const Names& names, Enum& value) {
    const std::string found = reader_.text("cutwater/" + name);
    const auto known = fromName<Enum>(names, found);
    if (!known) {
      throw HydroError(Fault::FileMalformed,
                       fmt::format("{}: cutwater/{} = \"{}\"", reader_.path(), name, found));
    }
    value = *known;
  }

  const hdf5::Reader& reader_;
};

/// The one list of what is in the group, for writing (const) and for reading.
template <class Store, class C>
void transfer(Store&& store, C& c) {
  auto& ship = c.ship;
  store("ship/name", ship.name);
  store("ship/hull/vertices", ship.hull.vertices);
  store("ship/hull/faces", ship.hull.faces);
  store("ship/wet_surface/vertices", ship.wetSurface.vertices);
  store("ship/wet_surface/faces", ship.wetSurface.faces);
  store("ship/symmetric", ship.symmetric);
  store("ship/mass", ship.mass);
  store("ship/cog", ship.cog);
  store("ship/gyradii", ship.gyradii);
  store("ship/volume", ship.volume);
  store("ship/centre_of_buoyancy", ship.centreOfBuoyancy);
  store("ship/restoring", ship.restoring);
  store("ship/density", ship.density);
  store("ship/gravity", ship.gravity);
  store("ship/supplementary/damping", ship.supplementary.damping);
  store("ship/supplementary/stiffness", ship.supplementary.stiffness);
  store("ship/supplementary/roll_damping_quadratic", ship.supplementary.rollDampingQuadratic);
  store("provenance/code", c.provenance.code);
  store("provenance/version", c.provenance.version);
  store("provenance/mesh_hash", c.provenance.meshHash);
  store("provenance/settings", c.provenance.settings);
  store("omega", c.omega);
  store("wave_omega", c.waveOmega);
  store("resolved_omega", c.resolvedOmega);
  store("added_mass", c.addedMass.values);
  store("damping", c.damping.values);
  store("added_mass_zero", c.addedMass.atZero);
  store("added_mass_inf", c.addedMass.atInfinity);
  store("added_mass_inf_direct", c.addedMassInfDirect);
  store("added_mass_x", c.addedMassX.values);
  store("damping_x", c.dampingX.values);
  store("added_mass_x_zero", c.addedMassX.atZero);
  store("added_mass_x_inf", c.addedMassX.atInfinity);
  store("headings", c.headings);
  store("froude_krylov", c.froudeKrylov);
  store("diffraction", c.diffraction);
  store("adjoint", c.adjoint.values);
  store("adjoint_x", c.adjointX.values);
  store("adjoint_zero", c.adjoint.atZero);
  store("adjoint_x_zero", c.adjointX.atZero);
  store("adjoint_inf", c.adjoint.atInfinity);
  store("adjoint_x_inf", c.adjointX.atInfinity);
  store("forward_speed", c.forwardSpeed);
  store("curved_panels", c.panelShape);
  store("diffraction_table/speeds", c.diffractionTable.speeds);
  store("diffraction_table/headings", c.diffractionTable.headings);
  store("diffraction_table/wave_omega", c.diffractionTable.waveOmega);
  store("diffraction_table/values", c.diffractionTable.values);
  store("masked", c.masked);
  store("condition_limit_even", c.conditionLimitEven);
  store("condition_limit_odd", c.conditionLimitOdd);
  store("condition_even", c.conditionEven);
  store("condition_odd", c.conditionOdd);
}

/// What version 3 added.
template <class Store, class C>
void transferStatus(Store&& store, C& c) {
  store("status", c.status);
  store("unfinished_because", c.unfinishedBecause);
}

/// What version 4 added: speeds at which motions grow, −1 where there is none.
template <class Store>
void writeStability(Store&& store, const SpeedStability& s) {
  store("stability/checked_to", s.checkedTo);
  store("stability/ahead", std::vector{s.ahead.speed.value_or(-1.0), double(s.ahead.mode)});
  store("stability/astern", std::vector{s.astern.speed.value_or(-1.0), double(s.astern.mode)});
  store("stability/course", s.course.value_or(-1.0));
}

/// What version 6 added: how the hull's file lies in hull axes.
template <class Store, class C>
void transferFile(Store&& store, C& c) {
  store("ship/file/rotation", c.ship.file.rotation);
  store("ship/file/metres_per_unit", c.ship.file.metresPerUnit);
  store("ship/file/origin", c.ship.file.origin);
}

/// What version 7 added.
template <class Store, class E>
void transferEngine(Store&& store, E& engine) {
  store("ship/engine/max_thrust", engine.maxThrust);
  store("ship/engine/astern", engine.astern);
  store("ship/engine/no_thrust_speed", engine.noThrustSpeed);
  store("ship/engine/time_constant", engine.timeConstant);
  store("ship/engine/diameter", engine.diameter);
  store("ship/engine/place", engine.place);
}
template <class Store, class R>
void transferRudder(Store&& store, R& rudder) {
  store("ship/rudder/area", rudder.area);
  store("ship/rudder/place", rudder.place);
  store("ship/rudder/aspect_ratio", rudder.aspectRatio);
  store("ship/rudder/limit", rudder.limit);
  store("ship/rudder/rate", rudder.rate);
  store("ship/rudder/stall", rudder.stall);
  store("ship/rudder/slipstream", rudder.slipstream);
  store("ship/rudder/flow_straightening", rudder.flowStraightening);
}
template <class Store, class Ship>
void transferDrag(Store&& store, Ship& ship) {
  store("ship/resistance/cross_flow_drag", ship.drag.crossFlow);
  store("ship/resistance/form_factor", ship.drag.formFactor);
}

/// A ship without an engine has the numbers of one that is not there.
template <class Store>
void writeDrive(Store&& store, const ShipParticulars& ship) {
  const EngineParticulars engine = ship.engine.value_or(EngineParticulars{});
  const RudderParticulars rudder = ship.rudder.value_or(RudderParticulars{});
  transferDrag(store, ship);
  store("ship/engine/present", ship.engine.has_value());
  transferEngine(store, engine);
  store("ship/rudder/present", ship.rudder.has_value());
  transferRudder(store, rudder);
}

void readDrive(GroupReader& store, ShipParticulars& ship) {
  bool engine = false, rudder = false;
  transferDrag(store, ship);
  store("ship/engine/present", engine);
  if (engine) transferEngine(store, ship.engine.emplace());
  store("ship/rudder/present", rudder);
  if (rudder) transferRudder(store, ship.rudder.emplace());
}

SpeedStability readStability(GroupReader& store) {
  SpeedStability s;
  const auto speed = [](double stored) {
    return stored >= 0.0 ? std::optional(stored) : std::nullopt;
  };
  const auto limit = [&](const std::string& name) {
    std::vector<double> stored(2);
    store(name, stored);
    stored.resize(2);
    return GrowthLimit{speed(stored[0]), std::clamp(static_cast<int>(stored[1]), 0, 5)};
  };
  double course = -1.0;
  store("stability/checked_to", s.checkedTo);
  s.ahead = limit("stability/ahead");
  s.astern = limit("stability/astern");
  store("stability/course", course);
  s.course = speed(course);
  return s;
}

/// Version 2 did not say: `cutwater solve` wrote a database without a consistent A(∞) if its grid
/// was too coarse, and a program that did not finish its coefficients wrote one as well.
void deduceStatus(Coefficients& c) {
  if (c.hasConsistentLimit()) {
    c.status = CoefficientStatus::Finished;
    return;
  }
  c.status = CoefficientStatus::Unfinished;
  c.unfinishedBecause = "written by version " + c.provenance.version +
                        " on too coarse a frequency grid, or by a program that did not finish it; "
                        "solve again";
}

/// A store that only looks: every number finite.
class FiniteCheck {
 public:
  FiniteCheck(std::string where, const std::vector<double>& omega)
      : where_(std::move(where)), omega_(omega) {}
  template <class T>
  void operator()(const std::string& name, const T& value) const {
    std::vector<double> data;
    pack(value, data);
    const auto bad =
        std::find_if(data.begin(), data.end(), [](double x) { return !std::isfinite(x); });
    if (bad == data.end()) return;
    const auto at = static_cast<std::size_t>(bad - data.begin());
    throw HydroError(Fault::ValueOutOfRange, fmt::format("{}: {}{} is {}", where_, name,
                                                         placeIn(shapeOf(value), at), *bad));
  }
  template <class T>
  void operator()(const std::string& name, const std::optional<T>& value) const {
    if (value) (*this)(name, *value);
  }
  void operator()(const std::string&, const bool&) const {}
  void operator()(const std::string&, const PanelShape&) const {}
  void operator()(const std::string&, const std::string&) const {}
  void operator()(const std::string&, const ForwardSpeedForm&) const {}

 private:
  /// The indices of number `at`, from 0, and what they mean where it is known: the frequency, and
  /// modes from 1.
  std::string placeIn(const Shape& shape, std::size_t at) const {
    std::vector<std::size_t> index(shape.size());
    for (std::size_t d = shape.size(); d-- > 0; at /= shape[d]) index[d] = at % shape[d];
    if (index.empty()) return {};
    const auto last = shape.end();
    const bool modes = shape.size() >= 2 && last[-1] == 6 && last[-2] == 6;
    const bool perFrequency = shape.size() >= 3 && modes && shape.front() == omega_.size();
    std::string place = fmt::format("[{}]", fmt::join(index, ", "));
    if (perFrequency) place += fmt::format(" at omega = {:.6g} rad/s", omega_[index.front()]);
    if (modes) place += fmt::format(" (j = {}, k = {})", index.end()[-2] + 1, index.back() + 1);
    return place;
  }

  std::string where_;
  const std::vector<double>& omega_;
};

}  // namespace

void writeCutwaterGroup(hdf5::Writer& writer, const Coefficients& coefficients) {
  GroupWriter store(writer);
  transfer(store, coefficients);
  transferStatus(store, coefficients);
  writeStability(store, coefficients.stability);
  transferFile(store, coefficients);
  writeDrive(store, coefficients.ship);
}

Coefficients readCutwaterGroup(const hdf5::Reader& reader, std::int64_t version) {
  Coefficients coefficients;
  GroupReader store(reader);
  transfer(store, coefficients);
  if (version >= 3) {
    transferStatus(store, coefficients);
  } else {
    deduceStatus(coefficients);
  }
  if (version >= 4) coefficients.stability = readStability(store);
  if (version >= 6) transferFile(store, coefficients);
  if (version >= 7) readDrive(store, coefficients.ship);
  return coefficients;
}

void checkFinite(const Coefficients& coefficients, const std::string& where) {
  const FiniteCheck check(where, coefficients.omega);
  transfer(check, coefficients);
  transferFile(check, coefficients);
  writeDrive(check, coefficients.ship);
}

}  // namespace cutwater
