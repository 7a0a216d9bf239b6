#include "cli/layered_config.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "cli/config_lines.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kWantedSection =
    "; wanted [layer.NAME], a name of letters, digits, - and _, at most 64";
constexpr std::size_t kLongestName = 64;
constexpr const char* kBackground = "--background";

[[nodiscard]] bool isPreview(const std::string& option) {
  return option.compare(0, 9, "--preview") == 0;
}

/// What there is one of in a shot, however many layers.
const std::set<std::string> kOfTheShot = {"--out-path", kBackground, "--progress", "--quiet"};
/// What layers must not share.
const std::set<std::string> kOfALayer = {"--dump-guides"};

/// @throws UsageError where an option stands in the wrong part of the file.
void requirePart(const ConfigEntry& entry, bool inLayer) {
  const std::string key = entry.place + ": " + entry.option.substr(2);
  if (isPreview(entry.option)) {
    throw UsageError(key +
                     ": layers have no preview; wanted it of the painted frames, by "
                     "fluidymation preview");
  }
  if (inLayer && kOfTheShot.count(entry.option) > 0) {
    throw UsageError(key + ": is of the whole shot; wanted above the first layer");
  }
  if (!inLayer && kOfALayer.count(entry.option) > 0) {
    throw UsageError(key + ": layers cannot share it; wanted in a layer");
  }
}

/// "horse" of "[layer.horse]". @throws UsageError naming the line.
[[nodiscard]] std::string layerName(const ConfigLine& line) {
  constexpr std::string_view kBegin = "[layer.";
  constexpr const char* kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  const std::string& text = line.text;
  if (text.compare(0, kBegin.size(), kBegin) == 0 && text.back() == ']') {
    std::string name = text.substr(kBegin.size(), text.size() - kBegin.size() - 1);
    if (!name.empty() && name.size() <= kLongestName &&
        name.find_first_not_of(kLetters) == std::string::npos) {
      return name;
    }
  }
  throw UsageError(line.place + ": " + shown("no layer is named by", text) + kWantedSection);
}

/// Takes the background out of the entries: those are for the layers' own runs.
/// @throws UsageError naming the line where it is empty.
[[nodiscard]] std::optional<std::string> takeBackground(std::vector<ConfigEntry>& entries) {
  const auto found = std::find_if(entries.begin(), entries.end(), [](const ConfigEntry& entry) {
    return entry.option == kBackground;
  });
  if (found == entries.end()) return std::nullopt;
  if (found->value.empty()) {
    throw UsageError(found->place + ": " + shown(kBackground, found->value) +
                     ": wanted a colour, a file, exemplar or exemplar:NAME");
  }
  std::string background = found->value;
  entries.erase(found);
  return background;
}

}  // namespace

LayeredConfig readLayeredConfig(const std::string& path, const std::vector<Spec>& table) {
  LayeredConfig config;
  for (const ConfigLine& line : configLines(path, configTextOf(path))) {
    if (line.text.front() != '[') {
      const bool inLayer = !config.layers.empty();
      ConfigEntry entry = entryOf(line, table);
      requirePart(entry, inLayer);
      (inLayer ? config.layers.back().entries : config.entries).push_back(std::move(entry));
      continue;
    }
    std::string name = layerName(line);
    for (const LayeredConfig::Section& other : config.layers) {
      if (other.name != name) continue;
      throw UsageError(line.place + ": layer " + name + ": is there before, see " + other.place +
                       "; wanted another name");
    }
    config.layers.push_back({std::move(name), line.place, {}});
  }
  if (config.layers.empty()) {
    throw UsageError(path + ": there is no layer" + kWantedSection);
  }
  requireOnce(config.entries);
  config.background = takeBackground(config.entries);
  for (const LayeredConfig::Section& layer : config.layers) requireOnce(layer.entries);
  return config;
}

}  // namespace fluidymation::cli
