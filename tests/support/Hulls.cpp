#include "tests/support/Hulls.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "hydro/geometry/shapes/Loft.h"
#include "hydro/geometry/shapes/Shapes.h"
#include "tests/support/CsvTable.h"

namespace cutwater::test {
namespace {

/// One of three divisions by the number of panels.
template <class T>
T byCount(int panels, T coarse, T medium, T fine) {
  return panels < 300 ? coarse : panels < 700 ? medium : fine;
}

Vec3 centreOf(const SurfaceMesh& mesh, const Face& face) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < face.size(); ++i) sum += mesh.corner(face, i) / face.size();
  return sum;
}

TestHull hemisphere() {
  return {"hemisphere", makeHull(closedSphere(10.0, 120, 60), "sphere", Symmetry::Auto),
          [](int panels) {
            return wetHemisphere(10.0, byCount(panels, 20, 27, 40), byCount(panels, 11, 16, 26));
          }};
}

/// Half breadth of the chined hull's waterline, parabolic forward of x = 5 m.
double chinedBreadth(double x) {
  const double s = std::max(0.0, (x - 5.0) / 25.0);
  return 3.0 * (1 - s * s);
}

/// One section from the port waterline to the starboard one; closed: on over the deck.
std::vector<Vec3> chinedSection(double x, int sideRows, int bottomRows, bool closed) {
  const double breadth = chinedBreadth(x);
  std::vector<Vec3> row;
  for (int k = 0; k <= sideRows; ++k) row.emplace_back(x, breadth, -1.8 * k / sideRows);
  for (int k = 1; k <= bottomRows; ++k)
    row.emplace_back(x, breadth * (1 - static_cast<double>(k) / bottomRows),
                     -1.8 - 1.2 * k / bottomRows);
  for (auto k = row.size() - 1; k-- > 0;) row.emplace_back(x, -row[k].y(), row[k].z());
  if (closed) {
    row.emplace_back(x, -breadth, 2.0);
    row.emplace_back(x, breadth, 2.0);
    row.push_back(row.front());
  }
  return row;
}

void addBox(SurfaceMesh& mesh, const Vec3& low, const Vec3& high) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                               i & 4 ? high.z() : low.z());
  const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& s : sides)
    mesh.faces.push_back({{first + s[0], first + s[1], first + s[2], first + s[3]}});
}

void addRectangle(SurfaceMesh& mesh, const Vec3& corner, const Vec3& u, const Vec3& v) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (const Vec3& p : {corner, Vec3(corner + u), Vec3(corner + u + v), Vec3(corner + v)})
    mesh.vertices.push_back(p);
  mesh.faces.push_back({{first, first + 1, first + 2, first + 3}});
}

}  // namespace

TestHull testFrigate() {
  return {"frigate", makeHull(closedFrigate(400, 60), "frigate", Symmetry::Auto), [](int panels) {
            const FrigateDivision d = frigateDivision(panels);
            return wetFrigate(d.along, d.girth);
          }};
}

TestHull testBarge() {
  const BoxShape box{60.0, 16.0, 4.0, 4.0};
  return {"barge", makeHull(closedBox(box, 6, 2, 1), "barge", Symmetry::Auto), [box](int panels) {
            return wetBox(box, byCount(panels, 32, 45, 66), byCount(panels, 4, 6, 9),
                          byCount(panels, 2, 3, 5));
          }};
}

TestHull testCatamaran() {
  const SurfaceMesh one = chinedHull(120, 6, 6, true);
  const SurfaceMesh both = joined(moved(one, {0, 10, 0}), moved(one, {0, -10, 0}));
  return {"catamaran", makeHull(both, "catamaran", Symmetry::Auto), [](int panels) {
            return moved(chinedHull(byCount(panels, 28, 36, 58), byCount(panels, 2, 3, 5),
                                    byCount(panels, 2, 3, 4), false),
                         {0, 10, 0});
          }};
}

TestHull testS175() {
  const CsvTable table("../meshes/s175/offsets.csv");
  std::vector<Vec3> offsets;
  for (std::size_t i = 0; i < table.rows(); ++i)
    offsets.emplace_back(-table.number(i, "x_aft_m"), table.number(i, "y_m"),
                         table.number(i, "z_m") - 9.5);
  const LoftedHull loft(offsets);
  return {"S-175", makeHull(loft.closed(200, 40), "s175", Symmetry::Auto), [loft](int panels) {
            return loft.wet(byCount(panels, 34, 46, 78), byCount(panels, 6, 9, 13));
          }};
}

std::vector<TestHull> testHulls() {
  return {testFrigate(), hemisphere(), testBarge(), testCatamaran(), testS175()};
}

SurfaceMesh chinedHull(int along, int sideRows, int bottomRows, bool closed) {
  SurfaceMesh mesh;
  for (int i = 0; i <= along; ++i)
    for (const Vec3& p : chinedSection(-30.0 + 60.0 * i / along, sideRows, bottomRows, closed))
      mesh.vertices.push_back(p);
  const int width = static_cast<int>(mesh.vertices.size()) / (along + 1);
  for (int i = 0; i < along; ++i)
    for (int k = 0; k + 1 < width; ++k) {
      const int a = i * width + k, b = a + width;
      mesh.faces.push_back({{a, b, b + 1, a + 1}});
    }
  const int half = sideRows + bottomRows, last = 2 * half;  // transom in level strips
  for (int k = 0; k + 1 < half; ++k) mesh.faces.push_back({{k, k + 1, last - k - 1, last - k}});
  mesh.faces.push_back({{half - 1, half, half + 1, -1}});
  if (closed) mesh.faces.push_back({{last + 1, last + 2, 0, last}});
  return welded(mesh, 1e-9);
}

SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.vertices) p += by;
  return mesh;
}

SurfaceMesh unwelded(const SurfaceMesh& mesh) {
  SurfaceMesh out;
  for (const Face& f : triangulated(mesh).faces) {
    const int first = static_cast<int>(out.vertices.size());
    for (int i = 0; i < 3; ++i) out.vertices.push_back(mesh.corner(f, i));
    out.faces.push_back({{first, first + 1, first + 2, -1}});
  }
  return out;
}

SurfaceMesh shaken(SurfaceMesh mesh, double by) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-by, by);
  for (Vec3& p : mesh.vertices)
    for (int i = 0; i < 3; ++i) p[i] += offset(random);
  return mesh;
}

SurfaceMesh turnedAtRandom(SurfaceMesh mesh) {
  std::mt19937 random(2);
  for (Face& f : mesh.faces)
    if (random() % 3 == 0) std::reverse(f.v.begin(), f.v.begin() + f.size());
  return mesh;
}

SurfaceMesh withDoubles(SurfaceMesh mesh) {
  const std::size_t faces = mesh.faces.size();
  for (std::size_t i = 0; i < faces; i += 4) {
    const Face f = mesh.faces[i];
    if (f.size() == 4) continue;
    mesh.faces.push_back({{f[1], f[2], f[0], -1}});
    mesh.faces.push_back({{f[0], f[1], f[0], -1}});
    mesh.vertices.emplace_back(0.5 * (mesh.corner(f, 0) + mesh.corner(f, 1)));
    mesh.faces.push_back({{f[0], f[1], static_cast<int>(mesh.vertices.size()) - 1, -1}});
  }
  return mesh;
}

SurfaceMesh withInterior(const SurfaceMesh& frigate) {
  SurfaceMesh mesh = frigate;
  for (int i = 0; i < 30; ++i)
    addRectangle(mesh, {-40.0 + 2.5 * i, -3.0, -2.0}, {2.5, 0, 0}, {0, 6.0, 0});
  for (const double x : {-30.0, -10.0, 10.0, 30.0})
    addRectangle(mesh, {x, -4.5, -3.5}, {0, 9.0, 0}, {0, 0, 6.5});
  addBox(mesh, {-5, -3, -3.5}, {5, 3, -1.5});
  return mesh;
}

SurfaceMesh withHoles(const SurfaceMesh& mesh, const std::vector<Vec3>& places, double radius) {
  SurfaceMesh out{mesh.vertices, {}};
  for (const Face& f : mesh.faces) {
    const Vec3 centre = centreOf(mesh, f);
    if (std::none_of(places.begin(), places.end(),
                     [&](const Vec3& p) { return (p - centre).norm() < radius; }))
      out.faces.push_back(f);
  }
  return out;
}

SurfaceMesh openAtKeel(SurfaceMesh mesh, double gap) {
  for (const Face& f : mesh.faces) {
    const double side = centreOf(mesh, f).y() > 0 ? gap : -gap;
    for (int i = 0; i < f.size(); ++i) {
      Vec3& p = mesh.vertices[static_cast<std::size_t>(f[i])];
      if (p.z() < 0 && std::abs(p.y()) < gap) p.y() = side;
    }
  }
  return mesh;
}

SurfaceMesh portHalf(const SurfaceMesh& mesh) {
  SurfaceMesh out{mesh.vertices, {}};
  for (const Face& f : mesh.faces)
    if (centreOf(mesh, f).y() > 0) out.faces.push_back(f);
  return welded(out, 0.0);
}

}  // namespace cutwater::test
