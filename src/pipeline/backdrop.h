#pragma once

#include <functional>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// What stands for the exemplar's bare surface.
inline constexpr const char* kExemplarSurface = "exemplar";

/// Whether a text that names a background is a file's name: no colour, and not the exemplar.
[[nodiscard]] bool isBackgroundFile(const std::string& text);

/// One text for each colour: "#ffffff" for "white" and "#FFF"; any other text as it is. So is
/// "gray", which lies between two bytes.
[[nodiscard]] std::string backgroundText(const std::string& text);

/// @throws UsageError where the text is a file's name and there is none.
void requireBackground(const std::string& option, const std::string& text);

/// Of one colour (`colorOf`), of a PNG file that fills it and is cut where it is longer, or of the
/// exemplar's bare surface where the text is `kExemplarSurface`.
/// @param option  which asks for it, for messages.
/// @param size    of the target's frames.
/// @param beforeFile  called before each file of the exemplar; may throw to stop.
/// @throws UsageError where the text is neither a colour nor a file; Error naming a file that
/// cannot be read, or saying that no surface is bare.
[[nodiscard]] Image<Rgb> backdrop(
    const std::string& option, const std::string& text, const Inputs& inputs, Size size,
    const std::function<void()>& beforeFile = [] {});

}  // namespace fluidymation
