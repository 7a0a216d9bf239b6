#include "footage/mask_cleaning.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "fluidymation/core/index.h"
#include "fluidymation/core/parallel.h"
#include "guides/components.h"

namespace fluidymation {
namespace {

/// Clears parts of fewer than `smallest` pixels.
void removeSmallParts(Mask& mask, std::int64_t smallest) {
  if (smallest <= 1) return;
  const Components parts = findComponents(mask);
  std::vector<std::int64_t> sizes(at(parts.count), 0);
  for (const int label : parts.label) {
    if (label >= 0) ++sizes[at(label)];
  }
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    const int label = parts.label.data()[i];
    if (label >= 0 && sizes[at(label)] < smallest) mask.data()[i] = 0;
  }
}

void invert(Mask& mask) {
  for (std::uint8_t& pixel : mask) pixel = pixel == 0 ? 1 : 0;
}

[[nodiscard]] float steepness(const Image<float>& values, int x, int y) {
  constexpr float kBetweenNeighbors = 2.0F;  // px
  const float alongX = values.clamped(x + 1, y) - values.clamped(x - 1, y);
  const float alongY = values.clamped(x, y + 1) - values.clamped(x, y - 1);
  return std::sqrt(alongX * alongX + alongY * alongY) / kBetweenNeighbors;
}

}  // namespace

Mask cleanedMask(const Mask& mask, std::int64_t smallestPartPx, std::int64_t smallestHolePx) {
  Mask cleaned = mask.clone();
  removeSmallParts(cleaned, smallestPartPx);
  invert(cleaned);
  removeSmallParts(cleaned, smallestHolePx);
  invert(cleaned);
  return cleaned;
}

Image<float> softCoverage(const Image<float>& difference, float threshold, const Mask& mask) {
  assert(difference.size() == mask.size());
  constexpr float kHalf = 0.5F;
  Image<float> coverage(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      const bool inside = mask(x, y) != 0;
      const float above = difference(x, y) - threshold;
      coverage(x, y) = inside ? 1.0F : 0.0F;
      if (inside != (above >= 0.0F)) continue;  // overruled
      const float slope = steepness(difference, x, y);
      if (std::abs(above) < kHalf * slope) coverage(x, y) = kHalf + above / slope;
    }
  });
  return coverage;
}

}  // namespace fluidymation
