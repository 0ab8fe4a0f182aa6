#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace cutwater {

/// Names of the enumerators of an enum in files and commands, in the order of the enumerators. Each
/// name is written here only.
///     inline constexpr std::array kColourNames{"red", "green"};
///     nameOf(kColourNames, Colour::Green);         // "green"
///     fromName<Colour>(kColourNames, "red");       // Colour::Red

/// Name of an enumerator.
template <std::size_t count, class Enum>
constexpr const char* nameOf(const std::array<const char*, count>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

/// Enumerator with this name; absent if there is none.
template <class Enum, std::size_t count>
std::optional<Enum> fromName(const std::array<const char*, count>& names, const std::string& name) {
  for (std::size_t i = 0; i < count; ++i)
    if (name == names[i]) return static_cast<Enum>(i);
  return {};
}

}  // namespace cutwater
