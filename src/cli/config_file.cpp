#include "cli/config_file.h"

#include <cstddef>

#include "cli/config_lines.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/version.h"
#include "fluidymation/replay.h"

namespace fluidymation::cli {
namespace {

/// Whether the text is JSON, as manifests are; no config file begins with a brace.
[[nodiscard]] bool isManifest(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '{';
}

[[nodiscard]] Config configOf(const std::string& path, const std::string& text,
                              const std::vector<Spec>& table) {
  Config config;
  for (const ConfigLine& line : configLines(path, text)) {
    if (line.text.front() == '[') {
      throw UsageError(line.place + ": " + oneLine(line.text) +
                       ": there are no sections; wanted a line such as border-width = 12 "
                       "(files with layers are for fluidymation layers)");
    }
    config.entries.push_back(entryOf(line, table));
  }
  return config;
}

[[nodiscard]] Config configOfManifest(const std::string& path, const std::vector<Spec>& table) {
  const Replay replay = replayOf(path);
  Config config;
  for (const auto& [option, value] : replay.options) {
    if (option.compare(0, 2, "--") != 0) {
      throw UsageError(path + ": " + oneLine(option) + ": is no option");
    }
    requireKey(option.substr(2), path, table);
    config.entries.push_back({option, value, path});
  }
  if (replay.version != version()) {
    config.note = path + ": was painted by version " + oneLine(replay.version) + ", this is " +
                  version() + "; frames may differ";
  }
  return config;
}

}  // namespace

Config readConfig(const std::string& path, const std::vector<Spec>& table) {
  const std::string text = configTextOf(path);
  Config config = isManifest(text) ? configOfManifest(path, table) : configOf(path, text, table);
  requireOnce(config.entries);
  return config;
}

}  // namespace fluidymation::cli
