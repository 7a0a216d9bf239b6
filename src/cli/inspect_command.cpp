#include "cli/inspect_command.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/command_syntax.h"
#include "cli/option_table.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/inspect.h"

namespace fluidymation::cli {
namespace {

/// The painter's options. Those that say what is read are in the help text; the others are taken so
/// that the word `inspect` can be put into any command that paints.
/// @param guidesFolder  is set by --guides.
[[nodiscard]] CommandSyntax inspectSyntax(std::optional<std::string>& guidesFolder) {
  std::vector<Spec> table = optionTable();
  table.erase(std::remove_if(table.begin(), table.end(),
                             [](const Spec& spec) { return spec.name == "--verify"; }),
              table.end());
  for (Spec& spec : table) {
    if (spec.name == "--out-path") {
      spec.required = false;
      spec.help = "checked where it is given, and not written\n(default off)";
    } else if (!spec.required) {
      spec.group.clear();
    }
  }
  table.push_back({"--guides", "Inspection", "DIR",
                   "write pictures of some frames' guides to DIR/exemplar and\n"
                   "DIR/animation: flow (hue is direction), how far the material\n"
                   "has come and has to go, distance to the edge, segments\n"
                   "(default off)",
                   false, [&guidesFolder](CommandLine&, const std::string& value) {
                     if (value.empty()) {
                       throw UsageError(shown("--guides", value) + ": wanted a folder's name");
                     }
                     guidesFolder = value;
                   }});
  return {"fluidymation inspect",
          "Looks at all that a run would read, and paints nothing: what is wrong with the files,\n"
          "and what to expect. Takes all options of painting besides (see fluidymation --help):\n"
          "put the word inspect into the command that paints.\n\n"
          "Exit codes: 0 where the run could be painted, 1 where faults are in the way, 2 for\n"
          "wrong usage.\n",
          std::move(table)};
}

}  // namespace

ExitCode inspectCommand(int argc, const char* const* argv, const Streams& streams,
                        const StopSignal& stopSignal) {
  std::optional<std::string> guidesFolder;
  const CommandLine line = parseCommandLine(inspectSyntax(guidesFolder), argc, argv);
  if (line.information) {
    streams.out << *line.information;
    requireWritten(streams);
    return kDone;
  }
  Observer observer;
  observer.cancelled = [&] { return stopSignal && stopSignal() != 0; };
  const Inspection found = inspect(line.options, guidesFolder, observer);
  for (const std::string& note : found.notes) {
    if (!line.quiet) streams.err << noteLine(note);
  }
  for (const std::string& fault : found.faults) {
    streams.err << "fluidymation: error: " + oneLine(fault) + "\n";
  }
  streams.err << std::flush;
  for (const std::string& text : found.report) streams.out << oneLine(text) + "\n";
  requireWritten(streams);
  return found.faults.empty() ? kDone : kFailed;
}

}  // namespace fluidymation::cli
