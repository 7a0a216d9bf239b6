#pragma once

#include "fluidymation/synthesis/texel.h"
#include "support/fixed_point.h"

namespace fluidymation {

/// How far a mean in fixed point lies from the exact one, units of CIELAB, at most: each sample by
/// the error of its interpolation, and the mean is rounded to the nearest step once more; its
/// division in single precision may turn a tie. No two colours of `randomTexture` are farther apart
/// than 40.
inline constexpr double kTextureRange = 40.0 * kColorSteps;
inline constexpr double kVoteTolerance =
    (test::interpolationError(kTextureRange) + 0.5 + 0x1p-8) / kColorSteps;

}  // namespace fluidymation
