#include "fluidymation/guides/drawn_lines.h"

#include "fluidymation/core/geometry.h"
#include "fluidymation/guides/mask.h"

namespace fluidymation {

void Growth::add(const PackedMask& mask) {
  if (!first_) {
    const std::size_t stays = mask.countShared(mask_);
    covered_ += mask.count() - stays;
    uncovered_ += mask_.count() - stays;
  }
  first_ = false;
  mask_ = mask;
}

bool Growth::isDrawing() const {
  if (covered_ == 0) return false;
  const auto covered = static_cast<double>(covered_);
  return static_cast<double>(uncovered_) <= kLargestRecession * covered &&
         covered > kSmallestGrowth * static_cast<double>(mask_.count());
}

void DrawnLines::add(const Mask& mask, const Image<Vec2>& flow) {
  const Image<float> ages = ages_.next(mask);
  if (!mask_.empty()) {
    for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
      const bool before = mask_.data()[i] != 0;
      const bool now = mask.data()[i] != 0;
      if (!now) continue;
      const auto speedPx = static_cast<double>(length(flow.data()[i]));
      if (!before) {
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
  return settled_.pixels != 0 && fresh_.sumPx > 0.0 &&
         settled_.meanPx() <= kLargestRestlessness * fresh_.meanPx();
}

}  // namespace fluidymation
