#include "fluidymation/replay.h"

#include <utility>

#include "checkpoint/manifest.h"
#include "fluidymation/core/error.h"

namespace fluidymation {

Replay replayOf(const std::string& manifestPath) {
  constexpr const char* kReplaced = "\xEF\xBF\xBD";  // for a byte that is no UTF-8
  Manifest manifest = readManifest(manifestPath);
  Replay replay{std::move(manifest.fingerprint.version), std::move(manifest.paths)};
  for (const auto& [option, path] : replay.options) {
    if (path.find(kReplaced) == std::string::npos) continue;
    throw Error(manifestPath + ": " + option +
                " had bytes that are no UTF-8 and no manifest holds; wanted other names of files");
  }
  for (auto& option : manifest.fingerprint.options) replay.options.push_back(std::move(option));
  return replay;
}

}  // namespace fluidymation
