#include "pipeline/frame_writer.h"

#include <cstring>

#include "fluidymation/io/atomic_file.h"
#include "pipeline/painted_pixels.h"

namespace fluidymation {
namespace {

template <typename Pixel>
[[nodiscard]] bool sameBytes(const Image<Pixel>& a, const Image<Pixel>& b) {
  static_assert(sizeof(Pixel) == 4 * sizeof(Pixel::r), "nothing between the channels may differ");
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Pixel)) == 0;
}

[[nodiscard]] bool looksAlike(const FrameWriter::Pixels& a, const FrameWriter::Pixels& b) {
  return std::visit(
      [&b](const auto& one) {
        const auto* const other = std::get_if<std::decay_t<decltype(one)>>(&b);
        return other != nullptr && sameBytes(one, *other);
      },
      a);
}

}  // namespace

FrameWriter::FrameWriter(FrameForm form) : form_(std::move(form)) {
  encode_ = [this](const Pixels& pixels) {
    const PngContent content{!form_.background.empty(), form_.color};
    return std::visit(
        [&](const auto& image) { return encodePng(image, form_.compressionLevel, content); },
        pixels);
  };
}

FrameWriter::Pixels FrameWriter::pixelsOf(const Image<Lab>& picture,
                                          const GuideFrame& guides) const {
  const bool wide = form_.bitDepth == BitDepth::k16;
  if (form_.background.empty()) {
    if (wide) return straightPixels16(picture, guides);
    return straightPixels8(picture, guides, colors_);
  }
  if (wide) return opaquePixels16(picture, guides, form_.background);
  return opaquePixels8(picture, guides, form_.background, colors_);
}

Digest FrameWriter::write(const std::string& path, const Image<Lab>& picture,
                          const GuideFrame& guides,
                          const std::function<void(const Digest&)>& beforeWriting) {
  Pixels output = pixelsOf(picture, guides);
  if (lastFile_.empty() || !looksAlike(output, last_)) {
    lastFile_ = encode_(output);
    last_ = std::move(output);
  }
  const Digest digest = digestOf(lastFile_.data(), lastFile_.size());
  if (beforeWriting) beforeWriting(digest);
  writeAtomically(path, lastFile_);
  return digest;
}

}  // namespace fluidymation
