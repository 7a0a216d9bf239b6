#include "fluidymation/synthesis/target_level.h"

#include <algorithm>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/shape_rules.h"

namespace fluidymation {

TargetLevel::TargetLevel(const GuideLevel& given, float borderWidthPx,
                         const ExtentScale& extentScale, const ShapeRules& rules)
    : segment(given.mask.size(), Segment::kOutside),
      guides(given.mask.size()),
      direction(given.direction.clone()),
      modulationDistancePx(modulationDistances(given, borderWidthPx, rules)),
      speed(given.mask.size()),
      picture(given.mask.size()),
      previous(given.mask.size()),
      modulation(given.mask.size()) {
  const float extentSteps = extentScale.stepsPerUnit();
  forEachRow(segment.height(), [&](int y) {
    for (int x = 0; x < segment.width(); ++x) {
      segment(x, y) = given.segment(x, y, borderWidthPx);
      speed(x, y) = length(given.flow(x, y));
      guides(x, y) = {toFixed(shapeChannel(given, x, y, borderWidthPx, rules), kEdgeSteps), 0,
                      toFixed(extentScale(given.extForward(x, y)), extentSteps),
                      toFixed(extentScale(given.extBackward(x, y)), extentSteps)};
    }
  });
  borderCount =
      static_cast<std::size_t>(std::count(segment.begin(), segment.end(), Segment::kBorder));
  interiorCount =
      static_cast<std::size_t>(std::count(segment.begin(), segment.end(), Segment::kInterior));
}

}  // namespace fluidymation
