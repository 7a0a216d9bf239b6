#pragma once

#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/pyramid.h"

namespace fluidymation {

/// One level finer (thesis §3.9): x' = 2x + 1/2 + R_-theta((q mod 2) - 1/2).
/// @param fine  the finer level's segments; pixels outside get no match.
[[nodiscard]] NearestNeighborField upscale(const NearestNeighborField& coarse,
                                           const Image<Segment>& fine);

/// `level` levels coarser in one step (thesis §3.9): every match of the 2^level block is moved to
/// the coarse grid, x_l = (x - c - R_-theta((q mod 2^level) - c)) / 2^level, c = (2^level - 1) / 2,
/// and the most frequent one wins, counted by position rounded to pixels, frame, and angle in 32
/// bins round the circle. Ties go to the first in row order; the winner's first member is copied
/// unrounded. Blocks without any match get none.
[[nodiscard]] NearestNeighborField downscale(const NearestNeighborField& fine, int level);

}  // namespace fluidymation
