// What the scripts do in a shell is tested by tests/scripts/completion_test.sh.

#include "packaging/completion.h"

#include <gtest/gtest.h>

#include "cli/option_table.h"
#include "fluidymation/core/error.h"
#include "packaging/option_list.h"

namespace fluidymation::packaging {
namespace {

TEST(Completion, OffersEveryOption) {
  const std::string bash = bashCompletion(allOptions(), allCommands());
  const std::string zsh = zshCompletion(allOptions(), allCommands());
  for (const cli::Spec& option : allOptions()) {
    EXPECT_NE(bash.find(option.name), std::string::npos) << option.name;
    EXPECT_NE(zsh.find("'" + option.name + (option.valueName.empty() ? "[" : "=[")),
              std::string::npos)
        << option.name;
  }
}

TEST(Completion, OffersEveryCommand) {
  const std::string commands = "inspect layers mask preview";
  EXPECT_NE(bashCompletion(allOptions(), allCommands()).find(commands), std::string::npos);
  EXPECT_NE(zshCompletion(allOptions(), allCommands()).find("(" + commands + ")"),
            std::string::npos);
}

TEST(Completion, EveryWordThatIsOfferedIsTaken) {
  int words = 0;
  for (const cli::Spec& option : cli::optionTable()) {
    cli::CommandLine line;
    for (const std::string& word : option.words) {
      EXPECT_NO_THROW(option.apply(line, word)) << option.name << " " << word;
      ++words;
    }
    if (!option.words.empty()) {
      EXPECT_THROW(option.apply(line, "nonsense"), UsageError) << option.name;
    }
    EXPECT_EQ(option.words.empty(), option.valueName != "NAME") << option.name;
  }
  EXPECT_GT(words, 20);
}

TEST(Completion, ZshTakesNoTextForAnInstruction) {
  const std::vector<cli::Spec> options = {
      {"--a", "G", "N", "it's a: [b]\nand more\n(default 1)", false, {}}};
  EXPECT_NE(zshCompletion(options, {}).find("'--a=[it'\\''s a\\: \\[b\\] and more]:N: '"),
            std::string::npos)
      << zshCompletion(options, {});
}

}  // namespace
}  // namespace fluidymation::packaging
