#include "fluidymation/io/file_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>
#include <utility>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::messageOf;
using test::TemporaryFolder;

TEST(FileLockTest, OnlyOneHoldsItAndTheOtherIsToldWhoDoes) {
  const TemporaryFolder folder;
  std::optional<FileLock> lock(std::in_place, folder.file("lock"), "painting");
  EXPECT_TRUE(lock->isHeld());
  EXPECT_EQ(lock->abandonedBy(), "");
  const std::string refusal =
      messageOf<Error>([&] { const FileLock second(folder.file("lock"), "painting"); });
  EXPECT_EQ(
      refusal.find(folder.file("lock") + ": process " + std::to_string(getpid()) + " on host "), 0U)
      << refusal;
  EXPECT_NE(refusal.find(" is painting; wanted one run at a time"), std::string::npos);
  lock.reset();
  EXPECT_TRUE(folder.names().empty());
  EXPECT_TRUE(FileLock(folder.file("lock"), "painting").isHeld());
}

TEST(FileLockTest, IsTakenOverFromAProcessThatWasKilled) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    const FileLock lock(folder.file("lock"), "painting");
    std::raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_FALSE(folder.names().empty());
  const FileLock lock(folder.file("lock"), "painting");
  EXPECT_TRUE(lock.isHeld());
  EXPECT_EQ(lock.abandonedBy().find("process " + std::to_string(child) + " on host "), 0U);
}

TEST(FileLockTest, RepeatsNothingUnprintableAndMovesWhole) {
  const TemporaryFolder folder;
  test::writeBytes(folder.file("lock"), test::bytesOf("a\x1b[31m\xff b\n"));
  FileLock lock(folder.file("lock"), "painting");
  EXPECT_EQ(lock.abandonedBy(), "a?[31m? b");
  const FileLock taken(std::move(lock));
  EXPECT_TRUE(taken.isHeld());
  EXPECT_FALSE(lock.isHeld());  // NOLINT(bugprone-use-after-move): what is left of it is tested
}

TEST(FileLockTest, FollowsNoLink) {
  const TemporaryFolder folder;
  test::writeBytes(folder.file("precious"), test::bytesOf("precious"));
  ASSERT_EQ(symlink("precious", folder.file("lock").c_str()), 0);
  EXPECT_NE(messageOf<Error>([&] { const FileLock lock(folder.file("lock"), "painting"); }), "");
  EXPECT_EQ(test::readBytes(folder.file("precious")), test::bytesOf("precious"));
}

}  // namespace
}  // namespace fluidymation
