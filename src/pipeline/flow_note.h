#pragma once

#include <optional>
#include <string>

#include "fluidymation/guides/diffusion.h"

namespace fluidymation {

/// What the user should know about the flow of a frame: one sentence, nothing when it is sound.
/// @param option  the option that gave the masks and its value.
[[nodiscard]] std::optional<std::string> flowNote(const std::string& option, int frameNumber,
                                                  const SolveReport& report);

}  // namespace fluidymation
