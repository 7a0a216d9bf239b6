#pragma once

#include "fluidymation/guides/guide_frame.h"

namespace fluidymation::test {

/// How fast the border of a disc moves.
struct BorderSpeed {
  float outward = 0.0F;   ///< mean component away from the centre
  float sideways = 0.0F;  ///< mean length of the rest
};

/// The mean over all border pixels of one or more frames.
class BorderSpeedMean {
 public:
  void add(const GuideFrame& frame, Vec2 centre);
  [[nodiscard]] BorderSpeed value() const { return {outward_ / count_, sideways_ / count_}; }

 private:
  float outward_ = 0.0F;
  float sideways_ = 0.0F;
  float count_ = 0.0F;
};

/// The mean over one frame.
[[nodiscard]] BorderSpeed borderSpeed(const GuideFrame& frame, Vec2 centre);

}  // namespace fluidymation::test
