#include <gtest/gtest.h>

#include <set>
#include <string>

#include "hydro/base/EnumNames.h"
#include "hydro/bem/settings/Formulation.h"

// The names of the solver's choices in files and commands.
namespace cutwater {
namespace {

template <class Enum, std::size_t count>
void expectNames(const std::array<const char*, count>& names,
                 const std::array<std::pair<Enum, const char*>, count>& wanted) {
  std::set<std::string> different;
  for (const auto& [value, name] : wanted) {
    EXPECT_STREQ(nameOf(names, value), name);
    const auto found = fromName<Enum>(names, name);
    ASSERT_TRUE(found.has_value()) << name;
    EXPECT_EQ(*found, value) << name;
    different.insert(name);
  }
  EXPECT_EQ(different.size(), count);
}

// Databases hold these words: a name that moved to another enumerator would be read as another
// method.
TEST(FormulationNames, AreThoseOfFilesAndCommands) {
  expectNames<Formulation>(kFormulationNames, {{{Formulation::Potential, "potential"},
                                                {Formulation::Source, "source"}}});
  expectNames<Derivatives>(kDerivativesNames,
                           {{{Derivatives::Stokes, "stokes"}, {Derivatives::Source, "source"}}});
  expectNames<Influence>(kInfluenceNames, {{{Influence::Adjoint, "adjoint"},
                                            {Influence::Direct, "direct"},
                                            {Influence::Matrix, "interpolated"},
                                            {Influence::Inverse, "inverse"}}});
}

TEST(FormulationNames, OthersAreNone) {
  EXPECT_FALSE(fromName<Formulation>(kFormulationNames, "Potential").has_value());
  EXPECT_FALSE(fromName<Influence>(kInfluenceNames, "").has_value());
  EXPECT_FALSE(fromName<Influence>(kInfluenceNames, "matrix").has_value());
}

}  // namespace
}  // namespace cutwater
