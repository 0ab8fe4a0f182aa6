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

}  // namespace cutwater
