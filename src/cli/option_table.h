#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace fluidymation::cli {

/// The last group of the help text, where --help and --version belong too.
inline constexpr const char* kRunningGroup = "Running";

/// One line of the option table.
struct Spec {
  std::string name;
  std::string group;
  std::string valueName;  ///< stands for the value in the help text; empty for a flag
  std::string help;
  bool required = false;
  std::function<void(CommandLine&, const std::string& value)> apply;
  /// The value as it would be given, "true" or "false" for a flag; nothing where it goes without
  /// saying. Options that have no such function are for the command line alone: no config file
  /// holds them.
  std::function<std::optional<std::string>(const CommandLine&)> text{};
  std::vector<std::string> words = {};  ///< all values there are; empty where they are not words
};

/// All options but --help and --version, in the order of the help text, which is also the order in
/// which they are applied: --preset before those that it sets.
[[nodiscard]] std::vector<Spec> optionTable();

}  // namespace fluidymation::cli
