#include "fluidymation/guides/edge_coverage.h"

#include <algorithm>
#include <cmath>

#include "fluidymation/core/parallel.h"
#include "gradient.h"

namespace fluidymation {

float edgeCoverage(float distance, Vec2 normal) {
  const float norm = length(normal);
  const float a = norm > 0.0F ? std::max(std::abs(normal.x), std::abs(normal.y)) / norm : 1.0F;
  const float b = norm > 0.0F ? std::min(std::abs(normal.x), std::abs(normal.y)) / norm : 0.0F;
  // The part of the pixel up to the line a x + b y = h, seen from its innermost corner
  const float h = distance + 0.5F * (a + b);
  if (h <= 0.0F) return 0.0F;
  if (h >= a + b) return 1.0F;
  if (h <= b) return h * h / (2.0F * a * b);
  if (h >= a) return 1.0F - (a + b - h) * (a + b - h) / (2.0F * a * b);
  return (h - 0.5F * b) / a;
}

Image<float> coverageOf(const Image<float>& distance) {
  constexpr float kFarthestPx = 0.71F;
  Image<float> coverage(distance.size());
  forEachRow(distance.height(), [&](int y) {
    for (int x = 0; x < distance.width(); ++x) {
      const float d = distance(x, y);
      if (std::abs(d) < kFarthestPx) {
        coverage(x, y) = edgeCoverage(d, gradientAt(distance, x, y));
      } else {
        coverage(x, y) = d > 0.0F ? 1.0F : 0.0F;
      }
    }
  });
  return coverage;
}

}  // namespace fluidymation
