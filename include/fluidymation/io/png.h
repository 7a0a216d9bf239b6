#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// Limits on what is read from files we do not know. A frame of 16384 x 16384 is far beyond film
/// sizes; the pixel limit keeps one decoded frame (16 bytes a pixel) below 2 GiB.
inline constexpr int kMaxImageSidePx = 16384;
inline constexpr std::int64_t kMaxImagePixels = 120'000'000;

struct Rgba {
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
  float a = 1.0F;
};

/// Size claimed by the header of a PNG file; the pixels are not read.
/// @throws Error naming the file when it cannot be opened, is empty, is not a PNG, or claims a size
///   beyond the limits above or beyond what a file of its length can hold: whoever allocates for
///   the size returned is safe from small hostile files.
[[nodiscard]] Size readPngSize(const std::string& path);

/// Reads any PNG that libpng knows: 1 to 16 bit, gray, palette, RGB, with or without alpha or
/// transparency chunk, interlaced or not. Channels in [0, 1], sRGB-encoded, alpha straight (1 where
/// the file has none). 16-bit samples are sRGB-encoded like 8-bit ones unless a gAMA chunk (without
/// an sRGB or iCCP chunk) says otherwise.
/// @throws Error naming the file; also for truncated and corrupt data.
[[nodiscard]] Image<Rgba> readPng(const std::string& path);

/// The colour of an exemplar frame; alpha is ignored.
[[nodiscard]] Image<Rgb> readColor(const std::string& path);

/// What a mask image means, in [0, 1]: its alpha where the image has an alpha that is not opaque
/// everywhere, else its luminance (Rec. 709 weights on the encoded values). Inside is from 0.5 up.
[[nodiscard]] Image<float> readCoverage(const std::string& path);

/// 8-bit straight-alpha pixel as written.
struct Rgba8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 0;
};

/// Writes are atomic: under a temporary name in the same folder, flushed, then renamed. On failure
/// the temporary file is removed and an older file of that name is left as it was.
/// @throws Error naming the file and the system's reason.
void writePng(const std::string& path, const Image<Rgba8>& image);
void writeGrayPng(const std::string& path, const Image<std::uint8_t>& image);

}  // namespace fluidymation
