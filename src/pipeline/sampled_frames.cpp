#include "pipeline/sampled_frames.h"

#include <algorithm>
#include <cstdint>

namespace fluidymation {

std::vector<int> sampledFrames(int frameCount) {
  const int count = std::min(frameCount, kMostSampledFrames);
  std::vector<int> frames;
  for (std::int64_t i = 0; i < count; ++i) {
    frames.push_back(static_cast<int>(i * frameCount / count));
  }
  return frames;
}

}  // namespace fluidymation
