#pragma once

#include <optional>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// "#F4F1E8", "#fff", "white", "black" or "gray"; nothing for any other text.
[[nodiscard]] std::optional<Rgb> colorOf(const std::string& text);

/// The middle of a picture that has the shape of `size`, scaled to it: it fills the frame and is
/// cut where it is longer.
[[nodiscard]] Image<Rgb> filledBy(const Image<Rgb>& picture, Size size);

}  // namespace fluidymation
