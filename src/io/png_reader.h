#pragma once

#include <png.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include "fluidymation/core/image.h"
#include "io/input_file.h"
#include "io/libpng_calls.h"

// What all readers of PNG files share: the checks before libpng sees a file, and libpng's handles.

namespace fluidymation {

/// @throws Error naming the file.
[[noreturn]] void failDamaged(const std::string& path, const std::string& reason);

/// @throws Error naming a file that cannot be opened, or is larger than `kMaxImageFileBytes`.
[[nodiscard]] InputFile openPng(const std::string& path);

/// What the file claims to be: the IHDR chunk, which is the first in every PNG file.
struct PngHeader {
  Size size;
  int bitDepth = 0;
  int colorType = 0;
};

/// Bytes before the second chunk: signature, chunk length, name, 13 bytes, check sum.
inline constexpr std::size_t kPngHeaderLength = 33;

[[nodiscard]] std::uint32_t bigEndian(const std::uint8_t* bytes);

/// Reads and checks the header, so that nothing is allocated for a size nobody means. Read here and
/// not by libpng, which would go on to all chunks before the pixels. @throws Error.
[[nodiscard]] PngHeader readHeader(std::FILE* file, const std::string& path);

/// A few bytes cannot hold many pixels: deflate packs at most 1032 bytes into one. Checked before
/// the picture is allocated, so that a small hostile file cannot ask for gigabytes. @throws Error.
void checkPlausible(const PngHeader& header, std::int64_t byteCount, const std::string& path);

/// Where libpng reads from, and how many bytes it may still have.
struct PngSource {
  std::FILE* file = nullptr;
  std::size_t bytesLeft = std::numeric_limits<std::size_t>::max();
};

/// libpng's handles for reading one file.
class PngReader {
 public:
  /// @param path  for messages; must outlive this.
  PngReader(std::FILE* file, const std::string& path);
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

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
  PngSource source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  libpng::Message message_{};
};

/// Whether libpng hands out what the file says of its colours, or steps over that.
enum class ColorPrimaries { kSkipped, kRead };

/// Bounds what libpng does with chunks. Runs inside `libpng::attempt`.
void setLimits(png_structp png, ColorPrimaries primaries);

/// The encoding exponent the file declares, 0 where its samples are (nearly) sRGB-encoded.
[[nodiscard]] double declaredGamma(png_structp png, png_infop info);

}  // namespace fluidymation
