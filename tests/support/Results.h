#pragma once
#include <string>

namespace cutwater::test {

/// True when CUTWATER_FULL is set: every acceptance line at full size (`./run test --full`).
bool fullSize();

/// One line of tests/RESULTS.md: what was measured, against what, the number reached and its bound.
/// Written to the file that CUTWATER_RESULTS names; without it nothing is written. `topic` groups.
void recordResult(const std::string& topic, const std::string& quantity,
                  const std::string& reference, double reached, const std::string& bound);

}  // namespace cutwater::test
