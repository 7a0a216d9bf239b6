#include "support/synthetic_film.h"

#include <algorithm>
#include <cmath>

#include "fluidymation/core/random.h"

namespace fluidymation::test {
namespace {

[[nodiscard]] float randomShare(const RandomKey& key) {
  Random random(key);
  return static_cast<float>(random.uniform(0, 1'000'000)) / 1e6F;
}

/// Random values on a grid of `kGridPx`, with a cosine between them: in [0, 1].
[[nodiscard]] float structureAt(Vec2 place) {
  constexpr float kGridPx = 5.0F;
  const float gridX = place.x / kGridPx;
  const float gridY = place.y / kGridPx;
  const int x = floorToInt(gridX);
  const int y = floorToInt(gridY);
  const auto eased = [](float t) { return 0.5F - 0.5F * std::cos(0.5F * kTwoPi * t); };
  const float shareX = eased(gridX - static_cast<float>(x));
  const float shareY = eased(gridY - static_cast<float>(y));
  const auto value = [](int i, int j) { return randomShare({7, 0, 0, 0, i, j}); };
  const float above = (1.0F - shareX) * value(x, y) + shareX * value(x + 1, y);
  const float below = (1.0F - shareX) * value(x, y + 1) + shareX * value(x + 1, y + 1);
  return (1.0F - shareY) * above + shareY * below;
}

/// Nearly Gaussian: the sum of twelve uniform numbers.
[[nodiscard]] float noise(std::uint64_t seed, int x, int y, int channel) {
  Random random({seed, 0, 0, channel, x, y});
  float sum = -6.0F;
  for (int i = 0; i < 12; ++i) sum += static_cast<float>(random.uniform(0, 1'000'000)) / 1e6F;
  return sum;
}

}  // namespace

Image<Rgb> filmed(const Shot& shot) {
  constexpr float kPaper = 0.8F;
  constexpr float kPaperStructure = 0.12F;
  Image<Rgb> frame(shot.size);
  for (int y = 0; y < shot.size.height; ++y) {
    for (int x = 0; x < shot.size.width; ++x) {
      const Vec2 onPaper = Vec2{static_cast<float>(x), static_cast<float>(y)} - shot.cameraPx;
      const float paper = shot.light * (kPaper + kPaperStructure * structureAt(onPaper));
      const bool painted = length(onPaper - shot.centre) < shot.radiusPx;
      const Rgb left = painted ? shot.paint : Rgb{1.0F, 1.0F, 1.0F};
      const auto seen = [&](float factor, int channel) {
        return std::clamp(paper * factor + shot.grain * noise(shot.grainSeed, x, y, channel), 0.0F,
                          1.0F);
      };
      frame(x, y) = {seen(left.r, 0), seen(left.g, 1), seen(left.b, 2)};
    }
  }
  return frame;
}

}  // namespace fluidymation::test
