#pragma once

#include <string>
#include <vector>

#include "cli/option_table.h"

namespace fluidymation::cli {

/// How a command is called.
struct CommandSyntax {
  std::string name;         ///< "fluidymation", "fluidymation inspect"
  std::string description;  ///< the help text begins with it
  std::vector<Spec> table;  ///< of options whose group is empty the help text is silent
  /// "SHOT.toml": the one argument besides options, which must be given; empty: there is none.
  std::string operand = {};
};

}  // namespace fluidymation::cli
