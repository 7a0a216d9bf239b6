#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/frame_part.h"
#include "fluidymation/core/image.h"
#include "fluidymation/io/color_chunks.h"
#include "fluidymation/io/compression_level.h"
#include "fluidymation/io/input_limits.h"

namespace fluidymation {

struct Rgba {
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
  float a = 1.0F;
};

/// Size claimed by the header of a PNG file; the pixels are not read.
/// @throws Error naming the file when it cannot be opened, is empty, is not a PNG, is larger than
///   `kMaxImageFileBytes`, or claims a size beyond `kMaxImageSidePx`, `kMaxImagePixels` or what a
///   file of its length can hold: whoever allocates for the size returned is safe from small
///   hostile files.
[[nodiscard]] Size readPngSize(const std::string& path);

/// Reads any PNG that libpng knows: 1 to 16 bit, gray, palette, RGB, with or without alpha or
/// transparency chunk, interlaced or not. Channels in [0, 1], sRGB-encoded, alpha straight (1 where
/// the file has none). 16-bit samples are sRGB-encoded like 8-bit ones unless a gAMA chunk (without
/// an sRGB or iCCP chunk) says otherwise.
/// @param expected  the size found earlier, where there was an earlier look: whoever planned with
///   it must not meet another one.
/// @throws Error naming the file; also for truncated and corrupt data, and for files that change
///   while they are read.
[[nodiscard]] Image<Rgba> readPng(const std::string& path,
                                  std::optional<Size> expected = std::nullopt);

/// A pixel of a file that holds data and no picture.
struct Rgb16 {
  std::uint16_t r = 0;
  std::uint16_t g = 0;
  std::uint16_t b = 0;
};

/// As `readPngSize` and `readPng` for files of 16-bit RGB, samples as stored: neither gamma nor
/// profile counts. @throws Error likewise, and for PNG files of another kind.
[[nodiscard]] Size readRgb16Size(const std::string& path);
[[nodiscard]] Image<Rgb16> readRgb16(const std::string& path,
                                     std::optional<Size> expected = std::nullopt);

/// The colour of an exemplar frame; alpha is ignored. `expected` as for `readPng`.
[[nodiscard]] Image<Rgb> readColor(const std::string& path,
                                   std::optional<Size> expected = std::nullopt);

/// Whether any pixel is not opaque: by its alpha, or by the transparency of its palette entry or
/// colour. Unpacks rows only where the file has one of these, and no further than the first such
/// pixel; what comes after it is not checked. Needs memory for one row. `expected` as for
/// `readPng`.
[[nodiscard]] bool hasTransparency(const std::string& path,
                                   std::optional<Size> expected = std::nullopt);

/// What of a mask image tells inside from outside.
enum class MaskChannel { kAlpha, kBrightness };

/// What a mask image means, in [0, 1]: its alpha, or its luminance (Rec. 709 weights on the encoded
/// values). Inside is from 0.5 up. `expected` as for `readPng`.
[[nodiscard]] Image<float> readCoverage(const std::string& path, MaskChannel channel,
                                        std::optional<Size> expected = std::nullopt);

/// 8-bit straight-alpha pixel as written.
struct Rgba8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 0;
};

/// The same with 16 bits a channel.
struct Rgba16 {
  std::uint16_t r = 0;
  std::uint16_t g = 0;
  std::uint16_t b = 0;
  std::uint16_t a = 0;
};

/// What a PNG file holds besides its pixels.
struct PngContent {
  bool opaque = false;  ///< RGB: what pixels have of alpha is left out
  ColorChunks color;
};

/// A PNG file in memory.
/// @param compressionLevel  0 to 9 (asserted).
/// @throws Error with libpng's reason.
[[nodiscard]] std::vector<std::uint8_t> encodePng(const Image<Rgba8>& image,
                                                  int compressionLevel = kDefaultCompression,
                                                  const PngContent& content = {});
[[nodiscard]] std::vector<std::uint8_t> encodePng(const Image<Rgba16>& image,
                                                  int compressionLevel = kDefaultCompression,
                                                  const PngContent& content = {});
/// The same of a whole frame of which `image` shows a part, all samples zero beyond it.
[[nodiscard]] std::vector<std::uint8_t> encodePng(const Image<Rgba8>& image, const FramePart& part,
                                                  int compressionLevel = kDefaultCompression,
                                                  const PngContent& content = {});
[[nodiscard]] std::vector<std::uint8_t> encodePng(const Image<Rgba16>& image, const FramePart& part,
                                                  int compressionLevel = kDefaultCompression,
                                                  const PngContent& content = {});

/// Writes are atomic: under a temporary name in the same folder, flushed, then renamed. On failure
/// the temporary file is removed and an older file of that name is left as it was.
/// @throws Error naming the file and the system's reason.
void writePng(const std::string& path, const Image<Rgba8>& image,
              int compressionLevel = kDefaultCompression);
void writeGrayPng(const std::string& path, const Image<std::uint8_t>& image);

}  // namespace fluidymation
