#pragma once

#include "fluidymation/core/image.h"
#include "synthesis/sampling.h"

namespace fluidymation {

/// By how much a picture's steps from pixel to pixel are wanted to be others than they are: L, a, b
/// in CIELAB's units, and in the last lane how much that counts, [0, 1]; 0: not at all.
struct WantedSteps {
  explicit WantedSteps(Size size) : right(size, Float4{}), down(size, Float4{}) {}

  Image<Float4> right;  ///< from (x, y) to (x + 1, y); the last column is not looked at
  Image<Float4> down;   ///< from (x, y) to (x, y + 1); the last row is not looked at
};

/// The changes e of a picture's colours that minimise
///     sum |e(p)|^2 + weight * sum w(p, q) |e(q) - e(p) - s(p, q)|^2
/// over all pixels p and their neighbours q to the right and below, with the wanted steps s and
/// what they count, w: a screened Poisson equation (Bhat et al. 2008), as patches are melded by
/// Darabi et al. (2012). A step that is one pixel wide becomes a slope of about sqrt(weight) px on
/// either side; where no steps are wanted nothing is changed.
///
/// Solved by successive over-relaxation in two colours, so that the result does not depend on the
/// number of threads, to within 1/100 of the largest change.
/// @param weight  >= 0; 0: nothing is changed.
/// @return  L, a, b; the last lane means nothing.
[[nodiscard]] Image<Float4> seamChanges(const WantedSteps& steps, float weight);

}  // namespace fluidymation
