#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace fluidymation {

/// Appends the four bytes of `value`, lowest first, whatever the machine's own order is.
inline void appendLittleEndian(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 0xFFU));
  }
}

inline void appendLittleEndian(std::vector<std::uint8_t>& bytes, float value) {
  static_assert(sizeof(float) == sizeof(std::uint32_t));
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  appendLittleEndian(bytes, bits);
}

/// Reads four bytes, lowest first.
[[nodiscard]] inline std::uint32_t littleEndian(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} | (std::uint32_t{bytes[1]} << 8U) |
         (std::uint32_t{bytes[2]} << 16U) | (std::uint32_t{bytes[3]} << 24U);
}

[[nodiscard]] inline float littleEndianFloat(const std::uint8_t* bytes) {
  const std::uint32_t bits = littleEndian(bytes);
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace fluidymation
