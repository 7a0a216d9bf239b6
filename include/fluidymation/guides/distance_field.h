#pragma once

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Exact Euclidean distance to the other side of `mask`, positive inside (thesis §3.4).
/// @param mask  nonzero where the material is. Pixels past the image edge belong to neither side:
///   a shape that is cut by the frame has no border there.
/// @return  same size, pixels between pixel centres: >= 1 inside, <= -1 outside, never 0;
///   -(w+h) everywhere in an empty mask, +(w+h) in a full one. These stand-ins must not enter a
///   difference or an average. Meijster et al. 2000: time linear in the pixels.
[[nodiscard]] Image<float> signedDistance(const Mask& mask);

/// Euclidean distance to the nearest pixel of `mask`, px: exact up to `reachPx`, some number above
/// it elsewhere; 0 in the mask. Several times as fast as the above where the reach is short.
/// @param reachPx  >= 0.
[[nodiscard]] Image<float> distanceWithin(const Mask& mask, int reachPx);

}  // namespace fluidymation
