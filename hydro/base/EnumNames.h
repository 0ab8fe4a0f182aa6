#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace cutwater {

/// The words by which files and commands call the enumerators of an enum, in their order: the one
/// place where each is written.
template <std::size_t count>
using Words = std::array<const char*, count>;

/// The word of an enumerator.
template <std::size_t count, class Enum>
constexpr const char* wordOf(const Words<count>& words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

/// The enumerator of a word; absent if it is none of them.
template <class Enum, std::size_t count>
std::optional<Enum> fromWord(const Words<count>& words, const std::string& word) {
  for (std::size_t i = 0; i < count; ++i)
    if (word == words[i]) return static_cast<Enum>(i);
  return {};
}

}  // namespace cutwater
