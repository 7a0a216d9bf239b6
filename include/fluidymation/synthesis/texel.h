#pragma once

#include <algorithm>
#include <cstdint>

#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"

namespace fluidymation {

/// Steps of fixed-point values per unit of their channel. A just visible colour error is 1 to 3; a
/// step of 1/128 lies far below what the search or a byte of the output can tell. Values and their
/// differences have to fit 16 bits, so that they stay within +-kLargestFixed.
inline constexpr float kColorSteps = 128.0F;  ///< CIELAB in sRGB lies within +-108
inline constexpr float kEdgeSteps = 128.0F;   ///< beyond 12.8 border widths edges are alike
inline constexpr int kLargestFixed = 16383;

/// `value` in steps of 1 / `steps`, to the nearest, within +-kLargestFixed. Not a number counts as
/// the smallest.
[[nodiscard]] inline std::int16_t toFixed(float value, float steps) {
  constexpr auto kLargest = static_cast<float>(kLargestFixed);
  const float scaled = std::min(std::max(-kLargest, value * steps), kLargest);
  return static_cast<std::int16_t>(floorToInt(scaled + 0.5F));
}

/// A CIELAB colour in fixed point, with a count: colours are summed with `weight` going along, and
/// the mean is the sum over it. 1 for a colour, 0 for none.
struct alignas(8) FixedLab {
  std::int16_t l = 0;
  std::int16_t a = 0;
  std::int16_t b = 0;
  std::int16_t weight = 0;

  [[nodiscard]] static FixedLab of(Lab lab) {
    return {toFixed(lab.l, kColorSteps), toFixed(lab.a, kColorSteps), toFixed(lab.b, kColorSteps),
            1};
  }
  [[nodiscard]] Lab lab() const {
    constexpr float kUnit = 1.0F / kColorSteps;
    return {kUnit * static_cast<float>(l), kUnit * static_cast<float>(a),
            kUnit * static_cast<float>(b)};
  }
  [[nodiscard]] bool exists() const { return weight != 0; }
};

/// The guides that a patch comparison reads, in fixed point. The second lane is always 0: squares
/// are added in pairs of lanes, and the pairs have different weights.
struct alignas(8) FixedGuides {
  std::int16_t edge = 0;  ///< Channel::kEdge in kEdgeSteps
  std::int16_t unused = 0;
  std::int16_t extForward = 0;   ///< Channel::kExtForward in ExtentScale::stepsPerUnit
  std::int16_t extBackward = 0;  ///< likewise
};

/// Everything a patch comparison reads of one pixel, side by side: 16 bytes, one vector.
struct alignas(16) Texel {
  FixedLab color;
  FixedGuides guides;
};
static_assert(sizeof(Texel) == 16);

}  // namespace fluidymation
