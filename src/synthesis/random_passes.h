#pragma once

#include "fluidymation/option_ranges.h"

namespace fluidymation {

// Numbers of the random passes besides the sweeps of the search, which count up from 0.
inline constexpr int kRandomFieldPass = -1;
inline constexpr int kRepairPass = -2;
// Of a frame that is painted once more; more than all sweeps of the first time, and even, so that
// the first one goes in row order too.
inline constexpr int kFirstPassOfRevision = 1 << 20;
static_assert((ranges::kOptIterations.high + 1) * ranges::kPatchmatchIterations.high <
              kFirstPassOfRevision);

}  // namespace fluidymation
