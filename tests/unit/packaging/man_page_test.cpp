#include "packaging/man_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/command_line.h"
#include "cli/painter_syntax.h"
#include "packaging/option_list.h"

namespace fluidymation::packaging {
namespace {

std::string withoutEscapes(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '\\'), text.end());
  return text;
}

TEST(ManPage, HasEveryOptionThatHelpNames) {
  const char* const argv[] = {"fluidymation", "--help"};
  std::istringstream help(
      cli::parseCommandLine(cli::painterSyntax(), 2, argv).information.value_or(""));
  const std::string page = withoutEscapes(manPageOptions(allOptions()));
  int options = 0;
  for (std::string line; std::getline(help, line);) {
    const std::size_t name = line.find("--");
    if (line.compare(0, 2, "  ") != 0 || name > 5) continue;  // "  --name" or "  -h,--help"
    ++options;
    const std::string option = line.substr(name, line.find(' ', name) - name);
    EXPECT_NE(page.find("fB" + option + "fR"), std::string::npos) << option;
  }
  EXPECT_EQ(options, static_cast<int>(allOptions().size()));
}

TEST(ManPage, PutsAGroupsOptionsBelowItsName) {
  const std::vector<cli::Spec> options = {
      {"--a-b", "First", "N", "what it\nis\n(default 1;\nin [0, 2])", false, {}},
      {"--c", "First", "", "a flag", false, {}},
      {"--d", "Second", "", "another", false, {}}};
  EXPECT_EQ(manPageOptions(options),
            ".SS First\n"
            ".TP\n\\fB\\-\\-a\\-b\\fR \\fIN\\fR\nwhat it\nis\n.br\n(default 1;\nin [0, 2])\n"
            ".TP\n\\fB\\-\\-c\\fR\na flag\n"
            ".SS Second\n"
            ".TP\n\\fB\\-\\-d\\fR\nanother\n");
}

TEST(ManPage, SaysWhatEachCommandDoes) {
  EXPECT_EQ(manPageCommands({{"a-b", "does it", nullptr}, {"c", "does more", nullptr}}),
            ".TP\n\\fBfluidymation a\\-b\\fR\ndoes it\n"
            ".TP\n\\fBfluidymation c\\fR\ndoes more\n");
}

TEST(ManPage, NoTextIsTakenForAnInstruction) {
  EXPECT_EQ(roffText(".flo or\\n -1"), "\\&.flo or\\en \\-1");
  EXPECT_EQ(roffText("'x'"), "\\&'x'");
  EXPECT_EQ(roffText(""), "");
}

}  // namespace
}  // namespace fluidymation::packaging
