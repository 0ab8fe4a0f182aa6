#include <cstdio>
#include <sstream>

#include "hydro/base/AtomicFile.h"
#include "hydro/files/MeshIO.h"

namespace cutwater {
namespace {

/// Ten digits: more than single precision keeps, and 0.1 stays 0.1.
std::string text(const Vec3& p) {
  char line[96];
  std::snprintf(line, sizeof line, "%.10g %.10g %.10g\n", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
  return line;
}

}  // namespace

void writeObj(const std::string& path, const SurfaceMesh& mesh, const std::string& comment) {
  std::string out;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) out += "# " + line + "\n";
  for (const Vec3& p : mesh.vertices) out += "v " + text(p);
  for (const Face& f : mesh.faces) {
    out += 'f';
    for (int i = 0; i < f.size(); ++i) out += ' ' + std::to_string(f[i] + 1);
    out += '\n';
  }
  writeWhole(path, out);
}

}  // namespace cutwater
