#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// How far the colours of a frame are from those of the bare surface: the CIE76 colour difference
/// in CIELAB (1976). What differs is averaged before its length is taken, so that grain, which
/// points anywhere, cancels and paint does not.
/// @param frame, bare  of one size (asserted).
/// @param grainSigmaPx  of the Gaussian that averages; 0 is off.
/// @return  of the same size, from 0 up; about 2.3 can just be seen.
[[nodiscard]] Image<float> filmDifference(const Image<Lab>& frame, const Image<Lab>& bare,
                                          float grainSigmaPx);

/// How large grain alone makes the differences above: the root of their mean square. It is told
/// from all else by neighbours' differences, whose median edges and paint hardly change; grain is
/// taken to be independent from pixel to pixel.
[[nodiscard]] float grainLevel(const Image<Lab>& frame, const Image<Lab>& bare, float grainSigmaPx);

}  // namespace fluidymation
