#pragma once

#include <string>
#include <vector>

#include "cli/option_table.h"

namespace fluidymation::packaging {

/// A script for bash that completes commands, options and their values, as "--option value" and
/// "--option=value"; for a file of its own in bash-completion's folder.
/// @param commands  words that may come first.
[[nodiscard]] std::string bashCompletion(const std::vector<cli::Spec>& options,
                                         const std::vector<std::string>& commands);

/// The same for zsh, as a function file for its fpath, with a description of each option.
[[nodiscard]] std::string zshCompletion(const std::vector<cli::Spec>& options,
                                        const std::vector<std::string>& commands);

}  // namespace fluidymation::packaging
