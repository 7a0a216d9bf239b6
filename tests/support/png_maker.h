#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "support/temporary_folder.h"

namespace fluidymation::test {

enum class PngColor { kGray, kPalette, kRgb, kGrayAlpha, kRgba };

/// A PNG file of any kind the format knows, well formed.
struct PngSpec {
  Size size;
  PngColor color = PngColor::kGray;
  int bitDepth = 8;
  bool interlaced = false;
  std::vector<std::uint16_t> samples;  ///< rows top to bottom, channels interleaved, 0..2^depth-1
  std::vector<std::array<std::uint8_t, 3>> palette;
  std::vector<std::uint8_t> paletteAlpha;                   ///< tRNS of a palette image
  std::optional<std::array<std::uint16_t, 3>> transparent;  ///< tRNS of a gray or RGB image
  std::optional<double> gamma;                              ///< gAMA
  bool srgb = false;                                        ///< sRGB
};

[[nodiscard]] int channelsOf(PngColor color);
[[nodiscard]] Bytes makePng(const PngSpec& spec);

/// One chunk of a PNG file, to build hostile ones from.
struct PngChunk {
  std::string name;
  Bytes data;
};

[[nodiscard]] std::vector<PngChunk> splitPng(const Bytes& file);
/// The chunks behind the signature, with right lengths and check sums.
[[nodiscard]] Bytes joinPng(const std::vector<PngChunk>& chunks);

/// IHDR data.
[[nodiscard]] Bytes pngHeader(std::uint32_t width, std::uint32_t height, int bitDepth,
                              int colorType, int interlace = 0);

/// zlib stream of `count` zero bytes.
[[nodiscard]] Bytes deflatedZeros(std::size_t count);

}  // namespace fluidymation::test
