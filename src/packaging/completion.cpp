#include "packaging/completion.h"

#include "packaging/option_list.h"

namespace fluidymation::packaging {
namespace {

[[nodiscard]] std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// A branch of bash's `case` for options of one kind; empty where there are none.
[[nodiscard]] std::string bashBranch(const std::vector<cli::Spec>& options, ValueKind kind,
                                     const std::string& action) {
  std::string names;
  for (const cli::Spec& option : options) {
    if (valueKind(option) == kind) names += (names.empty() ? "" : " | ") + option.name;
  }
  return names.empty() ? "" : "    " + names + ")\n" + action + "      return\n      ;;\n";
}

/// Within single quotes of zsh, where brackets and colons mean something to _arguments.
[[nodiscard]] std::string zshText(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

[[nodiscard]] std::string zshValue(const cli::Spec& option) {
  const std::string name = ":" + zshText(option.valueName) + ":";
  switch (valueKind(option)) {
    case ValueKind::kNone:
      return "";
    case ValueKind::kWord:
      return name + "(" + joined(option.words) + ")";
    case ValueKind::kFile:
      return name + "_files";
    case ValueKind::kFolder:
      return name + "_files -/";
    case ValueKind::kOther:
      break;
  }
  return name + " ";
}

}  // namespace

std::string bashCompletion(const std::vector<cli::Spec>& options,
                           const std::vector<std::string>& commands) {
  std::string words;
  std::string names;
  for (const cli::Spec& option : options) {
    names += (names.empty() ? "" : " ") + option.name;
    if (valueKind(option) != ValueKind::kWord) continue;
    words += "    " + option.name + ")\n      COMPREPLY=($(compgen -W '" + joined(option.words) +
             "' -- \"$current\"))\n      return\n      ;;\n";
  }
  return "# Completion of fluidymation's commands and options, for bash.\n"
         "# shellcheck shell=bash disable=SC2207\n"
         "_fluidymation() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD-1]:-}\n"
         "  # bash takes --option=value for three words\n"
         "  if [[ $current == '=' ]]; then\n"
         "    current=\n"
         "  elif [[ $option == '=' ]]; then\n"
         "    option=${COMP_WORDS[COMP_CWORD-2]}\n"
         "  fi\n"
         "  COMPREPLY=()\n"
         "  case $option in\n" +
         words +
         bashBranch(options, ValueKind::kFile,
                    "      compopt -o filenames 2>/dev/null\n"
                    "      COMPREPLY=($(compgen -f -- \"$current\"))\n") +
         bashBranch(options, ValueKind::kFolder,
                    "      compopt -o filenames 2>/dev/null\n"
                    "      COMPREPLY=($(compgen -d -- \"$current\"))\n") +
         bashBranch(options, ValueKind::kOther, "") +
         "    layers)\n"
         "      if [[ $current != -* ]]; then\n"
         "        compopt -o filenames 2>/dev/null\n"
         "        COMPREPLY=($(compgen -f -- \"$current\"))\n"
         "        return\n"
         "      fi\n"
         "      ;;\n"
         "  esac\n"
         "  local names='" +
         names +
         "'\n"
         "  if [[ $COMP_CWORD -eq 1 ]]; then names=\"" +
         joined(commands) +
         " $names\"; fi\n"
         "  COMPREPLY=($(compgen -W \"$names\" -- \"$current\"))\n"
         "}\n"
         "complete -F _fluidymation fluidymation\n";
}

std::string zshCompletion(const std::vector<cli::Spec>& options,
                          const std::vector<std::string>& commands) {
  std::string arguments = " \\\n  '1::command:(" + joined(commands) + ")' \\\n  '2::file:_files'";
  for (const cli::Spec& option : options) {
    arguments += " \\\n  '" + option.name + (option.valueName.empty() ? "" : "=") + "[" +
                 zshText(shortHelp(option)) + "]" + zshValue(option) + "'";
  }
  return "#compdef fluidymation\n"
         "# Completion of fluidymation's commands and options, for zsh.\n"
         "_arguments" +
         arguments + "\n";
}

}  // namespace fluidymation::packaging
