#pragma once

#include <vector>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Normalized Gaussian weights for offsets 0..radius (one side, symmetric: w[0] + 2 * sum of the
/// others = 1), cut at 3 sigma: radius = ceil(3 * sigma). `sigma` 0 gives {1}.
[[nodiscard]] std::vector<float> gaussianKernel(float sigma);

/// Separable Gaussian blur, sigma in pixels; pixels past the image edge repeat the edge.
[[nodiscard]] Image<float> gaussianBlur(const Image<float>& image, float sigmaPx);

}  // namespace fluidymation
