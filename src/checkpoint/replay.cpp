#include "fluidymation/replay.h"

#include <utility>

#include "checkpoint/manifest.h"

namespace fluidymation {

Replay replayOf(const std::string& manifestPath) {
  Manifest manifest = readManifest(manifestPath);
  Replay replay{std::move(manifest.fingerprint.version), std::move(manifest.paths)};
  for (auto& option : manifest.fingerprint.options) replay.options.push_back(std::move(option));
  return replay;
}

}  // namespace fluidymation
