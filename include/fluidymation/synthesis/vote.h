#pragma once

#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation {

/// The voting step (thesis §2.1.2): every pixel q inside becomes the mean, over the windows that
/// cover it, of their source pixel at q: (x, y)_n + R_-theta_n (q - n), bilinear. Windows without a
/// match do not vote. Colours are averaged in CIELAB, the space in which they are compared, in
/// fixed point: sums are exact, and do not depend on their order.
/// @param segment  the picture is wanted where it is not Segment::kOutside; size of `nnf`.
/// @param sigmaPx  Gaussian weight of a window by the distance of its centre, px, in steps of 1/256
///   of a window centred on the pixel; 0: all 25 alike, as in the thesis.
/// @return  no colour where it is not wanted or no window that counts covers it.
[[nodiscard]] Image<FixedLab> vote(const ExemplarLevel& exemplar, const Image<Segment>& segment,
                                   const NearestNeighborField& nnf, float sigmaPx);

}  // namespace fluidymation
