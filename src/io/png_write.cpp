#include <png.h>
#include <zlib.h>

#include <cassert>
#include <exception>
#include <new>

#include "fluidymation/core/error.h"
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

template <typename Pixel>
void encode(const Image<Pixel>& image, int colorType, int compressionLevel, const ByteSink& sink) {
  const Compression compression = compressionOf(compressionLevel);
  Writer writer(sink);
  auto* const png = writer.png();
  auto* const info = writer.info();
  writer.run([&] {
    png_set_filter(png, PNG_FILTER_TYPE_BASE, compression.filters);
    png_set_compression_level(png, compression.zlibLevel);
    png_set_compression_strategy(png, compression.strategy);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width()),
                 static_cast<png_uint_32>(image.height()), 8, colorType, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < image.height(); ++y) {
      png_write_row(png, reinterpret_cast<png_const_bytep>(image.row(y)));
    }
    png_write_end(png, nullptr);
  });
}

}  // namespace

std::vector<std::uint8_t> encodePng(const Image<Rgba8>& image, int compressionLevel) {
  static_assert(sizeof(Rgba8) == 4, "rows go to libpng as they are");
  std::vector<std::uint8_t> file;
  encode(image, PNG_COLOR_TYPE_RGB_ALPHA, compressionLevel,
         [&file](const void* data, std::size_t byteCount) {
           const auto* const bytes = static_cast<const std::uint8_t*>(data);
           file.insert(file.end(), bytes, bytes + byteCount);
         });
  return file;
}

void writePng(const std::string& path, const Image<Rgba8>& image, int compressionLevel) {
  writeAtomically(path, encodePng(image, compressionLevel));
}

void writeGrayPng(const std::string& path, const Image<std::uint8_t>& image) {
  writeAtomically(path, [&](const ByteSink& sink) {
    encode(image, PNG_COLOR_TYPE_GRAY, kDefaultCompression, sink);
  });
}

}  // namespace fluidymation
