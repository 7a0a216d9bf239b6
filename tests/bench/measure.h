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
};

/// Paints the target of a case, which has at least two frames, `repetitions` times. One stage
/// follows the other, where the tool has some side by side; and every frame is encoded, which the
/// tool spares itself where it looks as the one before.
[[nodiscard]] Measurement measure(const LoadedCase& loaded, int repetitions);

}  // namespace fluidymation::bench
