#include "packaging/man_page.h"

#include <algorithm>

namespace fluidymation::packaging {
namespace {

/// Help puts default, range and source in brackets at its end, on lines of their own; here they
/// begin one, and the rest is filled.
[[nodiscard]] std::string paragraphs(const std::string& help) {
  std::string result;
  std::size_t begin = 0;
  while (begin <= help.size()) {
    const std::size_t end = std::min(help.find('\n', begin), help.size());
    const std::string line = help.substr(begin, end - begin);
    if (!line.empty() && line.front() == '(' && !result.empty()) result += ".br\n";
    result += roffText(line) + "\n";
    begin = end + 1;
  }
  return result;
}

}  // namespace

std::string roffText(const std::string& text) {
  // \& is no character, and keeps the next one from being a request at the beginning of a line.
  std::string result;
  if (!text.empty() && (text.front() == '.' || text.front() == '\'')) result = "\\&";
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string manPageCommands(const std::vector<cli::Subcommand>& commands) {
  std::string page;
  for (const cli::Subcommand& command : commands) {
    page += ".TP\n\\fBfluidymation " + roffText(command.name) + "\\fR\n" +
            roffText(command.summary) + "\n";
  }
  return page;
}

std::string manPageOptions(const std::vector<cli::Spec>& options) {
  std::string page;
  std::string group;
  for (const cli::Spec& option : options) {
    if (option.group != group) page += ".SS " + roffText(option.group) + "\n";
    group = option.group;
    page += ".TP\n\\fB" + roffText(option.name) + "\\fR";
    if (!option.valueName.empty()) page += " \\fI" + roffText(option.valueName) + "\\fR";
    page += "\n" + paragraphs(option.help);
  }
  return page;
}

}  // namespace fluidymation::packaging
