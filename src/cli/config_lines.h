#pragma once

#include <string>
#include <vector>

#include "cli/config_file.h"

namespace fluidymation::cli {

// How config files are read, a line at a time: what those of a run and of layers have in common.

/// The whole of a small text file or of a pipe (`configSource`), without a byte order mark.
/// @throws Error naming it; Interrupted.
[[nodiscard]] std::string configTextOf(const std::string& path);

/// A line that says something, without blanks round it and without a comment.
struct ConfigLine {
  std::string text;
  std::string place;  ///< "shot.toml: line 3", for messages
};

/// @throws UsageError naming file and line where one holds a control character.
[[nodiscard]] std::vector<ConfigLine> configLines(const std::string& path, const std::string& text);

/// @throws UsageError where no file may hold this key: "border-width".
void requireKey(const std::string& key, const std::string& place, const std::vector<Spec>& table);

/// The option of a line such as `border-width = 12`. CLI11 reads the value: quotes, lists.
/// @throws UsageError naming the line where it is none of `table`, or has no value.
[[nodiscard]] ConfigEntry entryOf(const ConfigLine& from, const std::vector<Spec>& table);

/// @throws UsageError where an option is given twice.
void requireOnce(const std::vector<ConfigEntry>& entries);

}  // namespace fluidymation::cli
