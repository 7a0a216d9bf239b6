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

bool isEqual(const Image<float>& a, const Image<float>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

void add(const PackedShape& shape, ShapeTally& tally) {
  ++tally.frames;
  tally.maskPixels += static_cast<std::int64_t>(shape.packedMask().count());
  tally.crossings += static_cast<std::int64_t>(shape.crossingCount());
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
  InputMask last;
  for (int i = 0; i < frameCount; ++i) {
    InputMask input = readMask(i);
    isSoft = isSoft || input.soft;
    if (isSoft) hard.clear();
    if (i > 0 && isEqual(input.coverage, last.coverage)) {  // a hold
      if (!isSoft) hard.push_back(hard.back());
      soft.push_back(soft.back());
    } else {
      OutlinedMask shape = outlinedMask(input.coverage, options);
      assert(soft.empty() || shape.mask.size() == soft.front().size());
      if (!isSoft) {
        // The same mask, unless it was scaled or is smoothed by next to nothing
        const bool smoothsAlike =
            options.blurSigmaPx == 0.0F || options.blurSigmaPx >= kLeastCoverageSigmaPx;
        const bool same = smoothsAlike && !hasPartlyCoveredPixels(input.coverage);
        hard.emplace_back(same ? shape.mask.clone() : smoothMask(input.cut(), options));
      }
      soft.emplace_back(std::move(shape));
    }
    last = std::move(input);
    if (!isSoft) add(hard.back(), hardTally);
    add(soft.back(), softTally);
    if (watch) watch(isSoft ? softTally : hardTally);
  }
  return isSoft ? std::move(soft) : std::move(hard);
}

}  // namespace fluidymation
