#include "hydro/files/GdfReader.h"

#include <charconv>
#include <system_error>

#include "hydro/files/TextScanner.h"

namespace cutwater {
namespace {

bool flag(const TextScanner& text, double value, const char* what) {
  if (value != 0.0 && value != 1.0)
    text.fail(std::string(what) + " is " + std::to_string(value) + ", not 0 or 1");
  return value == 1.0;
}

/// Higher-order files have a second whole number, IGDEF, after the number of patches: 0 for flat
/// ones, which are panels, others for surfaces that are no panels.
void refuseHigherOrder(TextScanner& text) {
  const std::string word = text.wordInLine();
  int kind = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), kind);
  if (error != std::errc() || end != word.data() + word.size() || kind == 0) return;
  const std::string what = kind == 1 ? "B-spline patches" : "surfaces by their own formulas";
  text.fail("IGDEF is " + word + ": a higher-order file of " + what +
                "; only low-order panels are read, export such a file or another mesh",
            Fault::FormatNotSupported);
}

SurfaceMesh withImage(const SurfaceMesh& mesh, int axis) {
  SurfaceMesh image = turnedOver(mesh);
  for (Vec3& p : image.vertices) p[axis] = -p[axis];
  return joined(mesh, image);
}

}  // namespace

GdfSurface parseGdf(const std::string& file, const std::string& name) {
  TextScanner text(file, name);
  text.nextLine();  // free text
  if (const double length = text.nextRecord("ULEN"); !(length > 0))
    text.fail("ULEN is " + std::to_string(length) + ", not positive");
  text.next("GRAV");
  const bool symmetricX = flag(text, text.nextRecord("ISX"), "ISX");
  const bool symmetricY = flag(text, text.next("ISY"), "ISY");
  text.endRecord();
  // Twelve numbers with a blank after each: a count that lies cannot make us allocate.
  const int panels = text.nextCount("NPAN", static_cast<double>(file.size()) / 23.0);
  refuseHigherOrder(text);
  text.endRecord();
  if (panels == 0) text.fail("NPAN is 0: no panels", Fault::MeshEmpty);

  GdfSurface out;
  for (int k = 0; k < panels; ++k) {
    Face face;
    for (int c = 0; c < 4; ++c) {
      Vec3 p;
      for (int i = 0; i < 3; ++i) p[i] = text.next("the last vertex");
      if (!p.allFinite())
        text.fail("vertex " + std::to_string(c + 1) + " of panel " + std::to_string(k + 1) +
                      " is not finite",
                  Fault::MeshNotFinite);
      face.v[static_cast<std::size_t>(c)] = static_cast<int>(out.mesh.vertices.size());
      out.mesh.vertices.push_back(p);
    }
    out.mesh.faces.push_back(face);
  }
  if (symmetricX) out.mesh = withImage(out.mesh, 0);
  if (symmetricY) out.mesh = withImage(out.mesh, 1);
  out.mirrored = symmetricY;
  return out;
}

}  // namespace cutwater
