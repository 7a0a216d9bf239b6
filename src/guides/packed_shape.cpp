#include "fluidymation/guides/packed_shape.h"

#include "fluidymation/guides/distance_field.h"
#include "fluidymation/guides/edge_coverage.h"
#include "fluidymation/guides/input_mask.h"
#include "fluidymation/guides/motion.h"
#include "fluidymation/guides/outline_distance.h"

namespace fluidymation {

Image<float> PackedShape::edgeDistance(const Box& box) const {
  if (soft_) return outlineDistance(mask_.unpack(box), outline_, box.begin());
  return continuousDistance(signedDistance(mask_.unpack(box)));
}

void PackedShape::addTo(GuideFrame& guides) const {
  addTo(guides, {0, 0, size().width, size().height});
}

void PackedShape::addTo(GuideFrame& guides, const Box& box) const {
  guides.mask = mask_.unpack(box);
  if (!soft_) {
    guides.distance = signedDistance(guides.mask);
  } else if (hasEdge(guides.mask)) {
    const Image<float> distance = outlineDistance(guides.mask, outline_, box.begin());
    guides.distance = pixelCentreDistance(guides.mask, distance);
    guides.coverage = coverageOf(distance);
  } else {
    guides.distance = signedDistance(guides.mask);
    guides.coverage = InputMask(guides.mask).coverage;
  }
}

}  // namespace fluidymation
