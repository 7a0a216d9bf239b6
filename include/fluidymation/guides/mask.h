#pragma once

#include "fluidymation/core/image.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// (Gaussian * mask) >= threshold (thesis §4.1): smooth outlines that include a little of the
/// bare surface. Thin parts, narrower than about 0.7 sigma, vanish. Sigma 0 copies the mask.
[[nodiscard]] Mask smoothMask(const Mask& mask, const MaskOptions& options);

/// Gaussian * coverage, where `coverage` is in [0, 1]; sigma 0 copies it.
[[nodiscard]] Image<float> smoothCoverage(const Image<float>& coverage, float sigmaPx);

/// The paper's shape guide (P§3.1): Gaussian * mask, from 0 far outside to 1 deep inside. The
/// kernel reaches `radiusPx` = 3 sigma; past the image edge the edge repeats.
[[nodiscard]] Image<float> blurredMask(const Mask& mask, float radiusPx);

/// Whether the mask has both sides: a shape without an edge within the image has no distance to it.
[[nodiscard]] bool hasEdge(const Mask& mask);

}  // namespace fluidymation
