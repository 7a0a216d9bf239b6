#include "cli/resume_command.h"

#include <gtest/gtest.h>

#include <vector>

namespace fluidymation::cli {
namespace {

std::string commandAfter(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "build/fluidymation");
  return resumeCommand(static_cast<int>(arguments.size()), arguments.data());
}

TEST(ResumeCommand, IsTheCommandWithResume) {
  EXPECT_EQ(commandAfter({"--out-path", "out/%05d.png"}),
            "build/fluidymation --out-path out/%05d.png --resume");
  EXPECT_EQ(commandAfter({"--resume", "--seed", "1"}), "build/fluidymation --resume --seed 1");
  EXPECT_EQ(commandAfter({"--restart", "--seed", "1"}), "build/fluidymation --seed 1 --resume");
}

TEST(ResumeCommand, QuotesWhatAShellWouldTakeApart) {
  EXPECT_EQ(commandAfter({"--out-path", "my film/%d.png", "", "it's", "$HOME", "a;b"}),
            "build/fluidymation --out-path 'my film/%d.png' '' 'it'\\''s' '$HOME' 'a;b' --resume");
}

TEST(ResumeCommand, KeepsWhatGoesOnByItself) {
  EXPECT_EQ(commandAfter({"--skip-existing"}), "build/fluidymation --skip-existing");
}

}  // namespace
}  // namespace fluidymation::cli
