#pragma once

#include <string>
#include <vector>

#include "cli/streams.h"

namespace fluidymation::cli {

/// What `fluidymation NAME ...` does.
struct Subcommand {
  std::string name;
  std::string summary;  ///< for the help text of the tool
  /// @param argv  argv[0] is the name; the command's own arguments follow.
  /// @throws UsageError, Error, Interrupted.
  ExitCode (*run)(int argc, const char* const* argv, const Streams& streams,
                  const StopSignal& stopSignal);
};

/// All of them, in the order of the help text.
[[nodiscard]] const std::vector<Subcommand>& subcommands();

/// The subcommand that the first argument names; null where it is an option, or there is none.
/// @param argv  of `main`.
/// @throws UsageError where the first argument is a word that names no subcommand.
[[nodiscard]] const Subcommand* chosenSubcommand(int argc, const char* const* argv);

}  // namespace fluidymation::cli
