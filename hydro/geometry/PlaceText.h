#pragma once
#include <cstdio>
#include <string>

#include "hydro/Conventions.h"

namespace cutwater {

/// A place as messages name it: "(1.2, 3.4, -5.6)".
inline std::string placeText(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x(), p.y(), p.z());
  return text;
}

/// "1 face", "2 faces"; `many` where an s does not do.
inline std::string counted(std::size_t n, const std::string& one, const std::string& many = {}) {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace cutwater
