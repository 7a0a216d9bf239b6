#pragma once

#include <string>
#include <vector>

#include "cli/option_table.h"
#include "cli/subcommand.h"

namespace fluidymation::packaging {

/// The options as sections of a manual page, in roff with the macros of man(7): a subsection a
/// group, a paragraph an option, with all of its help.
[[nodiscard]] std::string manPageOptions(const std::vector<cli::Spec>& options);

/// What each command does, as paragraphs of the same kind.
[[nodiscard]] std::string manPageCommands(const std::vector<cli::Subcommand>& commands);

/// `text` as roff prints it: no character of it is an instruction, and a dash is a dash to copy.
[[nodiscard]] std::string roffText(const std::string& text);

}  // namespace fluidymation::packaging
