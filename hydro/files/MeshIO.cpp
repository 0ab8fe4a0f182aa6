#include "hydro/files/MeshIO.h"

#include <assimp/BaseImporter.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "hydro/Errors.h"
#include "hydro/files/ColladaCheck.h"
#include "hydro/files/GdfReader.h"
#include "hydro/files/PlyOffReader.h"
#include "hydro/files/Polygons.h"

namespace cutwater {
namespace {

constexpr std::uintmax_t kLargestFile = 1u << 29;  // 512 MB
constexpr std::size_t kMostFaces = 4'000'000;      // a panel code uses thousands
constexpr int kDeepestNode = 200;                  // of a scene's tree

const char* const kAssimpEndings[] = {"obj", "stl", "gltf", "glb", "dae"};

[[noreturn]] void malformed(const std::string& path, const std::string& what) {
  throw HydroError(Fault::FileMalformed, path + ": " + what);
}

std::string ending(const std::string& path) {
  std::string e = std::filesystem::path(path).extension().string();
  if (!e.empty()) e.erase(0, 1);
  for (char& c : e) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return e;
}

bool isDefault(const std::string& e) {
  return std::find(std::begin(kAssimpEndings), std::end(kAssimpEndings), e) !=
         std::end(kAssimpEndings);
}

/// Size of a file that can be read. @throws FileNotReadable, MeshEmpty, ValueOutOfRange.
void checkFile(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw HydroError(Fault::FileNotReadable, path + ": no such file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || !std::ifstream(path, std::ios::binary))
    throw HydroError(Fault::FileNotReadable, path + ": cannot be opened");
  if (size == 0) throw HydroError(Fault::MeshEmpty, path + ": file is empty");
  if (size > kLargestFile)
    throw HydroError(Fault::ValueOutOfRange, path + ": " + std::to_string(size) +
                                                 " bytes, more than a hull file's " +
                                                 std::to_string(kLargestFile));
}

std::string wholeFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class AssimpReader {
 public:
  AssimpReader(const std::string& path, bool anyFormat) : path_(path) {
    if (!anyFormat) keepOnly(ending(path));
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  }

  SurfaceMesh read() {
    const aiScene* scene = importer_.ReadFile(path_, 0);
    if (!scene || !scene->mRootNode) {
      std::string why = importer_.GetErrorString();
      std::replace(why.begin(), why.end(), '\n', ' ');
      malformed(path_, "cannot be read: " + why.substr(0, 200));
    }
    addNode(*scene, *scene->mRootNode, Eigen::Matrix4d::Identity(), 0);
    return mesh_;
  }

 private:
  /// Leaves only the importers made for this ending, so that no other guesses from the content.
  void keepOnly(const std::string& wanted) {
    for (std::size_t i = importer_.GetImporterCount(); i-- > 0;) {
      std::istringstream endings(importer_.GetImporterInfo(i)->mFileExtensions);
      std::string one;
      bool keep = false;
      while (endings >> one) keep = keep || one == wanted;
      if (keep) continue;
      Assimp::BaseImporter* unwanted = importer_.GetImporter(i);
      if (importer_.UnregisterLoader(unwanted) == aiReturn_SUCCESS) delete unwanted;
    }
  }

  void addNode(const aiScene& scene, const aiNode& node, const Eigen::Matrix4d& parent, int depth) {
    if (depth > kDeepestNode) malformed(path_, "scene nodes nested deeper than 200");
    Eigen::Matrix4d local;
    for (unsigned r = 0; r < 4; ++r)
      for (unsigned c = 0; c < 4; ++c)
        local(static_cast<int>(r), static_cast<int>(c)) = node.mTransformation[r][c];
    const Eigen::Matrix4d placed = parent * local;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene.mNumMeshes)
        throw HydroError(Fault::MeshIndexOutOfRange, path_ + ": a node names mesh " +
                                                         std::to_string(node.mMeshes[i]) + " of " +
                                                         std::to_string(scene.mNumMeshes));
      addMesh(*scene.mMeshes[node.mMeshes[i]], placed);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      addNode(scene, *node.mChildren[i], placed, depth + 1);
  }

  void addMesh(const aiMesh& part, const Eigen::Matrix4d& place) {
    if (mesh_.faces.size() + part.mNumFaces > kMostFaces)
      throw HydroError(Fault::ValueOutOfRange,
                       path_ + ": more than " + std::to_string(kMostFaces) + " faces");
    const int offset = static_cast<int>(mesh_.vertices.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& v = part.mVertices[i];
      const Vec3 p = (place * Eigen::Vector4d(v.x, v.y, v.z, 1.0)).head<3>();
      if (!p.allFinite())
        throw HydroError(Fault::MeshNotFinite,
                         path_ + ": vertex " + std::to_string(i) + " of mesh '" +
                             part.mName.C_Str() + "' is (" + std::to_string(v.x) + ", " +
                             std::to_string(v.y) + ", " + std::to_string(v.z) + ")");
      mesh_.vertices.push_back(p);
    }
    for (unsigned k = 0; k < part.mNumFaces; ++k) {
      const aiFace& face = part.mFaces[k];
      if (face.mNumIndices > static_cast<unsigned>(kMostCorners))
        malformed(path_, "face " + std::to_string(k) + " has " + std::to_string(face.mNumIndices) +
                             " corners");
      std::vector<int> corners;
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        if (face.mIndices[i] >= part.mNumVertices)
          throw HydroError(Fault::MeshIndexOutOfRange,
                           path_ + ": face " + std::to_string(k) + " names vertex " +
                               std::to_string(face.mIndices[i]) + " of " +
                               std::to_string(part.mNumVertices));
        corners.push_back(offset + static_cast<int>(face.mIndices[i]));
      }
      addPolygon(mesh_, corners);
    }
  }

  std::string path_;
  Assimp::Importer importer_;
  SurfaceMesh mesh_;
};

Vec3 axis(const std::string& name, const char* key) {
  const bool minus = name.starts_with('-');
  const std::string letter = name.substr(minus || name.starts_with('+') ? 1 : 0);
  if (letter != "x" && letter != "y" && letter != "z")
    throw HydroError(Fault::BadArgument,
                     std::string(key) + " = \"" + name + "\" is none of x, -x, y, -y, z, -z");
  return (minus ? -1.0 : 1.0) * Vec3::Unit(letter[0] - 'x');
}

double metresPer(const std::string& unit) {
  if (unit == "m") return 1.0;
  if (unit == "mm") return 1e-3;
  if (unit == "cm") return 1e-2;
  if (unit == "ft") return 0.3048;
  if (unit == "in") return 0.0254;
  throw HydroError(Fault::BadArgument, "unit = \"" + unit + "\" is none of m, mm, cm, ft, in");
}

void checkPose(const MeshReadOptions& o) {
  const auto refuse = [](const char* key, double value, const char* rule) {
    std::ostringstream line;
    line << key << " = " << value << ": must be " << rule;
    throw HydroError(Fault::ValueOutOfRange, line.str());
  };
  if (!(std::abs(o.waterline) <= 1e6)) refuse("waterline", o.waterline, "within 1e6");
  if (!(std::abs(o.trimDeg) < 90.0)) refuse("trim_deg", o.trimDeg, "below 90 either way");
  if (!(std::abs(o.heelDeg) < 90.0)) refuse("heel_deg", o.heelDeg, "below 90 either way");
}

SurfaceMesh readFaces(const std::string& path, bool anyFormat, bool& mirrored) {
  checkFile(path);
  const std::string format = ending(path);
  if (format == "gdf") {
    GdfSurface gdf = parseGdf(wholeFile(path), path);
    mirrored = gdf.mirrored;
    return gdf.mesh;
  }
  if (format == "ply") return parsePly(wholeFile(path), path);
  if (format == "off") return parseOff(wholeFile(path), path);
  if (!isDefault(format) && !anyFormat)
    throw HydroError(Fault::FormatNotSupported,
                     path + ": '." + format + "' is " +
                         (Assimp::Importer().IsExtensionSupported("." + format)
                              ? "read only with any_format = true; by default: "
                              : "not read; what is: ") +
                         ".obj .stl .ply .gltf .glb .off .dae .gdf");
  if (format == "dae") checkCollada(wholeFile(path), path);
  try {
    return AssimpReader(path, anyFormat).read();
  } catch (const HydroError&) {
    throw;
  } catch (const std::exception& e) {
    malformed(path, std::string("cannot be read: ") + e.what());
  }
}

Symmetry symmetryFrom(const std::string& name) {
  if (name == "auto") return Symmetry::Auto;
  if (name == "none") return Symmetry::None;
  if (name == "half") return Symmetry::Half;
  throw HydroError(Fault::BadArgument,
                   "symmetric = \"" + name + "\" is none of \"auto\", \"none\", \"half\"");
}

struct TurnedSurface {
  SurfaceMesh mesh;  ///< in hull axes
  Symmetry symmetry;
  FilePlacement file;
};

TurnedSurface readTurned(const std::string& path, const MeshReadOptions& options) {
  TurnedSurface read{{}, symmetryFrom(options.symmetric), {}};
  bool mirrored = false;
  read.mesh = readFaces(path, options.anyFormat, mirrored);
  if (read.mesh.faces.empty()) throw HydroError(Fault::MeshEmpty, path + ": no faces");
  read.file = filePlacement(options);
  for (Vec3& p : read.mesh.vertices) p = read.file.toHull(p);
  // A GDF file with ISY = 1 holds a half, but its reader has added the other already.
  if (mirrored && read.symmetry == Symmetry::Half) read.symmetry = Symmetry::Auto;
  return read;
}

}  // namespace

FilePlacement filePlacement(const MeshReadOptions& o) {
  const Vec3 up = axis(o.up, "up"), forward = axis(o.forward, "forward");
  if (up.dot(forward) != 0.0)
    throw HydroError(Fault::BadArgument,
                     "up = \"" + o.up + "\" and forward = \"" + o.forward + "\" are the same axis");
  FilePlacement file;
  file.metresPerUnit = metresPer(o.unit);
  checkPose(o);
  Mat3 turn;
  turn << forward, up.cross(forward), up;
  const Mat3 pose = (Eigen::AngleAxisd(o.trimDeg * kPi / 180, Vec3::UnitY()) *
                     Eigen::AngleAxisd(o.heelDeg * kPi / 180, Vec3::UnitX()))
                        .toRotationMatrix();
  file.rotation = pose * turn.transpose();
  file.origin = pose * (-file.metresPerUnit * o.waterline * Vec3::UnitZ());
  return file;
}

SurfaceMesh readSurface(const std::string& path, const MeshReadOptions& options) {
  return readTurned(path, options).mesh;
}

Hull readHull(const std::string& path, const MeshReadOptions& options) {
  const TurnedSurface read = readTurned(path, options);
  Hull hull = makeHull(read.mesh, path, read.symmetry);
  hull.file = read.file;
  return hull;
}

RepairedHull readRepaired(const std::string& path, const MeshReadOptions& options) {
  const TurnedSurface read = readTurned(path, options);
  RepairedHull repaired = repairedHull(read.mesh, path, read.symmetry);
  repaired.hull.file = read.file;
  return repaired;
}

CrackedHull readCracked(const std::string& path, const MeshReadOptions& options) {
  const TurnedSurface read = readTurned(path, options);
  CrackedHull made = crackedHull(read.mesh, path, read.symmetry);
  made.hull.file = read.file;
  return made;
}

AnyHull readAnyHull(const std::string& path, int count, const MeshReadOptions& options,
                    PanelsBy by) {
  const TurnedSurface read = readTurned(path, options);
  AnyHull made = anyHull(read.mesh, count, path, read.symmetry, by);
  made.hull.file = read.file;
  return made;
}

}  // namespace cutwater
