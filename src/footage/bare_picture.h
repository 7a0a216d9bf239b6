#pragma once

#include <optional>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// The median of pictures, for each pixel and channel; of an even number the mean of the two in
/// the middle. Grain goes, and so does what is there in less than half of them.
/// @param pictures  one or more, of one size (asserted).
[[nodiscard]] Image<Rgb> medianPicture(const std::vector<Image<Rgb>>& pictures);

/// The picture with the surface filled in where paint lies: smooth shading from around, and grain
/// of a bare place nearby (`BareSurface`).
/// @param paint  of the picture's size (asserted), in [0, 1]; a margin round it is filled in too.
/// @return  nothing where no pixel is bare.
[[nodiscard]] std::optional<Image<Rgb>> withoutPaint(const Image<Rgb>& picture,
                                                     const Image<float>& paint);

}  // namespace fluidymation
