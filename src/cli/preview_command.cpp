#include "cli/preview_command.h"

#include <algorithm>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/command_syntax.h"
#include "cli/option_table.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/preview.h"

namespace fluidymation::cli {
namespace {

/// The painter's options, so that the word `preview` can be put into any command that paints.
[[nodiscard]] CommandSyntax previewSyntax() {
  std::vector<Spec> table = optionTable();
  table.erase(std::remove_if(table.begin(), table.end(),
                             [](const Spec& spec) { return spec.name == "--verify"; }),
              table.end());
  for (Spec& spec : table) {
    const bool isOfPreview = spec.name.compare(0, 9, "--preview") == 0;
    if (spec.name == "--preview") spec.required = true;
    if (!isOfPreview && !spec.required) spec.group.clear();
  }
  return {
      "fluidymation preview",
      "Shows painted frames as they are on the disk, and paints nothing. Takes all options of\n"
      "painting (see fluidymation --help): put the word preview into the command that painted,\n"
      "and add --preview FILE.\n",
      std::move(table)};
}

}  // namespace

ExitCode previewCommand(int argc, const char* const* argv, const Streams& streams,
                        const StopSignal& stopSignal) {
  const CommandLine line = parseCommandLine(previewSyntax(), argc, argv);
  if (line.information) {
    streams.out << *line.information;
    requireWritten(streams);
    return kDone;
  }
  const auto isCancelled = [&] { return stopSignal && stopSignal() != 0; };
  const int frames = Preview(line.options, line.preview, isCancelled).finish();
  if (frames == 0) {
    throw Error("--out-path " + line.options.outPath +
                ": no painted frame is there; paint some first");
  }
  streams.out << oneLine(line.preview.path) + ": shows " + std::to_string(frames) +
                     (frames == 1 ? " frame\n" : " frames\n");
  requireWritten(streams);
  return kDone;
}

}  // namespace fluidymation::cli
