#pragma once

#include "cli/command_syntax.h"

namespace fluidymation::cli {

/// The command without a word of its own, which paints; its help text lists the others too.
[[nodiscard]] CommandSyntax painterSyntax();

}  // namespace fluidymation::cli
