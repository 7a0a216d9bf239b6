#include "pipeline/frame_writer.h"

#include <cstring>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/io/atomic_file.h"

namespace fluidymation {
namespace {

bool looksAlike(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  static_assert(sizeof(Rgba8) == 4, "nothing between the channels that could differ");
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Rgba8)) == 0;
}

}  // namespace

Image<Rgba8> toOutput(const Image<Lab>& picture, const GuideFrame& guides,
                      const SrgbByteEncoder& encoder) {
  Image<Rgba8> output(picture.size());
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      const std::uint8_t alpha = toByte(guides.coverageAt(x, y));
      if (alpha == 0) continue;
      const Rgb8 color = encoder(picture(x, y));
      output(x, y) = {color.r, color.g, color.b, alpha};
    }
  });
  return output;
}

Digest FrameWriter::write(const std::string& path, const Image<Lab>& picture,
                          const GuideFrame& guides) {
  Image<Rgba8> output = toOutput(picture, guides, colors_);
  if (lastFile_.empty() || !looksAlike(output, last_)) {
    lastFile_ = encode_(output);
    last_ = std::move(output);
  }
  writeAtomically(path, lastFile_);
  return digestOf(lastFile_.data(), lastFile_.size());
}

}  // namespace fluidymation
