#include "packaging/option_list.h"

#include <algorithm>

#include "cli/subcommand.h"

namespace fluidymation::packaging {

std::vector<cli::Spec> allOptions() {
  std::vector<cli::Spec> options = cli::optionTable();
  options.push_back({"--help", cli::kRunningGroup, "", "print this text", false, {}});
  options.push_back({"--version", cli::kRunningGroup, "", "print the version", false, {}});
  return options;
}

std::vector<std::string> allCommands() {
  std::vector<std::string> names;
  for (const cli::Subcommand& command : cli::subcommands()) names.push_back(command.name);
  return names;
}

ValueKind valueKind(const cli::Spec& spec) {
  if (spec.valueName.empty()) return ValueKind::kNone;
  if (!spec.words.empty()) return ValueKind::kWord;
  if (spec.valueName == "DIR") return ValueKind::kFolder;
  for (const char* file : {"PATTERN", "MANIFEST", "FILE"}) {
    if (spec.valueName == file) return ValueKind::kFile;
  }
  return ValueKind::kOther;
}

std::string shortHelp(const cli::Spec& spec) {
  std::string text = spec.help.substr(0, spec.help.find("\n(default"));
  text = text.substr(0, text.find("\n(required"));
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace fluidymation::packaging
