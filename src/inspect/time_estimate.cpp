#include "inspect/time_estimate.h"

namespace fluidymation {

TimeEstimate estimateTime(std::int64_t insidePx, int exemplarFrames,
                          const SynthesisOptions& synthesis, int threads) {
  constexpr double kSecondsPerMicrosecond = 1e-6;
  constexpr double kSeconds = 0.80;  // of a frame, whatever the exemplar's length
  constexpr double kSecondsPerFrame = 0.0033;
  constexpr int kMeasuredFrames = 20;
  constexpr double kGainPerThread = 0.7;
  constexpr double kSlower = 2.0;
  double work = static_cast<double>(insidePx) * kSecondsPerMicrosecond *
                (kSeconds + kSecondsPerFrame * exemplarFrames) /
                (kSeconds + kSecondsPerFrame * kMeasuredFrames);
  if (synthesis.temporalCoherence == TemporalCoherence::kBidirectional) work *= kSlower;
  if (synthesis.finestLevel == FinestLevel::kSearched) work *= kSlower;
  const double gain = 1.0 + kGainPerThread * (threads - 1);
  return {work * kLeastMicroseconds / gain, work * kMostMicroseconds / gain};
}

}  // namespace fluidymation
