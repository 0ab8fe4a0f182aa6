#include "demos/report_page/PanelData.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "demos/report_page/Encoding.h"
#include "hydro/geometry/panelling/PanelQuality.h"
#include "hydro/geometry/panels/WetSurface.h"

namespace cutwater::page {

namespace {

// Panels of one side, those of the lid last.
std::vector<Panel> panelsOfSide(const PanelMesh& mesh) {
  std::vector<Panel> panels = mesh.panels;
  panels.insert(panels.end(), mesh.lid.begin(), mesh.lid.end());
  return panels;
}

// As the solve had them; a lid of other panels than it counted is left out.
PanelMesh solvedPanels(const Coefficients& c) {
  const WetSurface wet = c.wet();
  if (c.provenance.setting("lid") != "true") return wet.panels();
  PanelMesh mesh = wet.panelsWithLid();
  if (c.provenance.setting("lid_panels") != std::to_string(mesh.lid.size())) mesh.lid.clear();
  return mesh;
}

double quality(const Panel& panel) {
  SurfaceMesh mesh;
  mesh.vertices.assign(panel.corner.begin(), panel.corner.begin() + panel.corners);
  return aspectRatio(mesh, {{0, 1, 2, panel.corners == 4 ? 3 : -1}});
}

// What is written: all hull panels, port then starboard, then the lid likewise.
class Panels {
 public:
  explicit Panels(const Coefficients& c)
      : mesh_(solvedPanels(c)), cog_(c.ship.cog), sides_(mesh_.symmetric ? 2 : 1) {}

  const PanelMesh& mesh() const noexcept { return mesh_; }
  std::size_t lid() const noexcept { return mesh_.lid.size() * static_cast<std::size_t>(sides_); }

  void corners(Json& json) const {
    std::vector<double> points;
    std::vector<std::uint32_t> faces;
    visit([&](const Panel& panel, std::size_t, bool image) {
      const auto first = static_cast<std::uint32_t>(points.size() / 3);
      for (int i = 0; i < 4; ++i) {
        const int corner = std::min(image ? 3 - i : i, panel.corners - 1);
        Vec3 place = panel.corner[static_cast<std::size_t>(corner)];
        if (image) place.y() = -place.y();
        place -= cog_;
        points.insert(points.end(), place.begin(), place.end());
        faces.push_back(first + static_cast<std::uint32_t>(i));
      }
    });
    json.key("points");
    blob32(json, points);
    json.key("faces");
    blobOf(json, faces);
  }

  /// @param of  of the port panel and its index; lid panels go on counting.
  void values(Json& json, const std::function<double(const Panel&, std::size_t)>& of) const {
    std::vector<double> numbers;
    visit([&](const Panel& panel, std::size_t i, bool) { numbers.push_back(of(panel, i)); });
    blob32(json, numbers);
  }

 private:
  template <class Visitor>
  void visit(const Visitor& visitor) const {
    const std::vector<Panel> panels = panelsOfSide(mesh_);
    const std::size_t hull = mesh_.panels.size();
    for (const auto& [from, to] : {std::pair{std::size_t{0}, hull}, {hull, panels.size()}}) {
      for (int side = 0; side < sides_; ++side)
        for (std::size_t i = from; i < to; ++i) visitor(panels[i], i, side == 1);
    }
  }

  PanelMesh mesh_;
  Vec3 cog_;
  int sides_;
};

void field(Json& json, const Panels& panels, const std::string& name, const char* unit,
           const std::function<double(const Panel&, std::size_t)>& of) {
  json.beginObject().field("name", name).field("unit", unit).key("values");
  panels.values(json, of);
  json.end();
}

// The grid's frequency nearest to that of waves as long as the ship, of those that panels resolve.
std::size_t frequencyOfLength(const Coefficients& c) {
  const double wanted = std::sqrt(2.0 * kPi * c.ship.gravity / c.ship.length());
  std::size_t best = 0;
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    if (c.resolvedOmega > 0.0 && c.omega[i] > c.resolvedOmega) break;
    if (std::abs(c.omega[i] - wanted) < std::abs(c.omega[best] - wanted)) best = i;
  }
  return best;
}

void radiation(Json& json, const Coefficients& c, const Panels& panels, std::size_t frequency) {
  const auto& adjoint = c.adjoint[frequency];
  const std::size_t count = panels.mesh().panels.size();
  const double omega = c.omega[frequency];
  if (adjoint.cols() != static_cast<Eigen::Index>(count)) return;
  for (int j = 0; j < 6; ++j) {
    field(json, panels,
          fmt::format("{} radiation, {:.3g} rad/s, pressure amplitude", kModeNames[j], omega),
          j < 3 ? "Pa/m" : "Pa/rad", [&](const Panel& panel, std::size_t i) {
            if (i >= count) return 0.0;  // no water outside the hull at the lid
            const Complex b = adjoint(j, static_cast<Eigen::Index>(i));
            return omega * omega * std::abs(b) / panel.area;
          });
  }
}

void pressures(Json& json, const Coefficients& c, const Panels& panels) {
  const double weight = c.ship.density * c.ship.gravity;
  const std::size_t frequency = frequencyOfLength(c);
  const double omega = c.omega[frequency], k = omega * omega / c.ship.gravity;
  json.key("fields").beginArray();
  field(json, panels, "hydrostatic pressure", "Pa",
        [&](const Panel& panel, std::size_t) { return -weight * panel.centroid.z(); });
  field(json, panels, fmt::format("incident wave, {:.3g} rad/s, pressure amplitude", omega), "Pa/m",
        [&](const Panel& panel, std::size_t) { return weight * std::exp(k * panel.centroid.z()); });
  field(json, panels,
        fmt::format("incident wave, {:.3g} rad/s from ahead, pressure with the crest at G", omega),
        "Pa/m", [&](const Panel& panel, std::size_t) {
          return weight * std::exp(k * panel.centroid.z()) *
                 std::cos(k * (panel.centroid.x() - c.ship.cog.x()));
        });
  if (!c.adjoint.empty()) radiation(json, c, panels, frequency);
  json.end();
}

}  // namespace

void panelsJson(Json& json, const Coefficients& c) {
  if (c.wet().empty()) {
    json.null();
    return;
  }
  const Panels panels(c);
  json.beginObject();
  panels.corners(json);
  json.key("quality");
  panels.values(json, [](const Panel& panel, std::size_t) { return quality(panel); });
  json.field("lid", panels.lid());
  pressures(json, c, panels);
  json.end();
}

}  // namespace cutwater::page
