#pragma once

#include <set>
#include <string>

#include "cli/command_line.h"

namespace fluidymation::cli {

// Paths that are plain folders: the engine knows patterns only.

/// @throws UsageError naming `option` unless `path` is a folder that is there, or a pattern.
void checkInputPath(const std::string& option, const std::string& path);

/// @throws UsageError naming `option` unless `path` is a pattern of PNG files or a folder: one that
/// is there, or a path that ends in a slash or whose last name has no dot.
void checkOutputPath(const std::string& option, const std::string& path);

/// Replaces folders by patterns of the files in them. Film and animation then begin with the first
/// file and have as many frames as the numbers span, as far as nothing else is `given`.
/// @param given  names of the options that the user has given: "--src-start".
/// @throws Error where a folder cannot be read or holds more than one sequence.
void resolveFolders(const std::set<std::string>& given, Options& options);

}  // namespace fluidymation::cli
