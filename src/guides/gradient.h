#pragma once

#include <algorithm>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// A distance field changes by about 1 per px. Where it is flatter than this, on the ridge of parts
/// one pixel wide or half-way between two edges, its gradient is no direction.
inline constexpr float kFlatGradient = 0.01F;

/// Difference of the two neighbours over their distance: central within the image, one-sided at its
/// edge, zero along a side of one pixel.
/// @param field  value at (x, y) of an image of `size`.
template <typename Field>
[[nodiscard]] Vec2 gradientOf(const Field& field, Size size, int x, int y) {
  const int left = std::max(x - 1, 0);
  const int right = std::min(x + 1, size.width - 1);
  const int up = std::max(y - 1, 0);
  const int down = std::min(y + 1, size.height - 1);
  return {(field(right, y) - field(left, y)) / static_cast<float>(std::max(right - left, 1)),
          (field(x, down) - field(x, up)) / static_cast<float>(std::max(down - up, 1))};
}

[[nodiscard]] inline Vec2 gradientAt(const Image<float>& field, int x, int y) {
  return gradientOf(field, field.size(), x, y);
}

}  // namespace fluidymation
