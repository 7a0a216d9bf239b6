#include "cli/config_lines.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <string_view>

#include "cli/config_source.h"
#include "cli/nearest.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kBlanks = " \t\r";

[[nodiscard]] std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Without what a `#` outside of quotes begins. CLI11 2.1 cuts within quotes, too.
[[nodiscard]] std::string withoutComment(const std::string& line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      return line.substr(0, i);
    }
  }
  return line;
}

[[nodiscard]] std::string keyOf(const std::string& option) { return option.substr(2); }

/// Names that a file may hold, without their hyphens.
[[nodiscard]] std::vector<std::string> keysOf(const std::vector<Spec>& table) {
  std::vector<std::string> keys;
  for (const Spec& spec : table) {
    if (spec.text) keys.push_back(keyOf(spec.name));
  }
  return keys;
}

/// The options of one line, at most one. Takes CLI11 for the values: quotes, lists.
[[nodiscard]] std::vector<CLI::ConfigItem> itemsOf(const std::string& line) {
  CLI::ConfigTOML reader;
  reader.comment('\0');
  std::istringstream stream(line);
  return reader.from_config(stream);
}

/// "4,3,2" of [4, 3, 2]: as the command line takes lists.
[[nodiscard]] std::string joined(const std::vector<std::string>& inputs) {
  std::string text;
  for (std::size_t i = 0; i < inputs.size(); ++i) text += (i == 0 ? "" : ",") + inputs[i];
  return text;
}

}  // namespace

std::string configTextOf(const std::string& path) {
  std::string text = configSource(path);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors begin files with it
  if (text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) {
    text.erase(0, kByteOrderMark.size());
  }
  return text;
}

std::vector<ConfigLine> configLines(const std::string& path, const std::string& text) {
  std::vector<ConfigLine> lines;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::string place = path + ": line " + std::to_string(number);
    line = trimmed(withoutComment(line));
    if (line.empty()) continue;
    if (std::any_of(line.begin(), line.end(),
                    [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; })) {
      throw UsageError(place + ": holds a control character; wanted a text file");
    }
    lines.push_back({line, place});
  }
  return lines;
}

void requireKey(const std::string& key, const std::string& place, const std::vector<Spec>& table) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Spec& spec) { return spec.name == "--" + key; });
  if (found == table.end()) {
    const std::string likely = nearest(key, keysOf(table));
    throw UsageError(place + ": " + oneLine(key) + ": there is no such option" +
                     (likely.empty() ? "; see --help" : "; did you mean " + likely + "?"));
  }
  if (!found->text) {
    throw UsageError(place + ": " + key + ": is for the command line, not for a config file");
  }
}

ConfigEntry entryOf(const ConfigLine& from, const std::vector<Spec>& table) {
  const auto& [line, place] = from;
  constexpr const char* kWanted = "; wanted a line such as border-width = 12";
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) {
    throw UsageError(place + ": " + shown("no option is given by", line) + kWanted);
  }
  const std::string key = trimmed(line.substr(0, equals));
  const std::string value = trimmed(line.substr(equals + 1));
  requireKey(key, place, table);
  const bool openList = value.size() > 1 && value.front() == '[' && value.back() != ']';
  if (value.empty() || openList) {
    throw UsageError(place + ": " + key + ": the value is missing or goes on in the next line" +
                     kWanted);
  }
  const std::vector<CLI::ConfigItem> items = itemsOf(key + " = " + value);
  if (items.size() != 1 || !items.front().parents.empty()) {
    throw UsageError(place + ": " + key + ": cannot be read" + kWanted);
  }
  const std::vector<std::string>& inputs = items.front().inputs;
  const bool isList = value.front() == '[' || value.find(',') != std::string::npos;
  if (inputs.size() > 1 && !isList) {
    throw UsageError(place + ": " + shown(key, value) + ": wanted one value, in quotes where " +
                     "it has blanks");
  }
  return {"--" + key, joined(inputs), place};
}

void requireOnce(const std::vector<ConfigEntry>& entries) {
  std::set<std::string> seen;
  for (const ConfigEntry& entry : entries) {
    if (seen.insert(entry.option).second) continue;
    throw UsageError(entry.place + ": " + keyOf(entry.option) + ": is given before; wanted once");
  }
}

}  // namespace fluidymation::cli
