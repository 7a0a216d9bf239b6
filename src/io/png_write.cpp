#include <png.h>

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
  Writer(const ByteSink& sink, const std::string& path) : path_(path), output_{sink, nullptr} {
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

  template <typename Body>
  void run(const Body& body) {
    if (libpng::attempt(png_, body)) return;
    if (output_.failure) std::rethrow_exception(output_.failure);
    throw Error(path_ + ": cannot be written (" + message_.data() + ")");
  }

 private:
  const std::string& path_;
  Output output_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  libpng::Message message_{};
};

template <typename Pixel>
void encode(const std::string& path, const Image<Pixel>& image, int colorType) {
  writeAtomically(path, [&](const ByteSink& sink) {
    Writer writer(sink, path);
    auto* const png = writer.png();
    auto* const info = writer.info();
    writer.run([&] {
      png_set_IHDR(png, info, static_cast<png_uint_32>(image.width()),
                   static_cast<png_uint_32>(image.height()), 8, colorType, PNG_INTERLACE_NONE,
                   PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
      png_write_info(png, info);
      for (int y = 0; y < image.height(); ++y) {
        png_write_row(png, reinterpret_cast<png_const_bytep>(image.row(y)));
      }
      png_write_end(png, nullptr);
    });
  });
}

}  // namespace

void writePng(const std::string& path, const Image<Rgba8>& image) {
  static_assert(sizeof(Rgba8) == 4, "rows go to libpng as they are");
  encode(path, image, PNG_COLOR_TYPE_RGB_ALPHA);
}

void writeGrayPng(const std::string& path, const Image<std::uint8_t>& image) {
  encode(path, image, PNG_COLOR_TYPE_GRAY);
}

}  // namespace fluidymation
