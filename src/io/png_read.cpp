#include "fluidymation/io/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <system_error>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "io/input_file.h"
#include "io/libpng_calls.h"

namespace fluidymation {
namespace {

[[noreturn]] void failDamaged(const std::string& path, const std::string& reason) {
  throw Error(path + ": damaged PNG file (" + reason + ")");
}

// ---------------------------------------------------------------------------------------------
// The file and its header

[[nodiscard]] InputFile openPng(const std::string& path) {
  return openInput(path, "a PNG file", kMaxImageFileBytes);
}

/// What the file claims to be: the IHDR chunk, which is the first in every PNG file.
struct Header {
  Size size;
  int bitDepth = 0;
  int colorType = 0;
};

[[nodiscard]] std::uint32_t bigEndian(const std::uint8_t* bytes) {
  return (std::uint32_t{bytes[0]} << 24U) | (std::uint32_t{bytes[1]} << 16U) |
         (std::uint32_t{bytes[2]} << 8U) | std::uint32_t{bytes[3]};
}

/// The check sum of PNG chunks, bit by bit: it is only used on the 17 bytes of a header.
[[nodiscard]] std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
  }
  return ~crc;
}

/// Reads and checks the header, so that nothing is allocated for a size nobody means. Read here and
/// not by libpng, which would go on to all chunks before the pixels.
[[nodiscard]] Header readHeader(std::FILE* file, const std::string& path) {
  constexpr std::array<std::uint8_t, 16> kStart = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n',
                                                   0,    0,   0,   13,  'I',  'H',  'D',  'R'};
  constexpr std::size_t kSignatureLength = 8;
  constexpr std::size_t kHeaderLength = 33;  // signature, chunk length, name, 13 bytes, check sum
  std::array<std::uint8_t, kHeaderLength> bytes{};
  errno = 0;
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), file);
  if (std::ferror(file) != 0) {
    throw Error(path + ": cannot be read (" + std::generic_category().message(errno) + ")");
  }
  if (std::memcmp(bytes.data(), kStart.data(), std::min(got, kSignatureLength)) != 0) {
    throw Error(path + ": is no PNG file");
  }
  if (got < kHeaderLength) failDamaged(path, "it ends within the header");
  if (std::memcmp(bytes.data(), kStart.data(), kStart.size()) != 0 ||
      crc32(bytes.data() + 12, 17) != bigEndian(bytes.data() + 29)) {
    failDamaged(path, "its header is corrupt");
  }
  const std::int64_t width = bigEndian(bytes.data() + 16);
  const std::int64_t height = bigEndian(bytes.data() + 20);
  if (width < 1 || height < 1)
    failDamaged(path, "it claims " + sizeText(width, height) + " pixels");
  if (width > kMaxImageSidePx || height > kMaxImageSidePx || width * height > kMaxImagePixels) {
    throw Error(path + ": claims " + sizeText(width, height) + " pixels; wanted at most " +
                std::to_string(kMaxImageSidePx) + " a side and " +
                std::to_string(kMaxImagePixels / 1'000'000) + " million in all");
  }
  Header header;
  header.size = {static_cast<int>(width), static_cast<int>(height)};
  header.bitDepth = bytes[24];
  header.colorType = bytes[25];
  return header;
}

/// A few bytes cannot hold many pixels: deflate packs at most 1032 bytes into one. Checked before
/// the picture is allocated, so that a small hostile file cannot ask for gigabytes.
void checkPlausible(const Header& header, std::int64_t byteCount, const std::string& path) {
  constexpr std::int64_t kDeflateLimit = 1032;
  std::int64_t channels = 1;
  if (header.colorType == PNG_COLOR_TYPE_GRAY_ALPHA) channels = 2;
  if (header.colorType == PNG_COLOR_TYPE_RGB) channels = 3;
  if (header.colorType == PNG_COLOR_TYPE_RGB_ALPHA) channels = 4;
  const std::int64_t rowBytes = (header.size.width * channels * header.bitDepth + 7) / 8;
  if (rowBytes * header.size.height / kDeflateLimit <= byteCount) return;
  failDamaged(path, "its " + std::to_string(byteCount) + " bytes cannot hold the " +
                        sizeText(header.size.width, header.size.height) + " pixels it claims");
}

/// Where libpng reads from, and how many bytes it may still have.
struct Source {
  std::FILE* file = nullptr;
  std::size_t bytesLeft = std::numeric_limits<std::size_t>::max();
};

void onRead(png_structp png, png_bytep data, std::size_t byteCount) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (byteCount > source.bytesLeft) png_error(png, "there is more data than its pixels need");
  source.bytesLeft -= byteCount;
  if (std::fread(data, 1, byteCount, source.file) == byteCount) return;
  png_error(png,
            std::ferror(source.file) != 0 ? "it cannot be read to its end" : "it ends too early");
}

// ---------------------------------------------------------------------------------------------
// Reading

/// libpng's handles for reading one file.
class Reader {
 public:
  Reader(std::FILE* file, const std::string& path) : path_(path) {
    source_.file = file;
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, libpng::onError,
                                  libpng::onWarning);
    if (png_ == nullptr) throw std::bad_alloc();
    info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &source_, onRead);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }

  /// `body` calls libpng. @throws Error with libpng's reason.
  template <typename Body>
  void run(const Body& body) {
    if (!libpng::attempt(png_, body)) failDamaged(path_, message_.data());
  }

  /// Reads a row of `rowBytes` bytes. Runs inside `run`. With the last one of the last sweep libpng
  /// unpacks all that is left of the pixel data, wanted or not; a few kilobytes may be gigabytes
  /// then. So it is given no more than the row itself may need.
  void readRow(png_bytep row, std::size_t rowBytes, bool last) {
    constexpr std::size_t kSurplus = 16384;  // bytes as stored; libpng reads up to 8192 at a time
    if (last) source_.bytesLeft = rowBytes + kSurplus;
    png_read_row(png_, row, nullptr);
    source_.bytesLeft = std::numeric_limits<std::size_t>::max();
  }

 private:
  const std::string& path_;
  Source source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  libpng::Message message_{};
};

void setLimits(png_structp png) {
  constexpr png_alloc_size_t kMaxChunkBytes = 4'000'000;  // unpacked; a colour profile has < 1 MB
  constexpr png_uint_32 kMaxChunks = 100;
  // Texts and the like are stepped over; they could be bombs, and we want nothing of them.
  // NOLINTNEXTLINE(modernize-avoid-c-arrays): names of five bytes each, as libpng wants them
  constexpr png_byte kUnused[] =
      "bKGD\0cHRM\0eXIf\0hIST\0iTXt\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0"
      "tEXt\0tIME\0zTXt";
  png_set_user_limits(png, kMaxImageSidePx, kMaxImageSidePx);
  png_set_chunk_malloc_max(png, kMaxChunkBytes);
  png_set_chunk_cache_max(png, kMaxChunks);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kUnused, sizeof kUnused / 5);
  // A damaged tRNS or gAMA chunk would silently change what the picture means.
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
}

/// What the rows look like once libpng has expanded them to RGBA.
struct RowLayout {
  bool wide = false;  ///< 16 bits a sample, else 8
  std::size_t rowBytes = 0;
  int passes = 1;      ///< 7 when interlaced
  double gamma = 0.0;  ///< the file's encoding exponent, to be undone; 0 when it is sRGB
};

/// The encoding exponent the file declares, 0 where its samples are (nearly) sRGB-encoded.
[[nodiscard]] double declaredGamma(png_structp png, png_infop info) {
  constexpr double kSrgbLike = 1.0 / 2.2;
  constexpr double kTolerance = 0.05;  // relative; nobody sees less
  double gamma = 0.0;
  if (png_get_valid(png, info, PNG_INFO_sRGB) != 0) return 0.0;
  if (png_get_valid(png, info, PNG_INFO_iCCP) != 0) return 0.0;
  if (png_get_gAMA(png, info, &gamma) == 0) return 0.0;
  return std::abs(gamma / kSrgbLike - 1.0) < kTolerance ? 0.0 : gamma;
}

/// Asks libpng for RGBA of 8 or 16 bits whatever the file has. Runs inside `libpng::attempt`.
void expandToRgba(png_structp png, png_infop info, RowLayout& layout) {
  png_set_expand(png);  // palette to RGB, 1, 2 and 4 bits to 8, tRNS to alpha
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
  layout.passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  layout.wide = png_get_bit_depth(png, info) == 16;
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

void decodeRow(const png_byte* row, bool wide, const float* table, int width, Rgba* pixels) {
  const auto sample = [row, wide](std::size_t i) -> std::size_t {
    if (!wide) return row[i];
    return (std::size_t{row[2 * i]} << 8U) | row[2 * i + 1];
  };
  const float largest = wide ? 65535.0F : 255.0F;
  for (int x = 0; x < width; ++x) {
    const std::size_t i = 4 * static_cast<std::size_t>(x);
    pixels[x] = {table[sample(i)], table[sample(i + 1)], table[sample(i + 2)],
                 static_cast<float>(sample(i + 3)) / largest};
  }
}

/// A file opened and read up to its pixels.
struct OpenPicture {
  InputFile input;
  Header header;
  std::unique_ptr<Reader> reader;
  RowLayout layout;
  bool mayBeTransparent = false;  ///< whether the file says anything about alpha
};

/// @throws Error also when the size is not `expected`.
[[nodiscard]] OpenPicture openPicture(const std::string& path, std::optional<Size> expected) {
  OpenPicture picture;
  picture.input = openPng(path);
  picture.header = readHeader(picture.input.file.get(), path);
  checkPlausible(picture.header, picture.input.byteCount, path);
  std::rewind(picture.input.file.get());

  picture.reader = std::make_unique<Reader>(picture.input.file.get(), path);
  auto* const png = picture.reader->png();
  auto* const info = picture.reader->info();
  Size found;
  picture.reader->run([&] {
    setLimits(png);
    png_read_info(png, info);
    found = {static_cast<int>(png_get_image_width(png, info)),
             static_cast<int>(png_get_image_height(png, info))};
    picture.layout.gamma = declaredGamma(png, info);
    picture.mayBeTransparent = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                               png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    expandToRgba(png, info, picture.layout);
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
  Reader& reader = *picture.reader;
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
void requireRgb16(const Header& header, const std::string& path) {
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
  const Header header = readHeader(input.file.get(), path);
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
  const Header header = readHeader(input.file.get(), path);
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
  Reader& reader = *picture.reader;
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
  const Image<Rgba> image = readPng(path, expected);
  const auto luminance = [](const Rgba& p) {
    if (p.r == p.g && p.g == p.b) return p.r;  // gray stays exact
    return 0.2126F * p.r + 0.7152F * p.g + 0.0722F * p.b;
  };
  Image<float> coverage(image.size());
  std::transform(image.begin(), image.end(), coverage.begin(), [&](const Rgba& p) {
    return channel == MaskChannel::kAlpha ? p.a : luminance(p);
  });
  return coverage;
}

}  // namespace fluidymation
