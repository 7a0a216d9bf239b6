#include "support/shapes.h"

#include <algorithm>
#include <cmath>

#include "fluidymation/core/random.h"
#include "fluidymation/guides/guide_stream.h"

namespace fluidymation::test {
namespace {

/// All frames of a stream of guides.
std::vector<GuideFrame> allOf(std::size_t frameCount, const MaskReader& readMask,
                              const GuideOptions& options) {
  GuideStream stream(static_cast<int>(frameCount), readMask, options);
  std::vector<GuideFrame> frames;
  for (int i = 0; i < stream.frameCount(); ++i) frames.push_back(stream.next());
  return frames;
}

}  // namespace

Mask disc(Size size, Vec2 centre, float radius) {
  return maskOf(size, [&](int x, int y) {
    return length(Vec2{static_cast<float>(x), static_cast<float>(y)} - centre) < radius;
  });
}

Image<float> softDisc(Size size, Vec2 centre, float radius) {
  constexpr int kParts = 32;  // along a pixel's side
  Image<float> coverage(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Vec2 middle{static_cast<float>(x), static_cast<float>(y)};
      const float rest = radius - length(middle - centre);
      int covered = rest > 0.0F ? kParts * kParts : 0;
      if (std::abs(rest) < 0.75F) {
        covered = 0;
        for (int i = 0; i < kParts * kParts; ++i) {
          const auto part = [](int k) { return (static_cast<float>(k) + 0.5F) / kParts - 0.5F; };
          const Vec2 there = middle + Vec2{part(i % kParts), part(i / kParts)};
          if (length(there - centre) < radius) ++covered;
        }
      }
      coverage(x, y) = static_cast<float>(covered) / (kParts * kParts);
    }
  }
  return coverage;
}

Image<float> softHalfPlane(Size size, Vec2 point, Vec2 normal) {
  // The integral over x of the row's covered length, in double: a twin of no formula in use
  constexpr int kSlices = 2000;
  Image<float> coverage(size);
  const double nx = normal.x;
  const double ny = normal.y;
  const bool steep = std::abs(nx) > std::abs(ny);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double d =
          (x - static_cast<double>(point.x)) * nx + (y - static_cast<double>(point.y)) * ny;
      if (std::abs(d) > 0.75) {
        coverage(x, y) = d > 0.0 ? 1.0F : 0.0F;
        continue;
      }
      const double along = steep ? ny : nx;
      const double across = std::abs(steep ? nx : ny);
      double sum = 0.0;
      for (int i = 0; i < kSlices; ++i) {
        const double t = (i + 0.5) / kSlices - 0.5;
        sum += std::clamp(0.5 + (d + t * along) / across, 0.0, 1.0);
      }
      coverage(x, y) = static_cast<float>(sum / kSlices);
    }
  }
  return coverage;
}

Image<float> eightBit(const Image<float>& coverage) {
  Image<float> result(coverage.size());
  std::transform(coverage.begin(), coverage.end(), result.begin(),
                 [](float c) { return std::round(255.0F * c) / 255.0F; });
  return result;
}

Mask randomMask(Size size, std::uint64_t seed, int percent) {
  return maskOf(size, [&](int x, int y) {
    RandomKey key;
    key.seed = seed;
    key.x = x;
    key.y = y;
    return Random(key).uniform(0, 99) < percent;
  });
}

Mask randomBlobs(Size size, std::uint64_t seed) {
  RandomKey key;
  key.seed = seed;
  Random random(key);
  Mask mask(size);
  for (int i = 0; i < 7; ++i) {
    const Vec2 centre{static_cast<float>(random.uniform(0, size.width - 1)),
                      static_cast<float>(random.uniform(0, size.height - 1))};
    const auto radius = static_cast<float>(random.uniform(1, 1 + size.width / 4));
    const bool hole = i % 3 == 2;
    const Mask blob = disc(size, centre, radius);
    for (std::size_t p = 0; p < mask.pixelCount(); ++p) {
      if (blob.data()[p] != 0) mask.data()[p] = hole ? 0 : 1;
    }
  }
  return mask;
}

std::vector<GuideFrame> guidesWith(const std::vector<Mask>& masks, const GuideOptions& options) {
  return allOf(
      masks.size(), [&](int i) { return masks[static_cast<std::size_t>(i)].clone(); }, options);
}

std::vector<GuideFrame> guidesOf(const std::vector<Mask>& masks, float sigmaFrames,
                                 MotionModel model) {
  GuideOptions options;
  options.motionModel = model;
  options.mask.blurSigmaPx = 0.0F;
  options.timeBlurSigmaFrames = sigmaFrames;
  return guidesWith(masks, options);
}

std::vector<GuideFrame> softGuidesOf(const std::vector<Image<float>>& coverages, float sigmaFrames,
                                     float blurSigmaPx) {
  GuideOptions options;
  options.mask.blurSigmaPx = blurSigmaPx;
  options.timeBlurSigmaFrames = sigmaFrames;
  return allOf(
      coverages.size(),
      [&](int i) { return InputMask(coverages[static_cast<std::size_t>(i)].clone(), true); },
      options);
}

}  // namespace fluidymation::test
