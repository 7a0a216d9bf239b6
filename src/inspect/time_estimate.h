#pragma once

#include <cstdint>

#include "fluidymation/options.h"

namespace fluidymation {

/// How long a run may take, by the clock, s.
struct TimeEstimate {
  double leastSeconds = 0.0;
  double mostSeconds = 0.0;
};

/// Processor time of a frame of the standard look, microseconds a pixel inside its smoothed mask,
/// from the fastest to the slowest that docs/performance.md measured with a film of 20 frames on a
/// quiet and on a busy machine (4.9 to 6.1), and a third more on either side for other shapes and
/// processors.
inline constexpr double kLeastMicroseconds = 3.7;
inline constexpr double kMostMicroseconds = 8.1;

/// The model: microseconds a pixel x pixels inside of all frames, for the exemplar's length (the
/// table of docs/performance.md: 0.80 s + 0.0033 s x frames), twice that where frames are painted
/// in both directions of time or the finest level is searched, divided by what threads gain (two
/// were 1.6 to 1.8 times as fast as one, and each further one is taken for as much).
/// @param insidePx  of all frames that are painted.
[[nodiscard]] TimeEstimate estimateTime(std::int64_t insidePx, int exemplarFrames,
                                        const SynthesisOptions& synthesis, int threads);

}  // namespace fluidymation
