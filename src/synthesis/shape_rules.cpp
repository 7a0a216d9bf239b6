#include "fluidymation/synthesis/shape_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fluidymation {

Image<float> modulationDistances(const GuideLevel& guides, float borderWidthPx,
                                 const ShapeRules& rules) {
  float limitPx = std::numeric_limits<float>::infinity();
  if (rules.modulation == ModulationDistance::kClamped) {
    limitPx = borderWidthPx;
  } else if (guides.edgeless()) {
    return Image<float>(guides.distance.size(), limitPx);
  }
  Image<float> distances(guides.distance.size());
  std::transform(guides.distance.begin(), guides.distance.end(), distances.begin(),
                 [limitPx](float distance) { return std::min(distance, limitPx); });
  return distances;
}

float modulationDifference(float targetPx, float sourcePx, float borderWidthPx) {
  if (std::isfinite(targetPx) && std::isfinite(sourcePx)) return std::abs(targetPx - sourcePx);
  return std::abs(std::min(targetPx, borderWidthPx) - std::min(sourcePx, borderWidthPx));
}

}  // namespace fluidymation
