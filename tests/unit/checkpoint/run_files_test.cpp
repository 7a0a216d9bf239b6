#include "checkpoint/run_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

TEST(RunFilesTest, PatternsThatShareAFolderStayApart) {
  const RunFiles plain(FramePattern("out/%05d.png"));
  EXPECT_EQ(plain.manifest(), "out/fluidymation.json");
  EXPECT_EQ(plain.lock(), "out/.fluidymation/lock");
  EXPECT_EQ(plain.times(), "out/.fluidymation/times.json");
  EXPECT_EQ(plain.state(-3), "out/.fluidymation/state--3.bin");
  const RunFiles rim(FramePattern("out/50%%_%d_rim.PNG"));
  EXPECT_EQ(rim.manifest(), "out/50%__rimfluidymation.json");
  EXPECT_EQ(rim.state(12), "out/.fluidymation/50%__rimstate-12.bin");
  EXPECT_EQ(RunFiles(FramePattern("%d.png")).lock(), "./.fluidymation/lock");
}

TEST(RunFilesTest, KnowsItsOwnNamesOnly) {
  const RunFiles files(FramePattern("out/a%05d.png"));
  EXPECT_TRUE(files.isFrameOrManifest("a00012.png"));
  EXPECT_TRUE(files.isFrameOrManifest("afluidymation.json"));
  EXPECT_FALSE(files.isFrameOrManifest("fluidymation.json"));
  EXPECT_FALSE(files.isFrameOrManifest("b00012.png"));
  EXPECT_TRUE(files.isHidden("astate-7.bin"));
  EXPECT_TRUE(files.isHidden("atimes.json"));
  EXPECT_TRUE(files.isHidden("areplaceable.txt"));
  EXPECT_FALSE(files.isHidden("state-7.bin"));
}

TEST(RunFilesTest, FindsItsStates) {
  const test::TemporaryFolder folder;
  const RunFiles files(FramePattern(folder.file("a%d.png")));
  EXPECT_TRUE(files.states().empty());
  std::filesystem::create_directory(files.hiddenFolder());
  for (const int number : {-1, 7, 12}) test::writeBytes(files.state(number), {1});
  test::writeBytes(RunFiles(FramePattern(folder.file("b%d.png"))).state(3), {1});
  test::writeBytes(files.times(), {1});
  EXPECT_EQ(files.states(),
            (std::map<int, std::string>{
                {-1, files.state(-1)}, {7, files.state(7)}, {12, files.state(12)}}));
}

}  // namespace
}  // namespace fluidymation
