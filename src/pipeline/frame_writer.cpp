#include "pipeline/frame_writer.h"

#include <cstring>

#include "fluidymation/io/atomic_file.h"

namespace fluidymation {
namespace {

template <typename Pixel>
[[nodiscard]] bool sameBytes(const Image<Pixel>& a, const Image<Pixel>& b) {
  static_assert(sizeof(Pixel) == 4 * sizeof(Pixel::r), "nothing between the channels may differ");
  if (a.size() != b.size()) return false;
  // Where nothing is painted there is nothing to point at, which memcmp must not be given.
  return a.pixelCount() == 0 ||
         std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Pixel)) == 0;
}

[[nodiscard]] bool looksAlike(const FrameWriter::Output& a, const FrameWriter::Output& b) {
  if (!(a.part == b.part)) return false;
  return std::visit(
      [&b](const auto& one) {
        const auto* const other = std::get_if<std::decay_t<decltype(one)>>(&b.pixels);
        return other != nullptr && sameBytes(one, *other);
      },
      a.pixels);
}

}  // namespace

FrameWriter::FrameWriter(FrameForm form)
    : FrameWriter(std::move(form), [this](const Output& output) {
        const PngContent content{!form_.background.empty(), form_.color};
        return std::visit(
            [&](const auto& image) {
              return encodePng(image, output.part, form_.compressionLevel, content);
            },
            output.pixels);
      }) {}

FrameWriter::FrameWriter(FrameForm form, Encoder encode)
    : form_(std::move(form)), encode_(std::move(encode)) {
  if (form_.bitDepth == BitDepth::k16) {
    bare16_ = barePixels16(form_.background);
  } else {
    bare8_ = barePixels8(form_.background);
  }
}

FrameWriter::Output FrameWriter::outputOf(const PaintedPart& painted) const {
  const bool wide = form_.bitDepth == BitDepth::k16;
  if (form_.background.empty()) {
    const FramePart part = withColorMargin(painted.part);
    if (wide) return {part, straightPixels16(painted)};
    return {part, straightPixels8(painted, colors_)};
  }
  const FramePart whole = FramePart::whole(painted.part.frame);
  if (wide) return {whole, opaquePixels16(painted, form_.background, bare16_)};
  return {whole, opaquePixels8(painted, form_.background, bare8_, colors_)};
}

Digest FrameWriter::write(const std::string& path, const FramePart& part, const Image<Lab>& picture,
                          const GuideFrame& guides,
                          const std::function<void(const Digest&)>& beforeWriting) {
  Output output = outputOf({part, picture, guides});
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
