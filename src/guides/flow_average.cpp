#include "fluidymation/guides/flow_average.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "fluidymation/core/parallel.h"

namespace fluidymation {

int flowAverageReach(float sigmaFrames) {
  constexpr float kReachSigmas = 2.0F;
  return static_cast<int>(std::ceil(kReachSigmas * sigmaFrames));
}

FlowAverages::FlowAverages(int frameCount, float sigmaFrames, FrameOf frameOf)
    : frameCount_(frameCount), sigmaFrames_(sigmaFrames), frameOf_(std::move(frameOf)) {
  assert(sigmaFrames > 0.0F);
}

Image<Vec2> FlowAverages::at(int frame) {
  const int reach = flowAverageReach(sigmaFrames_);
  provide(std::max(frame - reach, 0), std::min(frame + reach + 1, frameCount_));

  const Mask& mask = frames_[static_cast<std::size_t>(frame - firstFrame_)].mask;
  Image<Vec2> mean(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) == 0) continue;
      float weights = 0.0F;
      Vec2 sum;
      int number = firstFrame_;
      for (const MovingFrame& other : frames_) {
        const float t = static_cast<float>(number++ - frame) / sigmaFrames_;
        if (other.mask(x, y) == 0) continue;
        const float weight = std::exp(-0.5F * t * t);
        weights += weight;
        sum += weight * other.flow(x, y);
      }
      mean(x, y) = (1.0F / weights) * sum;
    }
  });
  return mean;
}

void FlowAverages::provide(int first, int end) {
  for (; firstFrame_ < first; ++firstFrame_) frames_.pop_front();
  while (firstFrame_ + static_cast<int>(frames_.size()) < end) {
    frames_.push_back(frameOf_(firstFrame_ + static_cast<int>(frames_.size())));
  }
}

}  // namespace fluidymation
