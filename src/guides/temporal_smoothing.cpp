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

TemporalWeights stepWeights(int frame, int frameCount, float sigmaFrames) {
  assert(frame >= 1);
  const TemporalWeights before = temporalWeights(frame - 1, frameCount, sigmaFrames);
  const TemporalWeights after = temporalWeights(frame, frameCount, sigmaFrames);
  const int end = after.firstFrame + static_cast<int>(after.weights.size());
  const auto weightIn = [](const TemporalWeights& window, int i) {
    const int place = i - window.firstFrame;
    const bool within = place >= 0 && place < static_cast<int>(window.weights.size());
    return within ? static_cast<double>(window.weights[static_cast<std::size_t>(place)]) : 0.0;
  };

  // Summation by parts: a step counts for all values from its end on
  TemporalWeights steps;
  steps.firstFrame = before.firstFrame;
  steps.weights.resize(static_cast<std::size_t>(end - 1 - before.firstFrame));
  double weight = 0.0;
  for (int i = end - 1; i > before.firstFrame; --i) {
    weight += weightIn(after, i) - weightIn(before, i);
    steps.weights[static_cast<std::size_t>(i - 1 - before.firstFrame)] = static_cast<float>(weight);
  }
  return steps;
}

}  // namespace fluidymation
