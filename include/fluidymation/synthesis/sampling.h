#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fluidymation/core/geometry.h"
#include "fluidymation/synthesis/lanes.h"

namespace fluidymation {

/// Bilinear interpolation between the four pixels round a point. `top` and `bottom` point at the
/// left one of each pair, `right` is the distance to the right one (0 at the image edge).
[[nodiscard]] inline Lanes interpolate(const Lanes* top, const Lanes* bottom, std::ptrdiff_t right,
                                       float fx, float fy) {
  const float w11 = fx * fy;
  const float w10 = fx - w11;  // right, top
  const float w01 = fy - w11;  // left, bottom
  const float w00 = 1.0F - fx - w01;
  return {
      top[0].low * w00 + top[right].low * w10 + bottom[0].low * w01 + bottom[right].low * w11,
      top[0].high * w00 + top[right].high * w10 + bottom[0].high * w01 + bottom[right].high * w11};
}

/// Value of one exemplar frame (`size`, row-major) at a real position, clamped to the image.
[[nodiscard]] inline Lanes sampleClamped(const Lanes* frame, Size size, float x, float y) {
  const float cx = std::clamp(x, 0.0F, static_cast<float>(size.width - 1));
  const float cy = std::clamp(y, 0.0F, static_cast<float>(size.height - 1));
  const int x0 = static_cast<int>(cx);
  const int y0 = static_cast<int>(cy);
  const std::ptrdiff_t right = x0 + 1 < size.width ? 1 : 0;
  const std::ptrdiff_t down = y0 + 1 < size.height ? size.width : 0;
  const Lanes* top = frame + static_cast<std::ptrdiff_t>(y0) * size.width + x0;
  return interpolate(top, top + down, right, cx - static_cast<float>(x0),
                     cy - static_cast<float>(y0));
}

/// The same for a position known to have all four neighbours in the image.
[[nodiscard]] inline Lanes sampleInside(const Lanes* frame, int width, float x, float y) {
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const Lanes* top = frame + static_cast<std::ptrdiff_t>(y0) * width + x0;
  return interpolate(top, top + width, 1, x - static_cast<float>(x0), y - static_cast<float>(y0));
}

}  // namespace fluidymation
