#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hydro/Errors.h"

namespace cutwater::test {

/// The call must throw a HydroError with this fault, in one line that holds each of these words.
template <class Call>
void expectRefusal(Fault fault, const std::vector<std::string>& words, Call call) {
  std::string what;
  try {
    call();
  } catch (const HydroError& error) {
    what = error.what();
    EXPECT_EQ(static_cast<int>(error.fault()), static_cast<int>(fault)) << what;
  }
  EXPECT_FALSE(what.empty()) << "not refused: " << words.front();
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  for (const std::string& word : words)
    EXPECT_NE(what.find(word), std::string::npos) << what << "\nlacks: " << word;
}

}  // namespace cutwater::test
