#include "hydro/Errors.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace cutwater::test {
namespace {

// The enumerators as the header lists them: name and number of the bit.
std::map<std::string, int> listedBits() {
  std::ifstream file(CUTWATER_TEST_DATA "/../hydro/Errors.h");
  std::stringstream text;
  text << file.rdbuf();
  const std::string header = text.str();
  const std::regex row(R"((k\w+)\s+=\s+1u << (\d+))");
  std::map<std::string, int> bits;
  for (std::sregex_iterator found(header.begin(), header.end(), row), end; found != end; ++found) {
    bits[(*found)[1]] = std::stoi((*found)[2]);
  }
  return bits;
}

TEST(FaultText, EveryBitOfTheHeaderHasItsNameAndAPhraseOfItsOwn) {
  const auto bits = listedBits();
  ASSERT_GE(bits.size(), 16u);
  std::set<std::string> phrases;
  for (const auto& [name, number] : bits) {
    const auto bit = static_cast<StepFault>(1u << number);
    EXPECT_EQ(faultName(bit), name);
    const std::string phrase = faultText(bit);
    EXPECT_EQ(phrase.find("without a name"), std::string::npos) << name;
    EXPECT_EQ(phrase.find(';'), std::string::npos) << name << ": joins phrases, so not within one";
    EXPECT_TRUE(phrases.insert(phrase).second) << phrase;
  }
}

TEST(FaultText, PhrasesAreJoinedInOrderAndUnknownBitsAreNumbers) {
  EXPECT_EQ(faultText(kStepOk), "");
  EXPECT_EQ(faultText(kLoadNotFinite | kOutOfWater | 1u << 31),
            faultText(kLoadNotFinite) + "; " + faultText(kOutOfWater) +
                "; a fault without a name, bit 31");
  EXPECT_EQ(faultName(kStepOk), "");
  EXPECT_EQ(faultName(static_cast<StepFault>(kLoadNotFinite | kOutOfWater)), "");
}

}  // namespace
}  // namespace cutwater::test
