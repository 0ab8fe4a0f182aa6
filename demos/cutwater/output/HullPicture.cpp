#include "demos/cutwater/output/HullPicture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "hydro/geometry/MeshEdges.h"

namespace cutwater::command {

namespace {

constexpr double kWidth = 960.0, kMargin = 30.0, kTallest = 380.0;  // [px]
constexpr int kStations = 21, kWaterlines = 9, kButtocks = 7;
constexpr double kSharp = 0.82;  // cosine of 35°: edges that are seen as such

struct Segment {
  Vec3 from, to;
};
using Segments = std::vector<Segment>;

// Where the surface crosses the plane p[axis] = at.
Segments section(const SurfaceMesh& triangles, int axis, double at) {
  Segments segments;
  for (const Face& face : triangles.faces) {
    Vec3 crossing[2];
    int count = 0;
    for (int i = 0; i < 3 && count < 2; ++i) {
      const Vec3 &a = triangles.corner(face, i), &b = triangles.corner(face, (i + 1) % 3);
      if ((a[axis] < at) == (b[axis] < at)) continue;
      crossing[count++] = a + (at - a[axis]) / (b[axis] - a[axis]) * (b - a);
    }
    if (count == 2) segments.push_back({crossing[0], crossing[1]});
  }
  return segments;
}

int side(double component) { return component > 1e-9 ? 1 : component < -1e-9 ? -1 : 0; }

// Outlines seen along an axis, and edges that are sharp or open.
Segments outline(const SurfaceMesh& mesh, int axis) {
  std::vector<Vec3> normals;
  for (const Face& face : mesh.faces) normals.push_back(vectorArea(mesh, face).normalized());
  const std::vector<EdgeUse> uses = edgeUses(mesh);
  Segments segments;
  for (std::size_t first = 0, next; first < uses.size(); first = next) {
    next = first + 1;
    while (next < uses.size() && uses[next].edge == uses[first].edge) ++next;
    bool drawn = next - first != 2;
    if (!drawn) {
      const Vec3& a = normals[static_cast<std::size_t>(uses[first].face)];
      const Vec3& b = normals[static_cast<std::size_t>(uses[first + 1].face)];
      drawn = side(a[axis]) != side(b[axis]) || a.dot(b) < kSharp;
    }
    if (!drawn) continue;
    const auto vertex = [&](std::uint64_t i) { return mesh.vertices[i & 0xffffffffu]; };
    segments.push_back({vertex(uses[first].edge >> 32), vertex(uses[first].edge)});
  }
  return segments;
}

// One view: which axes lie right and up, at which scale, where its origin is [px].
struct View {
  std::string id;
  int right, up;
  double scale, x, y;
};

// Width of a line [px].
double penOf(const std::string& kind) {
  return kind == "section" ? 0.7 : kind == "waterline" ? 1.8 : 1.0;
}

std::string path(const View& view, const Segments& segments, const std::string& kind) {
  if (segments.empty()) return {};
  std::string text = fmt::format("<path class=\"{}\" stroke-width=\"{:.3g}\" d=\"", kind,
                                 penOf(kind) / view.scale);
  for (const Segment& s : segments)
    fmt::format_to(std::back_inserter(text), "M{:.5g} {:.5g}L{:.5g} {:.5g}", s.from[view.right],
                   s.from[view.up], s.to[view.right], s.to[view.up]);
  return text + "\"/>\n";
}

std::string group(const View& view, const std::string& inside) {
  return fmt::format(
      "<g id=\"{}\" transform=\"translate({:.6g} {:.6g}) scale({:.6g} {:.6g})\">\n{}</g>\n",
      view.id, view.x, view.y, view.scale, -view.scale, inside);
}

// Calm water seen from the side: a line, and what is under it.
std::string water(const View& view, double left, double right, double bottom) {
  const double beyond = 0.03 * (right - left);
  return fmt::format(
      "<rect class=\"water\" x=\"{0:.5g}\" y=\"{1:.5g}\" width=\"{2:.5g}\" height=\"{3:.5g}\"/>\n"
      "<line class=\"waterline\" x1=\"{0:.5g}\" y1=\"0\" x2=\"{4:.5g}\" y2=\"0\" "
      "stroke-width=\"{5:.3g}\"/>\n",
      left - beyond, bottom, right - left + 2.0 * beyond, -bottom, right + beyond,
      penOf("waterline") / view.scale);
}

std::string profile(const View& view, const SurfaceMesh& mesh, const SurfaceMesh& triangles,
                    const Bounds& box) {
  Segments buttocks;
  for (int i = 1; i <= kButtocks; ++i) {
    const double y = box.low.y() + (box.high.y() - box.low.y()) * i / (kButtocks + 1.0);
    const Segments one = section(triangles, 1, y + 1e-6 * box.diagonal());
    buttocks.insert(buttocks.end(), one.begin(), one.end());
  }
  return group(view, water(view, box.low.x(), box.high.x(), std::min(box.low.z(), 0.0)) +
                         path(view, buttocks, "section") + path(view, outline(mesh, 1), "edge"));
}

std::string plan(const View& view, const SurfaceMesh& mesh, const SurfaceMesh& triangles,
                 const Bounds& box) {
  Segments lines;
  for (int i = 1; i < kWaterlines; ++i) {
    const Segments one = section(triangles, 2, box.low.z() * i / kWaterlines);
    lines.insert(lines.end(), one.begin(), one.end());
  }
  const Segments waterplane = section(triangles, 2, -1e-6 * box.diagonal());
  return group(view, path(view, lines, "section") + path(view, outline(mesh, 2), "edge") +
                         path(view, waterplane, "waterline"));
}

std::string body(const View& view, const SurfaceMesh& triangles, const Bounds& box,
                 bool symmetric) {
  Segments stations;
  const double middle = 0.5 * (box.low.x() + box.high.x());
  for (int i = 0; i < kStations; ++i) {
    const double x = box.low.x() + (box.high.x() - box.low.x()) * (i + 0.5) / kStations;
    const double turn = x < middle ? -1.0 : 1.0;
    for (Segment s : section(triangles, 0, x)) {
      if (symmetric && s.from.y() + s.to.y() < 0.0) continue;
      if (symmetric)
        s = {s.from.cwiseProduct(Vec3(1, turn, 1)), s.to.cwiseProduct(Vec3(1, turn, 1))};
      stations.push_back(s);
    }
  }
  return group(view, water(view, box.low.y(), box.high.y(), std::min(box.low.z(), 0.0)) +
                         path(view, stations, "edge"));
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (static_cast<unsigned char>(c) < 0x20)
      safe += ' ';
    else
      safe += c;
  }
  return safe;
}

std::string text(double x, double y, const std::string& kind, const std::string& what) {
  return fmt::format("<text class=\"{}\" x=\"{:.5g}\" y=\"{:.5g}\">{}</text>\n", kind, x, y,
                     escaped(what));
}

constexpr const char* kStyle =
    "<style>\n"
    "text{font:13px sans-serif;fill:#222}.title{font-size:18px;font-weight:bold}\n"
    "path,line{fill:none;stroke:#222;stroke-linecap:round}\n"
    ".section{stroke:#9aa4ad}.water{fill:#d8ecf8}\n"
    ".waterline{stroke:#0a6ebd}\n"
    "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";

// The three views, from `y` [px] down; `y` becomes the lowest place used.
std::string views(const HullPicture& picture, double& y) {
  const SurfaceMesh mesh = welded(picture.surface, 1e-6 * bounds(picture.surface).diagonal());
  const SurfaceMesh triangles = triangulated(mesh);
  const Bounds box = bounds(mesh);
  const Vec3 size = box.high - box.low, middle = 0.5 * (box.low + box.high);
  const double inner = kWidth - 2.0 * kMargin;
  const double scale =
      std::min({0.94 * inner / size.x(), kTallest / size.z(), kTallest / size.y()});
  const double bodyScale = std::min(0.45 * inner / size.y(), 0.8 * kTallest / size.z());
  std::string content;
  const auto next = [&](const std::string& name, const std::string& id, int right, int up,
                        double s) {
    content += text(kMargin, y += 34.0, "name", name);
    const double top = y + 12.0;
    y = top + s * size[up];
    return View{id, right, up, s, 0.5 * kWidth - s * middle[right], top + s * box.high[up]};
  };
  const View side = next("Profile, bow to the right", "profile", 0, 2, scale);
  content += profile(side, mesh, triangles, box);
  const View above = next("Plan, port up; blue: the waterline", "plan", 0, 1, scale);
  content += plan(above, mesh, triangles, box);
  const std::string bodyPlan =
      picture.symmetric ? "Body plan: after body left, fore body right" : "Body plan, from ahead";
  const View ahead = next(bodyPlan, "body", 1, 2, bodyScale);
  return content + body(ahead, triangles, box, picture.symmetric);
}

}  // namespace

std::string svgOf(const HullPicture& picture) {
  double y = kMargin + 16.0;
  std::string content = text(kMargin, y, "title", picture.title);
  for (const std::string& line : picture.lines) content += text(kMargin, y += 19.0, "line", line);
  content += views(picture, y);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
             "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n",
             kWidth, y + kMargin) +
         kStyle + content + "</svg>\n";
}

}  // namespace cutwater::command
