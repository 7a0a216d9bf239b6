#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// "#F4F1E8", "#fff", "white", "black" or "gray"; nothing for any other text.
[[nodiscard]] std::optional<Rgb> colorOf(const std::string& text);

/// Of one colour, of a PNG file that fills it and is cut where it is longer, or of the exemplar's
/// bare surface where the text is "exemplar".
/// @param size  of the target's frames.
/// @throws UsageError where the text is neither a colour nor a file; Error naming a file that
/// cannot be read, or saying that no surface is bare.
/// @param beforeFile  called before each file of the exemplar; may throw to stop.
[[nodiscard]] Image<Rgb> backdrop(
    const std::string& text, const Inputs& inputs, Size size,
    const std::function<void()>& beforeFile = [] {});

}  // namespace fluidymation
