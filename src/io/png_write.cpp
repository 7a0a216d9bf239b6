#include <png.h>
#include <zlib.h>

#include <cassert>
#include <exception>
#include <new>

#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/png.h"
#include "io/libpng_calls.h"

namespace fluidymation {
namespace {

/// Where the bytes go, and what the sink threw: an exception must not pass through libpng.
struct Output {
  const ByteSink& sink;
  std::exception_ptr failure;
};

void onWrite(png_structp png, png_bytep data, std::size_t byteCount) {
  auto* const output = static_cast<Output*>(png_get_io_ptr(png));
  try {
    output->sink(data, byteCount);
  } catch (...) {
    output->failure = std::current_exception();
  }
  if (output->failure) png_error(png, "the disk did not accept it");
}

void onFlush(png_structp /*png*/) {}

/// libpng's handles for writing one file.
class Writer {
 public:
  explicit Writer(const ByteSink& sink) : output_{sink, nullptr} {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message_, libpng::onError,
                                   libpng::onWarning);
    if (png_ == nullptr) throw std::bad_alloc();
    info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, &output_, onWrite, onFlush);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png_, &info_); }

  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }

  /// `body` calls libpng. @throws whatever the sink threw, else Error with libpng's reason.
  template <typename Body>
  void run(const Body& body) {
    if (libpng::attempt(png_, body)) return;
    if (output_.failure) std::rethrow_exception(output_.failure);
    throw Error(std::string("a picture cannot be encoded as PNG (") + message_.data() + ")");
  }

 private:
  Output output_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  libpng::Message message_{};
};

/// What libpng and zlib are told.
struct Compression {
  int filters = PNG_ALL_FILTERS;  ///< of these, each row gets the one that promises most
  int zlibLevel = Z_DEFAULT_COMPRESSION;
  int strategy = Z_FILTERED;
};

/// What a level stands for, see `kDefaultCompression`. Z_RLE looks at nothing but runs, whatever
/// zlib's level.
[[nodiscard]] Compression compressionOf(int level) {
  assert(level >= kLeastCompression && level <= kMostCompression);
  switch (level) {
    case 0:
      return {PNG_FILTER_NONE, Z_NO_COMPRESSION, Z_DEFAULT_STRATEGY};
    case 1:
      return {PNG_FILTER_AVG, Z_BEST_SPEED, Z_RLE};
    case 2:
      return {PNG_FILTER_PAETH, Z_BEST_SPEED, Z_RLE};
    case 3:
      return {PNG_ALL_FILTERS, Z_BEST_SPEED, Z_RLE};
    default:
      return {PNG_ALL_FILTERS, level, Z_FILTERED};
  }
}

/// What the IHDR chunk says of samples.
struct SampleFormat {
  int bitDepth = 8;
  int colorType = PNG_COLOR_TYPE_RGB_ALPHA;
};

void setColorChunks(png_structp png, png_infop info, const ColorChunks& color) {
  if (color.profile) {
    png_set_iCCP(png, info, color.profile->name.c_str(), PNG_COMPRESSION_TYPE_BASE,
                 color.profile->bytes.data(),
                 static_cast<png_uint_32>(color.profile->bytes.size()));
  }
  if (color.srgbIntent) png_set_sRGB(png, info, *color.srgbIntent);
  if (color.gamma) png_set_gAMA_fixed(png, info, *color.gamma);
  if (color.chromaticities) {
    const auto& xy = *color.chromaticities;
    png_set_cHRM_fixed(png, info, xy[0], xy[1], xy[2], xy[3], xy[4], xy[5], xy[6], xy[7]);
  }
}

/// @param rowBytes  gives row y as the file is to hold it.
template <typename RowBytes>
void encode(Size size, SampleFormat format, const ColorChunks& color, int compressionLevel,
            const RowBytes& rowBytes, const ByteSink& sink) {
  const Compression compression = compressionOf(compressionLevel);
  Writer writer(sink);
  auto* const png = writer.png();
  auto* const info = writer.info();
  writer.run([&] {
    png_set_filter(png, PNG_FILTER_TYPE_BASE, compression.filters);
    png_set_compression_level(png, compression.zlibLevel);
    png_set_compression_strategy(png, compression.strategy);
    png_set_IHDR(png, info, static_cast<png_uint_32>(size.width),
                 static_cast<png_uint_32>(size.height), format.bitDepth, format.colorType,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    setColorChunks(png, info, color);
    png_write_info(png, info);
    for (int y = 0; y < size.height; ++y) png_write_row(png, rowBytes(y));
    png_write_end(png, nullptr);
  });
}

// Samples as PNG has them: the high byte first.
void append(std::uint8_t sample, std::uint8_t*& bytes) { *bytes++ = sample; }
void append(std::uint16_t sample, std::uint8_t*& bytes) {
  *bytes++ = static_cast<std::uint8_t>(sample >> 8U);
  *bytes++ = static_cast<std::uint8_t>(sample & 0xFFU);
}

template <typename Pixel>
[[nodiscard]] std::vector<std::uint8_t> encoded(const Image<Pixel>& image, const FramePart& part,
                                                int compressionLevel, const PngContent& content) {
  const std::size_t pixelBytes = (content.opaque ? 3 : 4) * sizeof(Pixel::r);
  const std::vector<std::uint8_t> nothing(at(part.frame.width) * pixelBytes);
  std::vector<std::uint8_t> row = nothing;
  const auto rowBytes = [&](int y) -> png_const_bytep {
    if (y < part.box.beginY || y >= part.box.endY) return nothing.data();
    std::uint8_t* bytes = row.data() + at(part.box.beginX) * pixelBytes;
    for (int x = 0; x < image.width(); ++x) {
      const Pixel& pixel = image(x, y - part.box.beginY);
      append(pixel.r, bytes);
      append(pixel.g, bytes);
      append(pixel.b, bytes);
      if (!content.opaque) append(pixel.a, bytes);
    }
    return row.data();
  };
  constexpr int kBitsPerByte = 8;
  const SampleFormat format{kBitsPerByte * static_cast<int>(sizeof(Pixel::r)),
                            content.opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA};
  std::vector<std::uint8_t> file;
  encode(part.frame, format, content.color, compressionLevel, rowBytes,
         [&file](const void* data, std::size_t byteCount) {
           const auto* const bytes = static_cast<const std::uint8_t*>(data);
           file.insert(file.end(), bytes, bytes + byteCount);
         });
  return file;
}

}  // namespace

std::vector<std::uint8_t> encodePng(const Image<Rgba8>& image, int compressionLevel,
                                    const PngContent& content) {
  return encoded(image, FramePart::whole(image.size()), compressionLevel, content);
}

std::vector<std::uint8_t> encodePng(const Image<Rgba16>& image, int compressionLevel,
                                    const PngContent& content) {
  return encoded(image, FramePart::whole(image.size()), compressionLevel, content);
}

std::vector<std::uint8_t> encodePng(const Image<Rgba8>& image, const FramePart& part,
                                    int compressionLevel, const PngContent& content) {
  return encoded(image, part, compressionLevel, content);
}

std::vector<std::uint8_t> encodePng(const Image<Rgba16>& image, const FramePart& part,
                                    int compressionLevel, const PngContent& content) {
  return encoded(image, part, compressionLevel, content);
}

void writePng(const std::string& path, const Image<Rgba8>& image, int compressionLevel) {
  writeAtomically(path, encodePng(image, compressionLevel));
}

void writeGrayPng(const std::string& path, const Image<std::uint8_t>& image) {
  writeAtomically(path, [&](const ByteSink& sink) {
    const auto row = [&](int y) -> png_const_bytep { return image.row(y); };
    encode(image.size(), {8, PNG_COLOR_TYPE_GRAY}, {}, kDefaultCompression, row, sink);
  });
}

}  // namespace fluidymation
