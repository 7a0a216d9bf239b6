#include "support/png_maker.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <stdexcept>

namespace fluidymation::test {
namespace {

/// libpng reports a fault in the maker itself; there is no way on.
[[noreturn]] void onError(png_structp /*png*/, png_const_charp text) {
  throw std::logic_error(std::string("png_maker: ") + text);
}

void onWrite(png_structp png, png_bytep data, std::size_t count) {
  auto& bytes = *static_cast<Bytes*>(png_get_io_ptr(png));
  bytes.insert(bytes.end(), data, data + count);
}

[[nodiscard]] int colorType(PngColor color) {
  switch (color) {
    case PngColor::kGray:
      return PNG_COLOR_TYPE_GRAY;
    case PngColor::kPalette:
      return PNG_COLOR_TYPE_PALETTE;
    case PngColor::kRgb:
      return PNG_COLOR_TYPE_RGB;
    case PngColor::kGrayAlpha:
      return PNG_COLOR_TYPE_GRAY_ALPHA;
    case PngColor::kRgba:
      break;
  }
  return PNG_COLOR_TYPE_RGB_ALPHA;
}

void setTransparency(png_structp png, png_infop info, const PngSpec& spec) {
  if (!spec.paletteAlpha.empty()) {
    png_set_tRNS(png, info, spec.paletteAlpha.data(), static_cast<int>(spec.paletteAlpha.size()),
                 nullptr);
  }
  if (spec.transparent) {
    png_color_16 color{};
    color.gray = color.red = (*spec.transparent)[0];
    color.green = (*spec.transparent)[1];
    color.blue = (*spec.transparent)[2];
    png_set_tRNS(png, info, nullptr, 0, &color);
  }
}

/// Row `y` as one or two bytes a sample; libpng packs depths below 8.
[[nodiscard]] Bytes rowBytes(const PngSpec& spec, int y) {
  const auto perRow = static_cast<std::size_t>(spec.size.width * channelsOf(spec.color));
  Bytes row;
  for (std::size_t i = 0; i < perRow; ++i) {
    const std::uint16_t sample = spec.samples.at(static_cast<std::size_t>(y) * perRow + i);
    if (spec.bitDepth == 16) row.push_back(static_cast<std::uint8_t>(sample >> 8));
    row.push_back(static_cast<std::uint8_t>(sample & 0xFF));
  }
  return row;
}

void appendBigEndian(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 0xFFU));
  }
}

constexpr std::size_t kSignatureLength = 8;
constexpr std::array<std::uint8_t, kSignatureLength> kSignature = {0x89, 'P',  'N',  'G',
                                                                   '\r', '\n', 0x1A, '\n'};

}  // namespace

int channelsOf(PngColor color) {
  switch (color) {
    case PngColor::kGrayAlpha:
      return 2;
    case PngColor::kRgb:
      return 3;
    case PngColor::kRgba:
      return 4;
    default:
      return 1;
  }
}

Bytes makePng(const PngSpec& spec) {
  Bytes file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &file, onWrite, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(spec.size.width),
               static_cast<png_uint_32>(spec.size.height), spec.bitDepth, colorType(spec.color),
               spec.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette;
  for (const auto& entry : spec.palette) palette.push_back({entry[0], entry[1], entry[2]});
  if (!palette.empty()) {
    png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  }
  setTransparency(png, info, spec);
  if (spec.gamma) png_set_gAMA(png, info, *spec.gamma);
  if (spec.srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  png_set_packing(png);
  std::vector<Bytes> rows;
  for (int y = 0; y < spec.size.height; ++y) rows.push_back(rowBytes(spec, y));
  std::vector<png_bytep> rowPointers;
  for (Bytes& row : rows) rowPointers.push_back(row.data());
  png_write_image(png, rowPointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file;
}

std::vector<PngChunk> splitPng(const Bytes& file) {
  std::vector<PngChunk> chunks;
  std::size_t i = kSignatureLength;
  while (i < file.size()) {
    const std::size_t length = (std::size_t{file.at(i)} << 24U) |
                               (std::size_t{file.at(i + 1)} << 16U) |
                               (std::size_t{file.at(i + 2)} << 8U) | file.at(i + 3);
    const auto begin = file.begin() + static_cast<std::ptrdiff_t>(i) + 4;
    const auto dataEnd = begin + 4 + static_cast<std::ptrdiff_t>(length);
    chunks.push_back({std::string(begin, begin + 4), Bytes(begin + 4, dataEnd)});
    i += 12 + length;
  }
  return chunks;
}

Bytes joinPng(const std::vector<PngChunk>& chunks) {
  Bytes file(kSignature.begin(), kSignature.end());
  for (const PngChunk& chunk : chunks) {
    appendBigEndian(file, static_cast<std::uint32_t>(chunk.data.size()));
    const std::size_t begin = file.size();
    file.insert(file.end(), chunk.name.begin(), chunk.name.end());
    file.insert(file.end(), chunk.data.begin(), chunk.data.end());
    const uLong crc = crc32(0, file.data() + begin, static_cast<uInt>(file.size() - begin));
    appendBigEndian(file, static_cast<std::uint32_t>(crc));
  }
  return file;
}

Bytes pngHeader(std::uint32_t width, std::uint32_t height, int bitDepth, int colorType,
                int interlace) {
  Bytes data;
  appendBigEndian(data, width);
  appendBigEndian(data, height);
  data.push_back(static_cast<std::uint8_t>(bitDepth));
  data.push_back(static_cast<std::uint8_t>(colorType));
  data.push_back(0);
  data.push_back(0);
  data.push_back(static_cast<std::uint8_t>(interlace));
  return data;
}

Bytes deflatedZeros(std::size_t count) {
  const Bytes zeros(count);
  uLongf length = compressBound(static_cast<uLong>(count));
  Bytes packed(length);
  if (compress2(packed.data(), &length, zeros.data(), static_cast<uLong>(count), 9) != Z_OK) {
    throw std::logic_error("png_maker: compress2 failed");
  }
  packed.resize(length);
  return packed;
}

}  // namespace fluidymation::test
