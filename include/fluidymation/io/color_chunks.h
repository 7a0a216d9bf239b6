#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fluidymation {

/// Name of a profile whose own is no PNG keyword, such as one of blanks: no file may hold it, and
/// it says nothing about colours.
inline constexpr const char* kUnnamedProfile = "ICC profile";

/// What a PNG file says about the meaning of its colour values: chunks sRGB, gAMA, cHRM and iCCP.
/// Values are those of the PNG specification.
struct ColorChunks {
  struct Profile {
    std::string name;                 ///< a PNG keyword: 1 to 79 printable bytes of Latin-1
    std::vector<std::uint8_t> bytes;  ///< ICC profile, unpacked
  };

  std::optional<int> srgbIntent;      ///< rendering intent, 0 to 3
  std::optional<std::int32_t> gamma;  ///< encoding exponent, in 100000ths
  /// x and y of white, red, green and blue, in 100000ths.
  std::optional<std::array<std::int32_t, 8>> chromaticities;
  std::optional<Profile> profile;
};

[[nodiscard]] bool operator==(const ColorChunks& a, const ColorChunks& b);
[[nodiscard]] inline bool operator!=(const ColorChunks& a, const ColorChunks& b) {
  return !(a == b);
}

/// "sRGB, gAMA"; "none".
[[nodiscard]] std::string namesOf(const ColorChunks& chunks);

/// What was found of them in a file.
struct FoundColorChunks {
  ColorChunks chunks;
  /// Names of those that are there and cannot be carried along, "iCCP": damaged, against each
  /// other, or profiles of other than RGB pictures. Empty where there are none.
  std::string refused;
};

/// Reads the chunks before a PNG file's pixels. They are those of the values that `readPng` gives:
/// where it undoes an exponent, the gamma found is sRGB's, 45455. Where sRGB or iCCP were stored,
/// values are as they were. A profile that unpacks to more than 4 MB is refused; one with a bad
/// name is found as `kUnnamedProfile`.
/// @throws Error naming the file, as `readPng` does for what comes before the pixels.
[[nodiscard]] FoundColorChunks readColorChunks(const std::string& path);

}  // namespace fluidymation
