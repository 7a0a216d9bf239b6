#pragma once

#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/guides/packed_mask.h"

namespace fluidymation {

/// Accumulated motion at a pixel, thesis §3.5. The vectors are kept, not only their length: a
/// movement back reduces what the movement there added, and the temporal shift needs differences.
/// All vectors are those of the pixels of their frame's mask, in row order.

/// acc+ of frame i from acc+ of frame i-1: previous + flow, where what is newly covered has no
/// past.
[[nodiscard]] std::vector<Vec2> accumulateForward(const PackedMask& previousMask,
                                                  const std::vector<Vec2>& previous,
                                                  const PackedMask& mask,
                                                  const std::vector<Vec2>& flow);

/// acc- of frame i from acc- of frame i+1: next + flow of frame i+1; where the pixel has left mask
/// i+1 the flow of frame i stands in.
[[nodiscard]] std::vector<Vec2> accumulateBackward(const PackedMask& nextMask,
                                                   const std::vector<Vec2>& next,
                                                   const std::vector<Vec2>& nextFlow,
                                                   const PackedMask& mask,
                                                   const std::vector<Vec2>& flow);

}  // namespace fluidymation
