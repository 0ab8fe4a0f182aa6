#include "hydro/bem/SweepRecord.h"

#include <algorithm>

#include "hydro/base/Fnv1a.h"

namespace cutwater {
namespace {

void add(const SurfaceMesh& mesh, Fnv1a& hash) {
  for (const Vec3& vertex : mesh.vertices) hash.add(vertex.data(), 3 * sizeof(double));
  for (const Face& face : mesh.faces) hash.add(face.v.data(), sizeof(face.v));
}

/// Calls visit(numbers, count) for all that belongs to frequency i.
void visitFrequency(CoefficientTables& c, std::size_t i, const auto& visit) {
  const auto complex = [&](auto& m) {
    visit(reinterpret_cast<double*>(m.data()), 2 * static_cast<std::size_t>(m.size()));
  };
  for (auto* matrices : {&c.addedMass, &c.damping, &c.addedMassX, &c.dampingX})
    if (!matrices->empty()) visit((*matrices)[i].data(), 36);
  for (auto* vectors : {&c.adjoint, &c.adjointX})
    if (!vectors->empty()) complex((*vectors)[i]);
  for (auto* forces : {&c.froudeKrylov, &c.diffraction})
    for (auto& ofHeading : *forces) complex(ofHeading[i]);
  for (auto* condition : {&c.conditionEven, &c.conditionOdd})
    if (!condition->empty()) visit(&(*condition)[i], 1);
}

}  // namespace

std::string hashOf(const SurfaceMesh& mesh) {
  Fnv1a hash;
  add(mesh, hash);
  return hash.digits();
}

std::uint64_t journalKey(const CoefficientTables& c, const SolveSettings& settings) {
  Fnv1a hash;
  const auto numbers = [&hash](const double* data, std::size_t count) {
    hash.add(data, count * sizeof(double));
  };
  // Raised when the same settings come to give other numbers: a journal must not mix them.
  constexpr double kMethod = 2.0;
  add(c.ship.wetSurface, hash);
  add(c.ship.hull, hash);
  numbers(c.ship.restoring.data(), 36);
  hash.add(c.provenance.version.data(), c.provenance.version.size());
  hash.add(c.provenance.settings.data(), c.provenance.settings.size());
  numbers(c.omega.data(), c.omega.size());
  numbers(c.headings.data(), c.headings.size());
  numbers(c.ship.cog.data(), 3);
  const double others[] = {c.ship.density,
                           c.ship.gravity,
                           settings.lidPanelLength,
                           c.ship.symmetric ? 1.0 : 0.0,
                           static_cast<double>(c.panelShape),
                           kMethod};
  numbers(others, std::size(others));
  return hash.value();
}

std::vector<double> packed(CoefficientTables& c, std::size_t i) {
  std::vector<double> numbers;
  visitFrequency(c, i, [&](const double* data, std::size_t count) {
    numbers.insert(numbers.end(), data, data + count);
  });
  return numbers;
}

void unpack(const std::vector<double>& numbers, CoefficientTables& c, std::size_t i) {
  const double* from = numbers.data();
  visitFrequency(c, i, [&](double* data, std::size_t count) {
    std::copy(from, from + count, data);
    from += count;
  });
}

}  // namespace cutwater
