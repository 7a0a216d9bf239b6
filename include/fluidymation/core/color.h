#pragma once

#include <cstdint>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// sRGB-encoded colour, each channel in [0, 1].
struct Rgb {
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
};

/// CIELAB, D65 white, L in [0, 100]. The space in which patches are compared and averaged.
struct Lab {
  float l = 0.0F;
  float a = 0.0F;
  float b = 0.0F;
};

[[nodiscard]] float srgbDecode(float encoded);
[[nodiscard]] float srgbEncode(float linear);

[[nodiscard]] Lab toLab(Rgb color);

/// Colours outside the sRGB gamut are clipped channel by channel.
[[nodiscard]] Rgb toRgb(Lab color);

[[nodiscard]] Image<Lab> toLab(const Image<Rgb>& image);

/// A value in [0, 1] as the nearest of 0..255; what lies outside is clipped.
[[nodiscard]] std::uint8_t toByte(float value);

}  // namespace fluidymation
