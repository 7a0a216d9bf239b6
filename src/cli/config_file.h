#pragma once

#include <string>
#include <vector>

#include "cli/option_table.h"

namespace fluidymation::cli {

/// An option that a file gives.
struct ConfigEntry {
  std::string option;  ///< "--border-width"
  std::string value;
  std::string place;  ///< "shot.toml: line 3", for messages
};

/// What a config file holds.
struct Config {
  std::vector<ConfigEntry> entries;
  std::string note;  ///< one sentence for the user; may be empty
};

/// Reads a config file: a line for each option, `border-width = 12`, strings in quotes, `#` before
/// comments (the part of TOML without sections that CLI11 reads, a line at a time). Or the manifest
/// of a run, which is told by the brace that it begins with.
/// @throws Error naming the file where it cannot be read (`configSource`) or is no manifest;
///   UsageError naming file and line (of a manifest, the key) where an option is unknown, not for
///   files, given twice or has no value.
[[nodiscard]] Config readConfig(const std::string& path, const std::vector<Spec>& table);

/// A config file of all options in `table` as `line` has them.
/// @throws UsageError naming the option whose value no config file can hold.
[[nodiscard]] std::string configText(const std::vector<Spec>& table, const CommandLine& line);

}  // namespace fluidymation::cli
