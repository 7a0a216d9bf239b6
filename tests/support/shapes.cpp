#include "support/shapes.h"

#include "fluidymation/core/random.h"
#include "fluidymation/guides/guide_stream.h"

namespace fluidymation::test {

Mask disc(Size size, Vec2 centre, float radius) {
  return maskOf(size, [&](int x, int y) {
    return length(Vec2{static_cast<float>(x), static_cast<float>(y)} - centre) < radius;
  });
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

std::vector<GuideFrame> guidesOf(const std::vector<Mask>& masks, float sigmaFrames,
                                 MotionModel model) {
  GuideOptions options;
  options.motionModel = model;
  options.mask.blurSigmaPx = 0.0F;
  options.timeBlurSigmaFrames = sigmaFrames;
  GuideStream stream(
      static_cast<int>(masks.size()),
      [&](int i) { return masks[static_cast<std::size_t>(i)].clone(); }, options);
  std::vector<GuideFrame> frames;
  for (int i = 0; i < stream.frameCount(); ++i) frames.push_back(stream.next());
  return frames;
}

}  // namespace fluidymation::test
