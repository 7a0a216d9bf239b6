#pragma once

#include <string>
#include <vector>

#include "cli/option_table.h"

namespace fluidymation::packaging {

/// The option table with --help and --version at its end, as users see it.
[[nodiscard]] std::vector<cli::Spec> allOptions();

/// The words that may come first: names of commands, in the order of the help text.
[[nodiscard]] std::vector<std::string> allCommands();

/// What a shell offers for an option's value.
enum class ValueKind {
  kNone,    ///< a flag has no value
  kWord,    ///< one of `Spec::words`
  kFile,    ///< a file, or a pattern of files
  kFolder,  ///< a folder
  kOther    ///< numbers: nothing can be offered
};
[[nodiscard]] ValueKind valueKind(const cli::Spec& spec);

/// The help text up to its default, on one line.
[[nodiscard]] std::string shortHelp(const cli::Spec& spec);

}  // namespace fluidymation::packaging
