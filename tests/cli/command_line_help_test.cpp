// What --help and --version say, and that the README says the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "cli/command_line_arguments.h"
#include "support/temporary_folder.h"

namespace fluidymation::cli {
namespace {

TEST(CommandLine, HelpNamesEveryOptionWithDefaultAndRange) {
  const std::string help = parse({"--help"}).information.value_or("");
  for (const Reaching& o : reachingOptions()) {
    EXPECT_NE(help.find("  " + std::string(o.option) + " "), std::string::npos) << o.option;
  }
  for (const char* text : {"--src-path PATTERN",
                           "--src-mask-path PATTERN",
                           "--target-path PATTERN",
                           "--out-path PATTERN",
                           "--quiet",
                           "--version",
                           "--help",
                           "Inputs and outputs:",
                           "Sequences:",
                           "Masks and motion:",
                           "Guides:",
                           "Synthesis:",
                           "Running:",
                           "(default 0.0125 times the square root of their mean area;",
                           "in [0, 1000] px; thesis §4.1: 8)",
                           "(default 0.3; in (0, 0.5]",
                           "(default 0.75; in (0, 0.99]",
                           "(default 1 and 0.2 times the border width;",
                           "(default 6,4;",
                           "(default 4,3,2;",
                           "(default 50 frames; in [1, 1000000]",
                           "(default 0.1;",
                           "(default that of --blur-sigma if given, else by its own masks;",
                           "OMP_NUM_THREADS",
                           "SLURM_CPUS_PER_TASK",
                           "thesis §3.7"}) {
    EXPECT_NE(help.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(help.find("\n\n\n"), std::string::npos);
}

TEST(CommandLine, NoLineOfTheHelpIsLongerThan100Characters) {
  std::istringstream help(parse({"--help"}).information.value_or(""));
  for (std::string line; std::getline(help, line);) {
    const auto characters = std::count_if(line.begin(), line.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // what continues one in UTF-8
    });
    EXPECT_LE(characters, 100) << line;
  }
}

/// From `begin` on up to the next `end`; all of it where one is not found.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t first = text.find(begin);
  return text.substr(first, text.find(end, first) - first);
}

TEST(CommandLine, TheReadmeListsTheOptionsAsHelpDoes) {
  const std::string firstGroup = "Inputs and outputs:\n";
  const std::string help = parse({"--help"}).information.value_or("");
  ASSERT_NE(help.find(firstGroup), std::string::npos);
  const test::Bytes bytes = test::readBytes(FLUIDYMATION_README);
  const std::string readme(bytes.begin(), bytes.end());
  ASSERT_NE(readme.find(firstGroup), std::string::npos);
  std::string options = help.substr(help.find(firstGroup));
  options.erase(options.find_last_not_of('\n') + 1);
  EXPECT_EQ(between(readme, firstGroup, "\n```"), options);
}

TEST(CommandLine, HelpAndVersionNeedNothingElse) {
  EXPECT_EQ(parse({"--version"}).information, "fluidymation " FLUIDYMATION_VERSION "\n");
  EXPECT_TRUE(parse({"--seed", "5", "--help"}).information);
  EXPECT_EQ(parse({"-h"}).information, parse({"--help"}).information);
  EXPECT_FALSE(parse(kRequired).information);
}

}  // namespace
}  // namespace fluidymation::cli
