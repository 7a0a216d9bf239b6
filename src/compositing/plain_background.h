#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// The middle of a picture that has the shape of `size`, scaled to it: it fills the frame and is
/// cut where it is longer.
[[nodiscard]] Image<Rgb> filledBy(const Image<Rgb>& picture, Size size);

}  // namespace fluidymation
