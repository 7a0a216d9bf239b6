#pragma once

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Slower flow than this has no direction of its own, px per frame.
inline constexpr float kStillPxPerFrame = 0.01F;

/// Unit direction of movement at every inside pixel. Where the flow is slower than
/// `kStillPxPerFrame`: the pixel's last direction (`previous`, where the pixel was inside then),
/// else the harmonic extension of the outward border normals, else (1, 0).
/// @param previous  directions of the frame before, or an empty image.
/// @param distance  signed distance of `mask`.
/// @return  unit vectors inside the mask, (0, 0) outside.
[[nodiscard]] Image<Vec2> flowDirection(const Mask& mask, const Image<Vec2>& flow,
                                        const Image<float>& distance, const Image<Vec2>& previous);

}  // namespace fluidymation
