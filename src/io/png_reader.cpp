#include "io/png_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>
#include <system_error>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "fluidymation/io/input_limits.h"

namespace fluidymation {
namespace {

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

void onRead(png_structp png, png_bytep data, std::size_t byteCount) {
  auto& source = *static_cast<PngSource*>(png_get_io_ptr(png));
  if (byteCount > source.bytesLeft) png_error(png, "there is more data than its pixels need");
  source.bytesLeft -= byteCount;
  if (std::fread(data, 1, byteCount, source.file) == byteCount) return;
  png_error(png,
            std::ferror(source.file) != 0 ? "it cannot be read to its end" : "it ends too early");
}

}  // namespace

void failDamaged(const std::string& path, const std::string& reason) {
  throw Error(path + ": damaged PNG file (" + reason + ")");
}

InputFile openPng(const std::string& path) {
  return openInput(path, "a PNG file", kMaxImageFileBytes);
}

std::uint32_t bigEndian(const std::uint8_t* bytes) {
  return (std::uint32_t{bytes[0]} << 24U) | (std::uint32_t{bytes[1]} << 16U) |
         (std::uint32_t{bytes[2]} << 8U) | std::uint32_t{bytes[3]};
}

PngHeader readHeader(std::FILE* file, const std::string& path) {
  constexpr std::array<std::uint8_t, 16> kStart = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n',
                                                   0,    0,   0,   13,  'I',  'H',  'D',  'R'};
  constexpr std::size_t kSignatureLength = 8;
  std::array<std::uint8_t, kPngHeaderLength> bytes{};
  errno = 0;
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), file);
  if (std::ferror(file) != 0) {
    throw Error(path + ": cannot be read (" + std::generic_category().message(errno) + ")");
  }
  if (std::memcmp(bytes.data(), kStart.data(), std::min(got, kSignatureLength)) != 0) {
    throw Error(path + ": is no PNG file");
  }
  if (got < kPngHeaderLength) failDamaged(path, "it ends within the header");
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
  PngHeader header;
  header.size = {static_cast<int>(width), static_cast<int>(height)};
  header.bitDepth = bytes[24];
  header.colorType = bytes[25];
  return header;
}

void checkPlausible(const PngHeader& header, std::int64_t byteCount, const std::string& path) {
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

PngReader::PngReader(std::FILE* file, const std::string& path) : path_(path) {
  source_.file = file;
  png_ =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, libpng::onError, libpng::onWarning);
  if (png_ == nullptr) throw std::bad_alloc();
  info_ = png_create_info_struct(png_);
  if (info_ == nullptr) {
    png_destroy_read_struct(&png_, nullptr, nullptr);
    throw std::bad_alloc();
  }
  png_set_read_fn(png_, &source_, onRead);
}

void setLimits(png_structp png, ColorPrimaries primaries) {
  constexpr png_alloc_size_t kMaxChunkBytes = 4'000'000;  // unpacked; a colour profile has < 1 MB
  constexpr png_uint_32 kMaxChunks = 100;
  // Texts and the like are stepped over; they could be bombs, and we want nothing of them.
  // NOLINTNEXTLINE(modernize-avoid-c-arrays): names of five bytes each, as libpng wants them
  constexpr png_byte kUnused[] =
      "bKGD\0eXIf\0hIST\0iTXt\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0"
      "tEXt\0tIME\0zTXt";
  // NOLINTNEXTLINE(modernize-avoid-c-arrays): likewise
  constexpr png_byte kPrimaries[] = "cHRM";
  png_set_user_limits(png, kMaxImageSidePx, kMaxImageSidePx);
  png_set_chunk_malloc_max(png, kMaxChunkBytes);
  png_set_chunk_cache_max(png, kMaxChunks);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kUnused, sizeof kUnused / 5);
  if (primaries == ColorPrimaries::kSkipped) {
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kPrimaries, 1);
  }
  // A damaged tRNS or gAMA chunk would silently change what the picture means.
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
}

double declaredGamma(png_structp png, png_infop info) {
  constexpr double kSrgbLike = 1.0 / 2.2;
  constexpr double kTolerance = 0.05;  // relative; nobody sees less
  double gamma = 0.0;
  if (png_get_valid(png, info, PNG_INFO_sRGB) != 0) return 0.0;
  if (png_get_valid(png, info, PNG_INFO_iCCP) != 0) return 0.0;
  if (png_get_gAMA(png, info, &gamma) == 0) return 0.0;
  return std::abs(gamma / kSrgbLike - 1.0) < kTolerance ? 0.0 : gamma;
}

}  // namespace fluidymation
