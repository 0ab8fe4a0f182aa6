#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace cutwater {

/// 64-bit hash of bytes, FNV-1a [Fowler, Noll, Vo]. Add all pieces, then ask for the value.
class Fnv1a {
 public:
  void add(const void* bytes, std::size_t n) noexcept {
    const auto* byte = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < n; ++i) hash_ = (hash_ ^ byte[i]) * 0x100000001b3ull;
  }
  std::uint64_t value() const noexcept { return hash_; }
  /// 16 hex digits.
  std::string digits() const {
    std::string text(16, '0');
    for (std::size_t i = 0; i < 16; ++i)
      text[15 - i] = "0123456789abcdef"[(hash_ >> (4 * i)) & 15u];
    return text;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace cutwater
