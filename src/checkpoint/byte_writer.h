#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/io/digest.h"

namespace fluidymation {

/// Puts numbers and texts one behind the other, lowest byte first, whatever the machine's order is.
class ByteWriter {
 public:
  void byte(std::uint8_t value) { bytes_.push_back(value); }
  void number(std::uint32_t value) { words(std::array<std::uint32_t, 1>{value}); }
  void number(std::int32_t value) { number(static_cast<std::uint32_t>(value)); }
  void number(float value) { number(bitsOf(value)); }
  void number(double value) {
    std::uint64_t bits = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    number(static_cast<std::uint32_t>(bits));
    number(static_cast<std::uint32_t>(bits >> 32U));
  }
  /// Several numbers at once, which is faster.
  template <std::size_t N>
  void words(const std::array<std::uint32_t, N>& values) {
    std::array<std::uint8_t, 4 * N> bytes;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        bytes[4 * i + k] = static_cast<std::uint8_t>(values[i] >> (8 * k));
      }
    }
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  [[nodiscard]] static std::uint32_t bitsOf(float value) {
    std::uint32_t bits = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
  }
  void count(std::size_t value) { number(static_cast<std::uint32_t>(value)); }
  void text(const std::string& value) {
    count(value.size());
    bytes_.insert(bytes_.end(), value.begin(), value.end());
  }
  void digest(const Digest& value) {
    bytes_.insert(bytes_.end(), value.bytes.begin(), value.bytes.end());
  }

  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }
  void reserve(std::size_t byteCount) { bytes_.reserve(byteCount); }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace fluidymation
