#include "pipeline/run_lock.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

TEST(RunLockTest, RefusesStatesThatAnotherRunHasLeftMeanwhile) {
  const test::TemporaryFolder folder;
  const RunFiles files(FramePattern(folder.file("%d.png")));
  RunLock lock(files);
  lock.takeIfUsed();
  std::filesystem::create_directory(files.hiddenFolder());
  test::writeBytes(files.state(3), {1});
  EXPECT_EQ(test::messageOf<Error>([&] { (void)lock.take(); }),
            files.hiddenFolder() +
                ": another run has left a state while this one began; wanted another try");
  EXPECT_TRUE(std::filesystem::exists(files.state(3)));
}

TEST(RunLockTest, TakesStatesThatWereThereBefore) {
  const test::TemporaryFolder folder;
  const RunFiles files(FramePattern(folder.file("%d.png")));
  std::filesystem::create_directory(files.hiddenFolder());
  test::writeBytes(files.state(3), {1});
  RunLock lock(files);
  lock.takeIfUsed();
  EXPECT_EQ(lock.take(), "");
  EXPECT_TRUE(std::filesystem::exists(files.lock()));
}

}  // namespace
}  // namespace fluidymation
