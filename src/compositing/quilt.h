#pragma once

#include <optional>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// A picture of any size with the texture of another, in the same way each time: square blocks of
/// it, each the one of some dozens drawn at random that fits best to those before it where it
/// overlaps them, joined along the line that shows least. Efros and Freeman, Image Quilting for
/// Texture Synthesis and Transfer (2001).
/// @param usable  which pixels a block may hold; of the texture's size (asserted).
/// @return  nothing where too few blocks of 16 px or more are wholly usable.
[[nodiscard]] std::optional<Image<Rgb>> quilted(const Image<Rgb>& texture, const Mask& usable,
                                                Size size);

}  // namespace fluidymation
