#include <optional>
#include <string>

#include "cli/config_file.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/version.h"

namespace fluidymation::cli {
namespace {

/// As CLI11 reads it back: numbers and flags as they are, all else in quotes, which know no escape.
[[nodiscard]] std::string quoted(const std::string& option, const std::string& text) {
  constexpr const char* kNumeric = "0123456789.-+e";
  const bool plain = text == "true" || text == "false" ||
                     (!text.empty() && text.find_first_not_of(kNumeric) == std::string::npos &&
                      text.find_first_of("0123456789") != std::string::npos);
  if (plain) return text;
  const bool hasDouble = text.find_first_of("\"\\") != std::string::npos;
  const bool hasSingle = text.find('\'') != std::string::npos;
  if ((hasDouble && hasSingle) || oneLine(text) != text) {
    throw UsageError(shown(option, text) +
                     ": no config file can hold a control character, or both kinds of quotes; "
                     "wanted another name");
  }
  return hasDouble ? "'" + text + "'" : '"' + text + '"';
}

/// Why an option that has no value now is left out.
[[nodiscard]] std::string absent(const Spec& spec, const CommandLine& line) {
  if (spec.required) return "required";
  if (spec.name == "--threads") return std::to_string(line.options.threads) + ", by the machine";
  return "not set";
}

}  // namespace

std::string configText(const std::vector<Spec>& table, const CommandLine& line) {
  std::string text = "# Options of fluidymation " + version() + ", for --config.\n" +
                     "# \"auto\", \"size\": found from the inputs when a run begins.\n"
                     "# All values are written out: another preset here changes only those whose "
                     "lines are taken out.\n";
  std::string group;
  for (const Spec& spec : table) {
    if (!spec.text) continue;
    if (spec.group != group) text += "\n# " + spec.group + "\n";
    group = spec.group;
    const std::string key = spec.name.substr(2);
    const std::optional<std::string> value = spec.text(line);
    text += value ? key + " = " + quoted(spec.name, *value)
                  : "# " + key + " = (" + absent(spec, line) + ")";
    text += "\n";
  }
  return text;
}

}  // namespace fluidymation::cli
