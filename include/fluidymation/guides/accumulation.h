#pragma once

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Accumulated motion at a pixel, thesis §3.5. The vectors are kept, not only their length: a
/// movement back reduces what the movement there added, and the temporal shift needs differences.

/// acc+ of frame i from acc+ of frame i-1: previous + flow inside the mask, zero outside.
[[nodiscard]] Image<Vec2> accumulateForward(const Image<Vec2>& previous, const Image<Vec2>& flow,
                                            const Mask& mask);

/// acc- of frame i from acc- of frame i+1: next + flow of frame i+1 inside the mask of frame i,
/// zero outside; where the pixel has left mask i+1 the flow of frame i stands in.
[[nodiscard]] Image<Vec2> accumulateBackward(const Image<Vec2>& next, const Image<Vec2>& nextFlow,
                                             const Mask& nextMask, const Image<Vec2>& flow,
                                             const Mask& mask);

}  // namespace fluidymation
