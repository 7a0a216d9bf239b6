#include "fluidymation/synthesis/target_level.h"

#include <algorithm>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/shape_rules.h"

namespace fluidymation {

TargetLevel::TargetLevel(const GuideLevel& guides, float borderWidthPx,
                         const ExtentScale& extentScale, const ShapeRules& rules)
    : segment(guides.mask.size(), Segment::kOutside),
      edge(guides.mask.size()),
      extForward(guides.mask.size()),
      extBackward(guides.mask.size()),
      direction(guides.direction.clone()),
      modulationDistancePx(modulationDistances(guides, borderWidthPx, rules)),
      picture(guides.mask.size()),
      previous(guides.mask.size()),
      hasPrevious(guides.mask.size()),
      modulation(guides.mask.size()) {
  forEachRow(segment.height(), [&](int y) {
    for (int x = 0; x < segment.width(); ++x) {
      segment(x, y) = guides.segment(x, y, borderWidthPx);
      edge(x, y) = shapeChannel(guides, x, y, borderWidthPx, rules);
      extForward(x, y) = extentScale(guides.extForward(x, y));
      extBackward(x, y) = extentScale(guides.extBackward(x, y));
    }
  });
  borderCount =
      static_cast<std::size_t>(std::count(segment.begin(), segment.end(), Segment::kBorder));
  interiorCount =
      static_cast<std::size_t>(std::count(segment.begin(), segment.end(), Segment::kInterior));
}

}  // namespace fluidymation
