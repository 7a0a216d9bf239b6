#include "cli/subcommand.h"

#include "cli/inspect_command.h"
#include "cli/layers_command.h"
#include "cli/mask_command.h"
#include "cli/preview_command.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"

namespace fluidymation::cli {

const std::vector<Subcommand>& subcommands() {
  static const std::vector<Subcommand> all = {
      {"inspect", "says what is wrong with the inputs and what to expect; paints nothing",
       inspectCommand},
      {"layers", "paints a shot of several layers, and lays them over each other", layersCommand},
      {"mask", "makes the masks of an exemplar from its film; paints nothing", maskCommand},
      {"preview", "shows painted frames as a sheet or a film; paints nothing", previewCommand}};
  return all;
}

const Subcommand* chosenSubcommand(int argc, const char* const* argv) {
  const std::string word = argc > 1 ? argv[1] : "-";
  if (!word.empty() && word[0] == '-') return nullptr;
  std::string names;
  for (const Subcommand& command : subcommands()) {
    if (command.name == word) return &command;
    names += (names.empty() ? "" : ", ") + command.name;
  }
  throw UsageError(shown("command", word) + ": there is no such command; wanted " + names +
                   ", or options alone, to paint (see --help)");
}

}  // namespace fluidymation::cli
