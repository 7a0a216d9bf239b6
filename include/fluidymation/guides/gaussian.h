#pragma once

#include <cmath>
#include <vector>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// How far a Gaussian reaches from its middle: it is cut at 3 sigma, rounded up.
[[nodiscard]] inline int gaussianReach(float sigma) {
  return static_cast<int>(std::ceil(3.0F * sigma));
}

/// Normalized Gaussian weights for offsets 0..`gaussianReach` (one side, symmetric: w[0] + 2 * sum
/// of the others = 1). `sigma` 0 gives {1}.
[[nodiscard]] std::vector<float> gaussianKernel(float sigma);

/// Separable Gaussian blur, sigma in pixels; pixels past the image edge repeat the edge.
[[nodiscard]] Image<float> gaussianBlur(const Image<float>& image, float sigmaPx);

}  // namespace fluidymation
