// Where the real program writes, and what it leaves where it cannot.

#include <gtest/gtest.h>

#include <filesystem>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

TEST(EndToEndOutput, OlderFramesAreReplacedWhereThatIsWanted) {
  const SmallScene scene;
  const SmallScene::Painting expected = scene.painting();
  for (const std::string& name : kFourFrames) scene.write("out/" + name, bytesOf("older"));
  scene.write("out/00005.png", bytesOf("not ours"));
  EXPECT_EQ(scene.paint({{"--overwrite", ""}}).exitCode, 0);
  SmallScene::Painting after = filesOf(scene.file("out"));
  EXPECT_TRUE(after["00005.png"] == bytesOf("not ours"));
  after.erase("00005.png");
  EXPECT_TRUE(after == expected);
}

TEST(EndToEndOutput, FoldersAreCreated) {
  const SmallScene scene;
  const SmallScene::Painting expected = scene.painting();
  ASSERT_EQ(scene.names("out"), kFourFrames);
  EXPECT_EQ(scene.paint({{"--out-path", "a/b c/d/%05d.png"}}).exitCode, 0);
  EXPECT_TRUE(filesOf(scene.file("a/b c/d")) == expected);
  EXPECT_EQ(scene.paint({{"--out-path", "here%05d.png"}}).exitCode, 0);
  EXPECT_TRUE(readBytes(scene.file("here00003.png")) == expected.at("00003.png"));
}

TEST(EndToEndOutput, SaysWhyAFolderCannotBeCreated) {
  const SmallScene scene;
  scene.write("occupied", bytesOf("a file"));
  EXPECT_TRUE(failedWith(1, "occupied/deep: the folder cannot be created (Not a directory)",
                         scene.paint(quietly({{"--out-path", "occupied/deep/%05d.png"}}))));
  EXPECT_TRUE(failedNaming(1, "occupied: the folder cannot be created (", {},
                           scene.paint(quietly({{"--out-path", "occupied/%05d.png"}}))));
  EXPECT_TRUE(scene.read("occupied") == bytesOf("a file"));
  // Neither that of the dump; and before a frame is painted.
  EXPECT_TRUE(failedWith(1, "occupied/source: the folder cannot be created (Not a directory)",
                         scene.paint(quietly({{"--dump-guides", "occupied"}}))));
  EXPECT_EQ(scene.names("out"), kNothing);
}

TEST(EndToEndOutput, SaysWhyAFolderCannotBeWritten) {
  const SmallScene scene;
  if (fs::is_directory("/proc/self")) {  // where not even root can create a file
    EXPECT_TRUE(failedNaming(1, "/proc/self: files cannot be created in this folder (", {},
                             scene.paint(quietly({{"--out-path", "/proc/self/%05d.png"}}))));
  }
  const auto readOnly = fs::perms::owner_read | fs::perms::owner_exec;
  fs::create_directories(scene.file("shut"));
  fs::permissions(scene.file("shut"), readOnly);
  const ProcessResult within = scene.paintUnprivileged(quietly({{"--out-path", "shut/%05d.png"}}));
  const ProcessResult below = scene.paintUnprivileged(quietly({{"--out-path", "shut/a/%05d.png"}}));
  const ProcessResult dump = scene.paintUnprivileged(quietly({{"--dump-guides", "shut/dump"}}));
  fs::permissions(scene.file("shut"), fs::perms::owner_all);
  EXPECT_TRUE(
      failedWith(1, "shut: files cannot be created in this folder (Permission denied)", within));
  EXPECT_TRUE(failedWith(1, "shut/a: the folder cannot be created (Permission denied)", below));
  EXPECT_TRUE(failedNaming(1, "shut/dump/source: the folder cannot be created (", {}, dump));
  EXPECT_EQ(scene.names("shut"), kNothing);
  EXPECT_EQ(scene.names("out"), kNothing);
}

TEST(EndToEndOutput, ChecksEveryFramesNameBeforeTheFirstIsPainted) {
  const SmallScene scene;
  fs::create_directories(scene.file("out/00004.png"));
  EXPECT_TRUE(
      failedWith(1, "out/00004.png: cannot be written (it is a folder)", scene.paint(quietly({}))));
  EXPECT_EQ(scene.names("out"), std::vector<std::string>{"00004.png"});
  const std::string longName = std::string(252, 'n') + "%d.png";
  EXPECT_TRUE(failedNaming(1, "wide/" + std::string(252, 'n') + "1.png: cannot be written (",
                           {"File name too long"},
                           scene.paint(quietly({{"--out-path", "wide/" + longName}}))));
  EXPECT_EQ(scene.names("wide"), kNothing);
}

TEST(EndToEndOutput, ChecksTheDumpsNamesBeforeTheFirstFrameIsPainted) {
  const SmallScene scene;
  fs::create_directories(scene.file("dump/target/00003.mask.png"));
  EXPECT_TRUE(failedWith(1, "dump/target/00003.mask.png: cannot be written (it is a folder)",
                         scene.paint(quietly({{"--dump-guides", "dump"}}))));
  EXPECT_EQ(scene.names("out"), kNothing);
  EXPECT_EQ(scene.names("dump"), std::vector<std::string>{"target"});
}

TEST(EndToEndOutput, TheDumpsOfExemplarAndTargetDoNotShareAFolder) {
  const SmallScene scene;
  fs::create_directories(scene.file("dump/target"));
  fs::create_directory_symlink("target", scene.file("dump/source"));
  EXPECT_TRUE(failedWith(2,
                         "--dump-guides dump: dump/source and dump/target are one folder; choose "
                         "another folder",
                         scene.paint(quietly({{"--dump-guides", "dump"}}))));
  EXPECT_EQ(scene.names("out"), kNothing);
}

TEST(EndToEndOutput, AFullDiskLeavesWholeFramesOnly) {
  const SmallScene scene;
  // An empty frame packs into less than a hundred bytes, a painted one does not.
  scene.write("target/00001.png", maskPng(Mask(Size{28, 22})));
  scene.write("target/00002.png", maskPng(Mask(Size{28, 22})));
  const SmallScene::Painting expected = scene.painting();
  scene.remove("out");
  scene.write("out/00003.png", bytesOf("older"));
  ProcessSetup setup;
  setup.largestFileBytes = 300;
  EXPECT_TRUE(failedWith(1, "out/00003.png: cannot be written (File too large)",
                         scene.paint(quietly({{"--overwrite", ""}}), setup)));
  const SmallScene::Painting left = filesOf(scene.file("out"));
  ASSERT_EQ(left.size(), 3U);
  EXPECT_TRUE(left.at("00001.png") == expected.at("00001.png"));
  EXPECT_TRUE(left.at("00002.png") == expected.at("00002.png"));
  EXPECT_TRUE(left.at("00003.png") == bytesOf("older"));
}

TEST(EndToEndOutput, AFullDiskEndsTheDumpWithoutHalfFiles) {
  const SmallScene scene;
  ProcessSetup setup;
  setup.largestFileBytes = 300;
  EXPECT_TRUE(failedNaming(1, "dump/source/00001.", {": cannot be written (File too large)"},
                           scene.paint(quietly({{"--dump-guides", "dump"}}), setup)));
  EXPECT_EQ(scene.names("out"), kNothing);
  for (const std::string& name : scene.names("dump/source")) {
    EXPECT_NE(name[0], '.') << name;
    EXPECT_FALSE(scene.read("dump/source/" + name).empty()) << name;
  }
}

}  // namespace
}  // namespace fluidymation::test
