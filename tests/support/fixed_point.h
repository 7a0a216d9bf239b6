#pragma once

#include <algorithm>
#include <cmath>

#include "fluidymation/synthesis/exemplar.h"

namespace fluidymation::test {

/// How far the weight of a bilinear interpolation lies from that of the exact position, at most:
/// positions are cut to steps of 2^-16 px and weights to 15 bits, together less than 2^-15; the
/// position is a sum of three floats below 8, which are rounded by 2^-22 at most each.
inline constexpr double kInterpolationSlip = 0x1p-15 + 3 * 0x1p-22;

/// How far a bilinear interpolation in fixed point lies from the exact one, steps, at most: each of
/// the two mixes is rounded to the nearest step, the first one on either side of the second, and
/// the weights slip along both axes. `range` is the largest difference between two neighbouring
/// pixels, steps.
[[nodiscard]] constexpr double interpolationError(double range) {
  return 0.5 + 0.5 + 2.0 * kInterpolationSlip * range;
}

/// How far the share of one colour in a blend lies from the exact one, at most: half of a step of
/// 2^-15 and what the largest share, 1 - 2^-15, lacks; some single-precision rounding besides.
inline constexpr double kBlendSlip = 1.5 * 0x1p-15 + 0x1p-21;

/// The same of a blend of two colours that are `range` steps apart: rounded to the nearest step.
[[nodiscard]] constexpr double blendError(double range) { return 0.5 + kBlendSlip * range; }

/// What a slow twin expects, and how far what is computed in fixed point may lie from it.
struct Expected {
  double value = 0.0;
  double tolerance = 0.0;

  /// weight * difference^2, of a difference that is known to +-`error`.
  void addSquare(double weight, double difference, double error) {
    value += weight * difference * difference;
    tolerance += weight * (2.0 * std::abs(difference) + error) * error;
  }
  void add(double share, const Expected& other) {
    value += share * other.value;
    tolerance += share * other.tolerance;
  }
};

/// One channel of the exemplar's pixel at (x, y) in the image, in its own unit.
[[nodiscard]] inline float channelAt(const ExemplarLevel& level, int x, int y, int k,
                                     Channel channel) {
  const Texel& there = level.texel(x, y, k);
  switch (channel) {
    case kLightness:
      return there.color.lab().l;
    case kGreenRed:
      return there.color.lab().a;
    case kBlueYellow:
      return there.color.lab().b;
    case kEdge:
      return static_cast<float>(there.guides.edge) / kEdgeSteps;
    case kExtForward:
      return static_cast<float>(there.guides.extForward) / level.extentSteps();
    case kExtBackward:
      return static_cast<float>(there.guides.extBackward) / level.extentSteps();
    case kDirectionX:
      return level.direction(x, y, k).x;
    case kDirectionY:
      return level.direction(x, y, k).y;
    case kChannelCount:
      break;
  }
  return 0.0F;
}

/// One channel of the exemplar between its pixels in double precision: bilinear, the edge repeats.
[[nodiscard]] inline double slowSample(const ExemplarLevel& level, int frame, double x, double y,
                                       Channel channel) {
  x = std::clamp(x, 0.0, level.size().width - 1.0);
  y = std::clamp(y, 0.0, level.size().height - 1.0);
  const int x0 = std::min(static_cast<int>(x), std::max(0, level.size().width - 2));
  const int y0 = std::min(static_cast<int>(y), std::max(0, level.size().height - 2));
  const int x1 = std::min(x0 + 1, level.size().width - 1);
  const int y1 = std::min(y0 + 1, level.size().height - 1);
  const double fx = x - x0;
  const double fy = y - y0;
  const auto at = [&](int px, int py) {
    return static_cast<double>(channelAt(level, px, py, frame, channel));
  };
  return (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x1, y0)) +
         fy * ((1 - fx) * at(x0, y1) + fx * at(x1, y1));
}

}  // namespace fluidymation::test
