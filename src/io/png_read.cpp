#include "fluidymation/io/png.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "io/png_reader.h"

namespace fluidymation {
namespace {

/// Which samples libpng makes of a pixel.
enum class Samples {
  kRgba,
  kAsStored,  ///< gray or RGB, and alpha where the file says anything about it
};

/// What the rows look like once libpng has expanded them.
struct RowLayout {
  bool wide = false;         ///< 16 bits a sample, else 8
  std::size_t channels = 4;  ///< samples of a pixel: 1 gray, 2 gray and alpha, 3 RGB, 4 RGBA
  std::size_t rowBytes = 0;
  int passes = 1;      ///< 7 when interlaced
  double gamma = 0.0;  ///< the file's encoding exponent, to be undone; 0 when it is sRGB
};

/// Asks libpng for samples of 8 or 16 bits whatever the file has. Runs inside `libpng::attempt`.
void expand(png_structp png, png_infop info, Samples samples, RowLayout& layout) {
  png_set_expand(png);  // palette to RGB, 1, 2 and 4 bits to 8, tRNS to alpha
  if (samples == Samples::kRgba) {
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
  }
  layout.passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  layout.wide = png_get_bit_depth(png, info) == 16;
  layout.channels = png_get_channels(png, info);
  layout.rowBytes = png_get_rowbytes(png, info);
}

/// The sRGB-encoded value in [0, 1] of each sample value.
[[nodiscard]] std::vector<float> decodingTable(const RowLayout& layout) {
  const int largest = layout.wide ? 65535 : 255;
  std::vector<float> table(static_cast<std::size_t>(largest) + 1);
  for (int i = 0; i <= largest; ++i) {
    const float value = static_cast<float>(i) / static_cast<float>(largest);
    table[static_cast<std::size_t>(i)] = layout.gamma == 0.0
                                             ? value
                                             : srgbEncode(static_cast<float>(std::pow(
                                                   static_cast<double>(value), 1 / layout.gamma)));
  }
  return table;
}

/// Sample i of a row.
[[nodiscard]] std::size_t sampleAt(const png_byte* row, bool wide, std::size_t i) {
  if (!wide) return row[i];
  return (std::size_t{row[2 * i]} << 8U) | row[2 * i + 1];
}

[[nodiscard]] float largestSample(bool wide) { return wide ? 65535.0F : 255.0F; }

void decodeRow(const png_byte* row, bool wide, const float* table, int width, Rgba* pixels) {
  const auto sample = [row, wide](std::size_t i) { return sampleAt(row, wide, i); };
  const float largest = largestSample(wide);
  for (int x = 0; x < width; ++x) {
    const std::size_t i = 4 * static_cast<std::size_t>(x);
    pixels[x] = {table[sample(i)], table[sample(i + 1)], table[sample(i + 2)],
                 static_cast<float>(sample(i + 3)) / largest};
  }
}

/// Rec. 709 weights; gray stays exact.
[[nodiscard]] float luminance(float r, float g, float b) {
  if (r == g && g == b) return r;
  return 0.2126F * r + 0.7152F * g + 0.0722F * b;
}

/// `width` pixels of a row with samples as stored.
void decodeCoverage(const png_byte* row, const RowLayout& layout, MaskChannel channel,
                    const float* table, int width, float* coverage) {
  const std::size_t channels = layout.channels;
  const bool hasAlpha = channels % 2 == 0;
  if (channel == MaskChannel::kAlpha && !hasAlpha) {
    std::fill_n(coverage, width, 1.0F);
    return;
  }
  if (channels == 1 && !layout.wide) {  // what masks mostly are
    for (int x = 0; x < width; ++x) coverage[x] = table[row[x]];
    return;
  }
  for (int x = 0; x < width; ++x) {
    const std::size_t first = channels * static_cast<std::size_t>(x);
    const auto sample = [&](std::size_t i) { return sampleAt(row, layout.wide, first + i); };
    if (channel == MaskChannel::kAlpha) {
      coverage[x] = static_cast<float>(sample(channels - 1)) / largestSample(layout.wide);
    } else if (channels < 3) {
      coverage[x] = table[sample(0)];
    } else {
      coverage[x] = luminance(table[sample(0)], table[sample(1)], table[sample(2)]);
    }
  }
}

/// A file opened and read up to its pixels.
struct OpenPicture {
  InputFile input;
  PngHeader header;
  std::unique_ptr<PngReader> reader;
  RowLayout layout;
  bool mayBeTransparent = false;  ///< whether the file says anything about alpha
};

/// @throws Error also when the size is not `expected`.
[[nodiscard]] OpenPicture openPicture(const std::string& path, std::optional<Size> expected,
                                      Samples samples = Samples::kRgba) {
  OpenPicture picture;
  picture.input = openPng(path);
  picture.header = readHeader(picture.input.file.get(), path);
  checkPlausible(picture.header, picture.input.byteCount, path);
  std::rewind(picture.input.file.get());

  picture.reader = std::make_unique<PngReader>(picture.input.file.get(), path);
  auto* const png = picture.reader->png();
  auto* const info = picture.reader->info();
  Size found;
  picture.reader->run([&] {
    setLimits(png, ColorPrimaries::kSkipped);
    png_read_info(png, info);
    found = {static_cast<int>(png_get_image_width(png, info)),
             static_cast<int>(png_get_image_height(png, info))};
    picture.layout.gamma = declaredGamma(png, info);
    picture.mayBeTransparent = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                               png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    expand(png, info, samples, picture.layout);
  });
  // libpng reads the header once more, and somebody may write to the file meanwhile. The rows have
  // libpng's length, so nothing else than the size that was checked may pass.
  for (const Size size : {picture.header.size, expected.value_or(picture.header.size)}) {
    if (found == size) continue;
    throw Error(path + ": changed while being read (" + sizeText(size.width, size.height) +
                " pixels at first, then " + sizeText(found.width, found.height) + ")");
  }
  return picture;
}

/// Reads all rows.
/// @param decode  called with each row's number and its pixels as laid out, once they are complete.
template <typename Decode>
void readRows(const OpenPicture& picture, const Decode& decode) {
  PngReader& reader = *picture.reader;
  const RowLayout& layout = picture.layout;
  // An interlaced picture comes in seven sweeps over all rows, so all rows are kept.
  const bool keepRows = layout.passes > 1;
  const int height = picture.header.size.height;
  std::vector<png_byte> rows(layout.rowBytes * static_cast<std::size_t>(keepRows ? height : 1));
  const auto rowAt = [&](int y) {
    return rows.data() + (keepRows ? layout.rowBytes * static_cast<std::size_t>(y) : 0);
  };
  reader.run([&] {
    for (int pass = 0; pass < layout.passes; ++pass) {
      for (int y = 0; y < height; ++y) {
        const bool lastSweep = pass + 1 == layout.passes;
        reader.readRow(rowAt(y), layout.rowBytes, lastSweep && y + 1 == height);
        if (lastSweep) decode(y, rowAt(y));
      }
    }
    // The check sum of the last pixels, and that the end is there
    png_read_end(reader.png(), nullptr);
  });
}

/// @throws Error unless the file holds 16-bit RGB.
void requireRgb16(const PngHeader& header, const std::string& path) {
  if (header.bitDepth == 16 && header.colorType == PNG_COLOR_TYPE_RGB) return;
  throw Error(path + ": is a PNG file of " + std::to_string(header.bitDepth) +
              " bits and colour type " + std::to_string(header.colorType) +
              "; wanted 16 bits and type 2 (RGB)");
}

/// Whether any of `width` RGBA pixels is not opaque.
[[nodiscard]] bool anyTransparent(const png_byte* row, bool wide, int width) {
  const std::size_t sampleBytes = wide ? 2 : 1;
  for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
    const png_byte* alpha = row + (4 * x + 3) * sampleBytes;
    if (alpha[0] != 0xFF || alpha[sampleBytes - 1] != 0xFF) return true;
  }
  return false;
}

}  // namespace

Size readPngSize(const std::string& path) {
  const InputFile input = openPng(path);
  const PngHeader header = readHeader(input.file.get(), path);
  checkPlausible(header, input.byteCount, path);
  return header.size;
}

Image<Rgba> readPng(const std::string& path, std::optional<Size> expected) {
  const OpenPicture picture = openPicture(path, expected);
  const std::vector<float> table = decodingTable(picture.layout);
  Image<Rgba> image(picture.header.size);
  readRows(picture, [&](int y, const png_byte* row) {
    decodeRow(row, picture.layout.wide, table.data(), image.width(), image.row(y));
  });
  return image;
}

Size readRgb16Size(const std::string& path) {
  const InputFile input = openPng(path);
  const PngHeader header = readHeader(input.file.get(), path);
  checkPlausible(header, input.byteCount, path);
  requireRgb16(header, path);
  return header.size;
}

Image<Rgb16> readRgb16(const std::string& path, std::optional<Size> expected) {
  const OpenPicture picture = openPicture(path, expected);
  requireRgb16(picture.header, path);
  if (!picture.layout.wide) throw Error(path + ": changed while being read (no longer of 16 bits)");
  Image<Rgb16> image(picture.header.size);
  readRows(picture, [&](int y, const png_byte* row) {
    const auto sample = [row](std::size_t i) {
      return static_cast<std::uint16_t>((row[2 * i] << 8) | row[2 * i + 1]);
    };
    Rgb16* pixels = image.row(y);
    for (int x = 0; x < image.width(); ++x) {
      const std::size_t i = 4 * static_cast<std::size_t>(x);
      pixels[x] = {sample(i), sample(i + 1), sample(i + 2)};
    }
  });
  return image;
}

Image<Rgb> readColor(const std::string& path, std::optional<Size> expected) {
  const Image<Rgba> image = readPng(path, expected);
  Image<Rgb> color(image.size());
  std::transform(image.begin(), image.end(), color.begin(), [](const Rgba& p) {
    return Rgb{p.r, p.g, p.b};
  });
  return color;
}

bool hasTransparency(const std::string& path, std::optional<Size> expected) {
  const OpenPicture picture = openPicture(path, expected);
  if (!picture.mayBeTransparent) return false;
  PngReader& reader = *picture.reader;
  const RowLayout& layout = picture.layout;
  const Size size = picture.header.size;
  std::vector<png_byte> row(layout.rowBytes);
  bool found = false;
  reader.run([&] {
    for (int pass = 0; pass < layout.passes && !found; ++pass) {
      for (int y = 0; y < size.height && !found; ++y) {
        // A sweep over an interlaced picture leaves the pixels of the others as they are.
        std::fill(row.begin(), row.end(), png_byte{0xFF});
        reader.readRow(row.data(), layout.rowBytes,
                       pass + 1 == layout.passes && y + 1 == size.height);
        found = anyTransparent(row.data(), layout.wide, size.width);
      }
    }
  });
  return found;
}

Image<float> readCoverage(const std::string& path, MaskChannel channel,
                          std::optional<Size> expected) {
  const OpenPicture picture = openPicture(path, expected, Samples::kAsStored);
  const std::vector<float> table = decodingTable(picture.layout);
  Image<float> coverage(picture.header.size);
  readRows(picture, [&](int y, const png_byte* row) {
    decodeCoverage(row, picture.layout, channel, table.data(), coverage.width(), coverage.row(y));
  });
  return coverage;
}

}  // namespace fluidymation
