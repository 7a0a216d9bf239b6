#pragma once

#include <string>

namespace fluidymation::cli {

/// The text of a config file, of at most a megabyte: of a regular file, or of a pipe such as
/// /dev/stdin or what a shell puts in the place of <(command). Waits for what writes into a pipe,
/// until a stop signal comes.
/// @throws Error naming the file where it cannot be read, is too large, is neither of these, or is
/// a
///   pipe that nobody writes into; Interrupted.
[[nodiscard]] std::string configSource(const std::string& path);

}  // namespace fluidymation::cli
