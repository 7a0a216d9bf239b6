#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// sRGB-encoded colour, each channel in [0, 1].
struct Rgb {
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
};

/// The same with each channel as one of 0..255.
struct Rgb8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
};

/// "#f4f1e8"
[[nodiscard]] std::string colorText(Rgb8 color);

/// "#F4F1E8", "#fff", "white", "black" or "gray"; nothing for any other text.
[[nodiscard]] std::optional<Rgb> colorOf(const std::string& text);

/// CIELAB, D65 white, L in [0, 100]. The space in which patches are compared and averaged.
struct Lab {
  float l = 0.0F;
  float a = 0.0F;
  float b = 0.0F;
};

[[nodiscard]] float srgbDecode(float encoded);
[[nodiscard]] float srgbEncode(float linear);

[[nodiscard]] Lab toLab(Rgb color);
[[nodiscard]] Lab toLab(Rgb8 color);

/// Colours outside the sRGB gamut are clipped channel by channel.
[[nodiscard]] Rgb toRgb(Lab color);

/// Whether sRGB has the colour, but for what rounding does to colours at its limits.
[[nodiscard]] bool isInGamut(Lab color);

[[nodiscard]] Image<Lab> toLab(const Image<Rgb>& image);

/// A value in [0, 1] as the nearest of 0..255; what lies outside is clipped.
[[nodiscard]] std::uint8_t toByte(float value);

/// The same as the nearest of 0..65535.
[[nodiscard]] std::uint16_t to16Bits(float value);

/// `toByte` of each channel of `toRgb`, to the bit, without computing a power: the encoding only
/// grows, so 255 decision levels tell which byte a linear channel becomes. They are found with the
/// formula itself when it is built (about 0.2 ms).
class SrgbByteEncoder {
 public:
  SrgbByteEncoder();

  [[nodiscard]] Rgb8 operator()(Lab color) const;

  /// `toByte(srgbEncode(linear))`; what lies outside [0, 1] is clipped, NaN is 0.
  [[nodiscard]] std::uint8_t byte(float linear) const;

 private:
  /// Least linear value of each byte; beyond the last one there is none.
  std::array<float, 257> leastLinear_{};
  /// The byte at the lower end of each interval of linear values. Intervals are those of floats
  /// that share their exponent and upper mantissa bits, from the first one that is not all 0.
  std::vector<std::uint8_t> byteAt_;
  std::uint32_t firstInterval_ = 0;
};

}  // namespace fluidymation
