#pragma once

#include "fluidymation/core/image.h"
#include "fluidymation/guides/outline.h"

namespace fluidymation {

/// Signed distance field of a sub-pixel outline (thesis §3.4): 0 on it, positive inside, px. It is
/// what `continuousDistance` approximates for masks that are cut at one half.
///
/// The nearest corner of the outline is found exactly and in linear time, by two separable passes
/// (Felzenszwalb and Huttenlocher 2012), one for the corners on vertical lines between pixel
/// centres and one for those on horizontal lines; the distance is that to the pieces of the outline
/// that meet there. For the pixels near by, the last piece goes on for a pixel past the image's
/// edge. Exact on straight outlines near and far, in the outermost pixels too where the outline
/// crosses the image's edge at more than 45 degrees. At shallower angles its last corner is not
/// known well, since the coverage it follows from ends there, and within half a pixel of the
/// image's edge it may have none.
/// @param mask  with both sides (asserted); a part of a frame that holds the shape and the pixels
///   next to it, as far as the frame reaches.
/// @param origin  of that part in the frame: the same numbers come out, bit for bit, for any part.
[[nodiscard]] Image<float> outlineDistance(const Mask& mask, const Outline& outline,
                                           Pixel origin = {});

/// From the convention of `outlineDistance` to that of `signedDistance`, between pixel centres: a
/// pixel inside whose outer neighbour is just outside has 1. The inverse of `continuousDistance`.
[[nodiscard]] Image<float> pixelCentreDistance(const Mask& mask, const Image<float>& distance);

}  // namespace fluidymation
