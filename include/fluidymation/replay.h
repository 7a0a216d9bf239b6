#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fluidymation {

/// What a manifest says of the run that it is of.
struct Replay {
  std::string version;  ///< of the engine that painted; another one may paint other bytes
  /// Names and values as the command line takes them, paths first: they give the same frames.
  std::vector<std::pair<std::string, std::string>> options;
};

/// @throws Error naming the manifest when it cannot be read or is none.
[[nodiscard]] Replay replayOf(const std::string& manifestPath);

}  // namespace fluidymation
