#include "fluidymation/guides/mask.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "fluidymation/core/box.h"
#include "fluidymation/guides/gaussian.h"
#include "fluidymation/guides/input_mask.h"

namespace fluidymation {
namespace {

float coverageOf(std::uint8_t inside) { return inside != 0 ? 1.0F : 0.0F; }
float coverageOf(float coverage) { return coverage; }

/// Gaussian * image within the box that it reaches, with the box; values of `image` lie in [0, 1].
/// Nothing happens further away than the kernel reaches. Where the box ends within the image its
/// last pixels are zero, so that repeating them is as good as the truth.
template <typename T>
std::pair<Box, Image<float>> blurredBox(const Image<T>& image, float sigmaPx) {
  const Box covered = boundingBox(image, [](T value) { return value != T{}; });
  const Box box = grown(covered, gaussianReach(sigmaPx), image.size());
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

}  // namespace fluidymation
