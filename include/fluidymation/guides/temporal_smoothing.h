#pragma once

#include <vector>

namespace fluidymation {

/// Frames of a sequence that enter one frame's temporal average, and how much.
struct TemporalWeights {
  int firstFrame = 0;
  std::vector<float> weights;  ///< of firstFrame, firstFrame + 1, ...; sum 1, may be negative
};

/// Gaussian over frames (thesis §4.1), cut at 3 sigma. Past an end of the sequence the values are
/// continued by point reflection, v(end + a) = 2 v(end) - v(end - a), again and again where the
/// sequence is shorter than the kernel: what changes evenly then keeps its speed up to the end.
/// Repeating the last frame instead would leave 0.59 of the speed there.
/// @param frame  0-based number within a sequence of `frameCount` frames.
/// @param sigmaFrames  0 gives the frame itself.
[[nodiscard]] TemporalWeights temporalWeights(int frame, int frameCount, float sigmaFrames);

/// How the step from `frame` - 1 to `frame` of the smoothed sequence is made of steps of the
/// sequence itself: smooth(frame) - smooth(frame - 1) = sum of weights[s] * (v(firstFrame + s + 1)
/// - v(firstFrame + s)). The weights sum to 1. `frame` >= 1.
[[nodiscard]] TemporalWeights stepWeights(int frame, int frameCount, float sigmaFrames);

}  // namespace fluidymation
