#pragma once

#include <map>
#include <vector>

#include "bench/benchmark_case.h"
#include "bench/stage_clock.h"

namespace fluidymation::bench {

/// What painting a case cost.
struct Measurement {
  /// By stage and level, one value a repetition: of a frame, the mean over all but the first.
  std::map<StageOfLevel, std::vector<Cost>> costs;
  double maskPixels = 0.0;  ///< inside, the mean over the same frames
  bool sameMatches = true;  ///< whether the stages gave the matches of whole frames
};

/// Paints the target of a case `repetitions` times, each frame as a whole and stage by stage in
/// turn. The target has at least two frames.
[[nodiscard]] Measurement measure(const LoadedCase& loaded, int repetitions);

}  // namespace fluidymation::bench
