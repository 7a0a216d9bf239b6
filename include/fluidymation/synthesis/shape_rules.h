#pragma once

#include "fluidymation/core/image.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/pyramid.h"

namespace fluidymation {

/// Channel::kEdge of a pixel. The blurred mask is scaled like the edge guide: from 0 outside to
/// kEdgeScale inside.
[[nodiscard]] inline float shapeChannel(const GuideLevel& guides, int x, int y, float borderWidthPx,
                                        const ShapeRules& rules) {
  return rules.guide == ShapeGuide::kBlurredMask
             ? kEdgeScale * guides.shape(x, y)
             : edgeChannel(guides.distance(x, y), borderWidthPx);
}

/// Whether the distances of the temporal modulation are those of the edge guide.
[[nodiscard]] inline bool edgeGuideTellsDistance(const ShapeRules& rules) {
  return rules.guide == ShapeGuide::kEdgeDistance &&
         rules.modulation == ModulationDistance::kClamped;
}

/// Distances to the edge as the temporal modulation compares them, px: clamped at the border width,
/// or unclamped and then infinite where there is no edge, for a stand-in is no distance.
[[nodiscard]] Image<float> modulationDistances(const GuideLevel& guides, float borderWidthPx,
                                               const ShapeRules& rules);

/// How far two of them are apart. Where one is infinite both are clamped at the border width.
[[nodiscard]] float modulationDifference(float targetPx, float sourcePx, float borderWidthPx);

}  // namespace fluidymation
