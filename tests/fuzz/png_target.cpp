// Any file as a PNG file, by all functions that read one.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"
#include "fuzz_target.h"

namespace fluidymation::fuzz {
namespace {

/// Larger pictures are sound as well, but take so long that little else would be tried.
constexpr std::int64_t kMostPixels = 1 << 18;

[[nodiscard]] bool isShare(float value) { return value >= 0.0F && value <= 1.0F; }

/// Calls `read`; its complaints must name the file.
template <typename Read>
void attempt(const std::string& path, const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    requireNaming(error.what(), path);
  }
}

/// What may be carried along is what comes back from the file that it is written to.
void requireCopies(const ColorChunks& chunks) {
  const std::vector<std::uint8_t> file =
      encodePng(Image<Rgba8>({1, 1}), kDefaultCompression, {true, chunks});
  const MemoryFile copy(file.data(), file.size());
  require(readColorChunks(copy.path()).chunks == chunks, "colour chunks are copied as they are");
}

void readAll(const std::string& path) {
  const Size size = readPngSize(path);
  require(size.width >= 1 && size.height >= 1 && size.width <= kMaxImageSidePx &&
              size.height <= kMaxImageSidePx &&
              std::int64_t{size.width} * size.height <= kMaxImagePixels,
          "a size lies within the limits");
  if (std::int64_t{size.width} * size.height > kMostPixels) return;
  attempt(path, [&] { requireCopies(readColorChunks(path).chunks); });
  attempt(path, [&] {
    const Image<Rgba> image = readPng(path, size);
    require(image.size() == size, "a picture has the size its header claims");
    require(std::all_of(image.begin(), image.end(),
                        [](const Rgba& p) {
                          return isShare(p.r) && isShare(p.g) && isShare(p.b) && isShare(p.a);
                        }),
            "samples lie in [0, 1]");
    const bool transparent =
        std::any_of(image.begin(), image.end(), [](const Rgba& p) { return p.a < 1.0F; });
    require(hasTransparency(path, size) == transparent, "transparency is what the pixels say");
  });
  attempt(path, [&] { (void)hasTransparency(path, size); });
  attempt(path, [&] {
    require(readRgb16Size(path) == size, "a file has one size");
    require(readRgb16(path, size).size() == size, "data has the size its header claims");
  });
}

}  // namespace
}  // namespace fluidymation::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount) {
  using namespace fluidymation;
  const fuzz::MemoryFile file(data, byteCount);
  fuzz::attempt(file.path(), [&] { fuzz::readAll(file.path()); });
  return 0;
}
