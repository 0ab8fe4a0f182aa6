#include "hydro/geometry/GdfReader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "hydro/Errors.h"

namespace cutwater {
namespace {

constexpr std::string_view kBlank = " \t\r,";

/// The number a word stands for; Fortran's 1.0D+00 included.
std::optional<double> number(std::string word) {
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* last = word.data() + word.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (end != last || (error != std::errc() && error != std::errc::result_out_of_range))
    return std::nullopt;
  return error == std::errc() ? value : std::numeric_limits<double>::infinity();
}

class GdfText {
 public:
  GdfText(const std::string& text, const std::string& name) : rest_(text), name_(name) {}

  /// False at the end of the file.
  bool nextLine() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++lineNumber_;
    return true;
  }

  /// The next number of this or later lines.
  double next(const char* what) {
    std::string word = nextWord();
    while (word.empty()) {
      if (!nextLine()) fail(std::string("the file ends before ") + what);
      word = nextWord();
    }
    const std::optional<double> value = number(word);
    if (!value) fail("'" + word.substr(0, 40) + "' is not a number (" + what + ")");
    return *value;
  }

  /// A record on a line of its own.
  double nextRecord(const char* what) {
    if (!nextLine()) fail(std::string("the file ends before ") + what);
    return next(what);
  }

  /// What is left of this line is commentary.
  void endRecord() { line_ = {}; }

  [[noreturn]] void fail(const std::string& what, Fault fault = Fault::FileMalformed) const {
    throw HydroError(fault, name_ + ": line " + std::to_string(lineNumber_) + ": " + what);
  }

 private:
  std::string nextWord() {
    const std::size_t begin = line_.find_first_not_of(kBlank);
    if (begin == std::string_view::npos) return {};
    line_.remove_prefix(begin);
    const std::size_t end = std::min(line_.find_first_of(kBlank), line_.size());
    const std::string word(line_.substr(0, end));
    line_.remove_prefix(end);
    return word;
  }

  std::string_view rest_, line_;
  std::string name_;
  int lineNumber_ = 0;
};

bool flag(GdfText& text, double value, const char* what) {
  if (value != 0.0 && value != 1.0)
    text.fail(std::string(what) + " is " + std::to_string(value) + ", not 0 or 1");
  return value == 1.0;
}

SurfaceMesh withImage(const SurfaceMesh& mesh, int axis) {
  SurfaceMesh image = turnedOver(mesh);
  for (Vec3& p : image.vertices) p[axis] = -p[axis];
  return joined(mesh, image);
}

}  // namespace

GdfSurface parseGdf(const std::string& file, const std::string& name) {
  GdfText text(file, name);
  text.nextLine();  // free text
  if (const double length = text.nextRecord("ULEN"); !(length > 0))
    text.fail("ULEN is " + std::to_string(length) + ", not positive");
  text.next("GRAV");
  const bool symmetricX = flag(text, text.nextRecord("ISX"), "ISX");
  const bool symmetricY = flag(text, text.next("ISY"), "ISY");
  const double panels = text.nextRecord("NPAN");
  text.endRecord();
  if (panels == 0) text.fail("NPAN is 0: no panels", Fault::MeshEmpty);
  // A panel takes at least 24 characters ("0 0 0 …"), so a count that lies cannot make us allocate.
  if (!(panels > 0) || panels != std::floor(panels) ||
      panels > static_cast<double>(file.size()) / 24.0)
    text.fail("NPAN is " + std::to_string(panels) + ", more than the file holds or not a count");

  GdfSurface out;
  for (int k = 0; k < static_cast<int>(panels); ++k) {
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
