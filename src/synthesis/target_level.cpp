#include "fluidymation/synthesis/target_level.h"

#include <algorithm>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/channels.h"

namespace fluidymation {

TargetLevel::TargetLevel(const GuideLevel& guides, float borderWidthPx,
                         const ExtentScale& extentScale)
    : segment(guides.mask.size(), Segment::kOutside),
      edge(guides.mask.size()),
      extForward(guides.mask.size()),
      extBackward(guides.mask.size()),
      direction(guides.direction.clone()),
      clampedDistancePx(guides.mask.size()),
      picture(guides.mask.size()),
      previous(guides.mask.size()),
      hasPrevious(guides.mask.size()),
      modulation(guides.mask.size()) {
  forEachRow(segment.height(), [&](int y) {
    for (int x = 0; x < segment.width(); ++x) {
      const float distance = guides.distance(x, y);
      segment(x, y) = guides.segment(x, y, borderWidthPx);
      edge(x, y) = edgeChannel(distance, borderWidthPx);
      extForward(x, y) = extentScale(guides.extForward(x, y));
      extBackward(x, y) = extentScale(guides.extBackward(x, y));
      clampedDistancePx(x, y) = std::min(distance, borderWidthPx);
    }
  });
  borderCount =
      static_cast<std::size_t>(std::count(segment.begin(), segment.end(), Segment::kBorder));
  interiorCount =
      static_cast<std::size_t>(std::count(segment.begin(), segment.end(), Segment::kInterior));
}

}  // namespace fluidymation
