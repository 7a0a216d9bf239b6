#include "fluidymation/automatic.h"

#include <algorithm>
#include <cmath>

namespace fluidymation {
namespace {

/// What a user can read and give again.
float tenths(double value) { return static_cast<float>(std::round(10.0 * value) / 10.0); }

}  // namespace

float automaticBlurSigmaPx(const std::vector<double>& areas) {
  double sum = 0.0;
  double count = 0.0;
  for (const double area : areas) {
    if (area == 0.0) continue;
    sum += area;
    count += 1.0;
  }
  if (count == 0.0) return 0.0F;
  return tenths(static_cast<double>(kBlurSigmaShare) * std::sqrt(sum / count));
}

float automaticBorderWidthPx(Size exemplar) {
  const double side = std::sqrt(static_cast<double>(exemplar.width) * exemplar.height);
  return std::max(1.0F, tenths(static_cast<double>(kBorderWidthShare) * side));
}

float boundedBorderWidthPx(std::optional<float> measuredPx, Size exemplar) {
  const float bySize = automaticBorderWidthPx(exemplar);
  if (!measuredPx) return bySize;
  return tenths(static_cast<double>(
      std::clamp(*measuredPx, kLeastMeasuredShare * bySize, kMostMeasuredShare * bySize)));
}

}  // namespace fluidymation
