#include "fluidymation/guides/mask.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "fluidymation/guides/gaussian.h"
#include "fluidymation/guides/input_mask.h"

namespace fluidymation {
namespace {

/// Half-open rectangle of pixels; empty where end <= begin.
struct Box {
  int beginX = 0;
  int beginY = 0;
  int endX = 0;
  int endY = 0;
};

/// The smallest box that holds the mask, grown by `margin` pixels as far as the image reaches.
template <typename T>
Box boundingBox(const Image<T>& mask, int margin) {
  Box box{mask.width(), mask.height(), 0, 0};
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) == T{}) continue;
      box.beginX = std::min(box.beginX, x);
      box.beginY = std::min(box.beginY, y);
      box.endX = std::max(box.endX, x + 1);
      box.endY = std::max(box.endY, y + 1);
    }
  }
  if (box.endX == 0) return {};
  return {std::max(box.beginX - margin, 0), std::max(box.beginY - margin, 0),
          std::min(box.endX + margin, mask.width()), std::min(box.endY + margin, mask.height())};
}

float coverageOf(std::uint8_t inside) { return inside != 0 ? 1.0F : 0.0F; }
float coverageOf(float coverage) { return coverage; }

/// Gaussian * image within the box that it reaches, with the box; values of `image` lie in [0, 1].
/// Nothing happens further away than the kernel reaches. Where the box ends within the image its
/// last pixels are zero, so that repeating them is as good as the truth.
template <typename T>
std::pair<Box, Image<float>> blurredBox(const Image<T>& image, float sigmaPx) {
  const Box box = boundingBox(image, gaussianReach(sigmaPx));
  Image<float> within(Size{box.endX - box.beginX, box.endY - box.beginY});
  for (int y = 0; y < within.height(); ++y) {
    for (int x = 0; x < within.width(); ++x) {
      within(x, y) = coverageOf(image(box.beginX + x, box.beginY + y));
    }
  }
  return {box, gaussianBlur(within, sigmaPx)};
}

}  // namespace

Mask smoothMask(const Mask& mask, const MaskOptions& options) {
  if (gaussianReach(options.blurSigmaPx) == 0) return mask.clone();
  const auto [box, coverage] = blurredBox(mask, options.blurSigmaPx);
  Mask smooth(mask.size());
  for (int y = 0; y < coverage.height(); ++y) {
    for (int x = 0; x < coverage.width(); ++x) {
      smooth(box.beginX + x, box.beginY + y) = coverage(x, y) >= options.threshold ? 1 : 0;
    }
  }
  return smooth;
}

Image<float> smoothCoverage(const Image<float>& coverage, float sigmaPx) {
  if (gaussianReach(sigmaPx) == 0) return coverage.clone();
  const auto [box, blurred] = blurredBox(coverage, sigmaPx);
  Image<float> smooth(coverage.size());
  for (int y = 0; y < blurred.height(); ++y) {
    std::copy_n(blurred.row(y), blurred.width(), smooth.row(box.beginY + y) + box.beginX);
  }
  return smooth;
}

Image<float> blurredMask(const Mask& mask, float radiusPx) {
  constexpr float kReachSigmas = 3.0F;
  return gaussianBlur(InputMask(mask).coverage, radiusPx / kReachSigmas);
}

bool hasEdge(const Mask& mask) {
  const std::size_t inside = countInside(mask);
  return inside != 0 && inside != mask.pixelCount();
}

PackedMask::PackedMask(const Mask& mask)
    : size_(mask.size()), bits_((mask.pixelCount() + 63) / 64) {
  const std::uint8_t* pixels = mask.data();
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    if (pixels[i] != 0) bits_[i / 64] |= std::uint64_t{1} << (i % 64);
  }
}

Mask PackedMask::unpack() const {
  Mask mask(size_);
  std::uint8_t* pixels = mask.data();
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    pixels[i] = static_cast<std::uint8_t>((bits_[i / 64] >> (i % 64)) & 1U);
  }
  return mask;
}

}  // namespace fluidymation
