#include "tests/support/Results.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace cutwater::test {

bool fullSize() { return std::getenv("CUTWATER_FULL") != nullptr; }

void recordResult(const std::string& topic, const std::string& quantity,
                  const std::string& reference, double reached, const std::string& bound) {
  const char* path = std::getenv("CUTWATER_RESULTS");
  if (path == nullptr) return;
  char value[32];
  std::snprintf(value, sizeof value, "%.4g", reached);
  std::ofstream(path, std::ios::app)
      << topic << '\t' << quantity << '\t' << reference << '\t' << value << '\t' << bound << '\n';
}

}  // namespace cutwater::test
