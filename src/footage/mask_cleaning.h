#pragma once

#include <cstdint>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// The mask without parts of fewer than `smallestPartPx` pixels (8-neighbours), and with holes of
/// fewer than `smallestHolePx` filled. A hole is bare surface that paint encloses, or paint and the
/// picture's border together. Parts go first: a speck within a hole does not split it. 0 leaves
/// all.
[[nodiscard]] Mask cleanedMask(const Mask& mask, std::int64_t smallestPartPx,
                               std::int64_t smallestHolePx);

/// How much of each pixel the mask holds, where its outline is the line on which `difference`
/// crosses `threshold`: along the outline the distance to that line, to first order, is read as
/// coverage. Inside is from a half up, as in `mask`; where cleaning has overruled the difference
/// the outline stays hard.
[[nodiscard]] Image<float> softCoverage(const Image<float>& difference, float threshold,
                                        const Mask& mask);

}  // namespace fluidymation
