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
/// with a film of 20 to 24 frames: the fastest and the slowest figure of docs/performance.md, of a
/// quiet machine and of one on which others kept 16 jobs running on 2 processors.
inline constexpr double kLeastMicroseconds = 4.9;
inline constexpr double kMostMicroseconds = 13.5;

/// The model: microseconds a pixel x pixels inside of all frames, for the exemplar's length (the
/// table of docs/performance.md: 0.80 s + 0.0033 s x frames), twice that where frames are painted
/// in both directions of time or the finest level is searched, divided by what threads gain (two
/// were 1.6 to 1.8 times as fast as one, and each further one is taken for as much).
/// @param insidePx  of all frames that are painted.
[[nodiscard]] TimeEstimate estimateTime(std::int64_t insidePx, int exemplarFrames,
                                        const SynthesisOptions& synthesis, int threads);

}  // namespace fluidymation
