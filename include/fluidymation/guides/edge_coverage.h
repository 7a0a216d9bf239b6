#pragma once

#include "fluidymation/core/image.h"

namespace fluidymation {

/// How much of a pixel an edge covers that is straight there: the inverse of a box-filtered step
/// (Gustavson and Strand 2011).
/// @param distance  of the pixel's centre to the edge, px, positive inside.
/// @param normal    across the edge; any length. (0, 0) is taken for a horizontal edge.
/// @return  in [0, 1]; 1 from 0.71 px inside on at the latest, 0 likewise outside.
[[nodiscard]] float edgeCoverage(float distance, Vec2 normal);

/// `edgeCoverage` of every pixel. @param distance  `outlineDistance`.
[[nodiscard]] Image<float> coverageOf(const Image<float>& distance);

}  // namespace fluidymation
