#include "fluidymation/guides/drawn_lines.h"

#include "fluidymation/core/geometry.h"
#include "fluidymation/guides/mask.h"

namespace fluidymation {

void DrawnLines::add(const Mask& mask, const Image<Vec2>& flow) {
  const Image<float> ages = ages_.next(mask);
  area_ = countInside(mask);
  if (!mask_.empty()) {
    for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
      const bool before = mask_.data()[i] != 0;
      const bool now = mask.data()[i] != 0;
      if (before && !now) ++uncovered_;
      if (!now) continue;
      const auto speedPx = static_cast<double>(length(flow.data()[i]));
      if (!before) {
        ++covered_;
        fresh_.sumPx += speedPx;
        ++fresh_.pixels;
      } else if (ages_.haveGrown() && ages.data()[i] >= kSettledAgeFrames) {
        settled_.sumPx += speedPx;
        ++settled_.pixels;
      }
    }
  }
  mask_ = mask.clone();
}

bool DrawnLines::found() const {
  if (covered_ == 0 || settled_.pixels == 0) return false;
  const auto covered = static_cast<double>(covered_);
  return static_cast<double>(uncovered_) <= kLargestRecession * covered &&
         covered > kSmallestGrowth * static_cast<double>(area_) && fresh_.sumPx > 0.0 &&
         settled_.meanPx() <= kLargestRestlessness * fresh_.meanPx();
}

}  // namespace fluidymation
