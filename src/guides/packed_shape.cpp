#include "fluidymation/guides/packed_shape.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

#include "fluidymation/guides/distance_field.h"
#include "fluidymation/guides/edge_coverage.h"
#include "fluidymation/guides/motion.h"
#include "fluidymation/guides/outline_distance.h"

namespace fluidymation {
namespace {

bool hasPartlyCoveredPixels(const Image<float>& coverage) {
  return std::any_of(coverage.begin(), coverage.end(),
                     [](float c) { return c != 0.0F && c != 1.0F; });
}

}  // namespace

Image<float> PackedShape::edgeDistance(const Box& box) const {
  if (soft_) return cropped(outlineDistance(mask(), outline_), box);
  return continuousDistance(signedDistance(mask_.unpack(box)));
}

void PackedShape::addTo(GuideFrame& guides) const {
  guides.mask = mask();
  if (!soft_) {
    guides.distance = signedDistance(guides.mask);
  } else if (hasEdge(guides.mask)) {
    const Image<float> distance = outlineDistance(guides.mask, outline_);
    guides.distance = pixelCentreDistance(guides.mask, distance);
    guides.coverage = coverageOf(distance);
  } else {
    guides.distance = signedDistance(guides.mask);
    guides.coverage = InputMask(guides.mask).coverage;
  }
}

std::vector<PackedShape> readShapes(int frameCount, const MaskReader& readMask,
                                    const MaskOptions& options, const ShapeWatch& watch) {
  // Whether the sequence is soft shows at its first soft mask. Until then both ways are gone.
  std::vector<PackedShape> hard;
  std::vector<PackedShape> soft;
  ShapeTally hardTally;
  ShapeTally softTally;
  bool isSoft = false;
  for (int i = 0; i < frameCount; ++i) {
    const InputMask input = readMask(i);
    OutlinedMask shape = outlinedMask(input.coverage, options);
    assert(soft.empty() || shape.mask.size() == soft.front().size());
    softTally.maskPixels += static_cast<std::int64_t>(countInside(shape.mask));
    softTally.crossings += static_cast<std::int64_t>(shape.outline.crossingCount());
    isSoft = isSoft || input.soft;
    if (isSoft) {
      hard.clear();
    } else {
      // The same mask, unless it was scaled or is smoothed by next to nothing
      const bool smoothsAlike =
          options.blurSigmaPx == 0.0F || options.blurSigmaPx >= kLeastCoverageSigmaPx;
      const bool same = smoothsAlike && !hasPartlyCoveredPixels(input.coverage);
      const Mask mask = same ? shape.mask.clone() : smoothMask(input.cut(), options);
      hardTally.maskPixels += static_cast<std::int64_t>(countInside(mask));
      hard.emplace_back(mask);
    }
    soft.emplace_back(std::move(shape));
    hardTally.frames = softTally.frames = i + 1;
    if (watch) watch(isSoft ? softTally : hardTally);
  }
  return isSoft ? std::move(soft) : std::move(hard);
}

}  // namespace fluidymation
