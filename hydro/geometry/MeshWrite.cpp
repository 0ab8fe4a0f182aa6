#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "hydro/Errors.h"
#include "hydro/geometry/MeshIO.h"

namespace cutwater {
namespace {

/// Ten digits: more than single precision keeps, and 0.1 stays 0.1.
std::string text(const Vec3& p) {
  char line[96];
  std::snprintf(line, sizeof line, "%.10g %.10g %.10g\n", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
  return line;
}

void writeWhole(const std::string& path, const std::function<void(std::ostream&)>& write) {
  const std::string temporary = path + ".part" + std::to_string(::getpid());
  std::error_code error;
  {
    std::ofstream out(temporary, std::ios::binary);
    if (out) write(out);
    out.close();
    if (!out) {
      std::filesystem::remove(temporary, error);
      throw HydroError(Fault::FileNotWritable, path + ": cannot be written");
    }
  }
  std::filesystem::rename(temporary, path, error);
  if (!error) return;
  const std::string why = error.message();
  std::filesystem::remove(temporary, error);
  throw HydroError(Fault::FileNotWritable, path + ": " + why);
}

}  // namespace

void writeObj(const std::string& path, const SurfaceMesh& mesh, const std::string& comment) {
  writeWhole(path, [&](std::ostream& out) {
    std::istringstream lines(comment);
    for (std::string line; std::getline(lines, line);) out << "# " << line << '\n';
    for (const Vec3& p : mesh.vertices) out << "v " << text(p);
    for (const Face& f : mesh.faces) {
      out << 'f';
      for (int i = 0; i < f.size(); ++i) out << ' ' << f[i] + 1;
      out << '\n';
    }
  });
}

}  // namespace cutwater
