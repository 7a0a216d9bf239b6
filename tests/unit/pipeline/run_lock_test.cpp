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

/// Whether a run that ends as `finish` has it leaves the hidden folder of a run before, empty but
/// for the lock, where it was.
template <typename Finish>
bool leavesFoundFolder(const Finish& finish) {
  const test::TemporaryFolder folder;
  const RunFiles files(FramePattern(folder.file("%d.png")));
  std::filesystem::create_directory(files.hiddenFolder());
  {
    RunLock lock(files);
    lock.takeIfUsed();
    finish(lock);
  }
  return std::filesystem::exists(files.hiddenFolder());
}

TEST(RunLockTest, LeavesWhatARunBeforeHasLeftUntilAllIsPainted) {
  // A run that is refused, one that ends before it paints, one that is stopped, one that paints all
  EXPECT_TRUE(leavesFoundFolder([](RunLock& /*lock*/) {}));
  EXPECT_TRUE(leavesFoundFolder([](RunLock& lock) { (void)lock.take(); }));
  EXPECT_TRUE(leavesFoundFolder([](RunLock& lock) {
    (void)lock.take();
    lock.setUnfinished(true);
  }));
  EXPECT_FALSE(leavesFoundFolder([](RunLock& lock) {
    (void)lock.take();
    lock.setUnfinished(true);
    lock.setUnfinished(false);
  }));
}

TEST(RunLockTest, RemovesAFolderThatItMadeUnlessFramesAreUnfinished) {
  const test::TemporaryFolder folder;
  const RunFiles files(FramePattern(folder.file("%d.png")));
  for (const bool unfinished : {false, true}) {
    {
      RunLock lock(files);
      lock.takeIfUsed();
      (void)lock.take();
      if (unfinished) lock.setUnfinished(true);
    }
    EXPECT_EQ(std::filesystem::exists(files.hiddenFolder()), unfinished);
  }
}

}  // namespace
}  // namespace fluidymation
