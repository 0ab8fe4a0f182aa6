#pragma once
#include <string>

#include "hydro/geometry/SurfaceMesh.h"

/// The same mesh in every file format that is read by default, written by the tests themselves.
namespace cutwater::test {

/// A folder of its own for one test, removed with it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string path(const std::string& file) const { return folder_ + "/" + file; }
  /// Writes the content and returns the path.
  std::string write(const std::string& file, const std::string& content) const;

 private:
  std::string folder_;
};

std::string objText(const SurfaceMesh& mesh);
std::string stlText(const SurfaceMesh& mesh);
std::string stlBinary(const SurfaceMesh& mesh);
std::string plyText(const SurfaceMesh& mesh);
std::string plyBinary(const SurfaceMesh& mesh);
std::string offText(const SurfaceMesh& mesh);
/// One buffer inside the file as base64; node scaled by 2 and the vertices by ½, to exercise nodes.
std::string gltfText(const SurfaceMesh& mesh);
std::string glb(const SurfaceMesh& mesh);
/// Z_UP, in metres.
std::string colladaText(const SurfaceMesh& mesh);
/// @param perLine  numbers on a line.
std::string gdfText(const SurfaceMesh& mesh, int isx, int isy, int perLine = 3);

}  // namespace cutwater::test
