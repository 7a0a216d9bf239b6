#include "cli/painter_syntax.h"

#include <string>

#include "cli/option_table.h"
#include "cli/subcommand.h"

namespace fluidymation::cli {

CommandSyntax painterSyntax() {
  std::string description =
      "Paints an animation of masks with a filmed medium (\"Stylizing vector animation\").\n"
      "Distances are pixels of the scaled input. PATTERN is a path with one frame number, as\n"
      "printf writes it: frames/%05d.png, the same as frames/#####.png, or a folder of frames.\n\n"
      "Other commands, each with a --help of its own:\n";
  for (const Subcommand& command : subcommands()) {
    description += "  fluidymation " + command.name + "  " + command.summary + "\n";
  }
  return {"fluidymation", description, optionTable()};
}

}  // namespace fluidymation::cli
