#include "support/border_speed.h"

#include "fluidymation/guides/motion.h"
#include "support/shapes.h"

namespace fluidymation::test {

void BorderSpeedMean::add(const GuideFrame& frame, Vec2 centre) {
  const Mask border = borderPixels(frame.mask);
  for (int y = 0; y < border.height(); ++y) {
    for (int x = 0; x < border.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 arm = place(x, y) - centre;
      const Vec2 outward = (1.0F / length(arm)) * arm;
      const float along = dot(frame.flow(x, y), outward);
      outward_ += along;
      sideways_ += length(frame.flow(x, y) - along * outward);
      count_ += 1.0F;
    }
  }
}

BorderSpeed borderSpeed(const GuideFrame& frame, Vec2 centre) {
  BorderSpeedMean mean;
  mean.add(frame, centre);
  return mean.value();
}

}  // namespace fluidymation::test
