#include "fluidymation/guides/temporal_smoothing.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

/// Adds `weight` times the continued sequence's value at `frame` to the weights of the real frames.
void addReflected(std::vector<double>& weights, int frame, double weight) {
  const int last = static_cast<int>(weights.size()) - 1;
  if (last == 0) {
    weights.front() += weight;  // one frame says nothing about speed: it stands still
  } else if (frame < 0) {
    weights.front() += 2.0 * weight;
    addReflected(weights, -frame, -weight);
  } else if (frame > last) {
    weights.back() += 2.0 * weight;
    addReflected(weights, 2 * last - frame, -weight);
  } else {
    weights[static_cast<std::size_t>(frame)] += weight;
  }
}

}  // namespace

TemporalWeights temporalWeights(int frame, int frameCount, float sigmaFrames) {
  assert(frame >= 0 && frame < frameCount);
  const std::vector<float> kernel = gaussianKernel(sigmaFrames);
  const int radius = static_cast<int>(kernel.size()) - 1;
  std::vector<double> all(static_cast<std::size_t>(frameCount));
  for (int offset = -radius; offset <= radius; ++offset) {
    addReflected(all, frame + offset,
                 static_cast<double>(kernel[static_cast<std::size_t>(std::abs(offset))]));
  }

  // Reflection never reaches back further than the kernel does
  TemporalWeights result;
  result.firstFrame = std::max(frame - radius, 0);
  for (int i = result.firstFrame; i <= std::min(frame + radius, frameCount - 1); ++i) {
    result.weights.push_back(static_cast<float>(all[static_cast<std::size_t>(i)]));
  }
  return result;
}

}  // namespace fluidymation
