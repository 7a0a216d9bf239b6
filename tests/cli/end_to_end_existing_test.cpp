// What becomes of files that have the names of frames to be painted.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

const Bytes kPicture = bytesOf("somebody's own picture");

TEST(EndToEndExisting, OwnFramesAreReplacedAndOthersAreNot) {
  const SmallScene scene;
  const SmallScene::Painting first = scene.painting({{"--seed", "1"}});
  const SmallScene::Painting second = scene.painting({{"--seed", "2"}});
  EXPECT_NE(first, second);
  scene.write("out/00002.png", kPicture);
  scene.write("out/00003.png", kPicture);
  EXPECT_TRUE(failedWith(
      1,
      "out/00002.png: is there already, and not as a run that is recorded there has painted it; "
      "so is 1 more; wanted --overwrite to replace, --skip-existing to keep what is there, or "
      "another --out-path",
      scene.paint({{"--seed", "1"}, {"--quiet", ""}})));
  EXPECT_EQ(scene.read("out/00002.png"), kPicture);
  EXPECT_EQ(scene.read("out/00001.png"), second.at("00001.png"));
  EXPECT_EQ(scene.painting({{"--seed", "1"}, {"--overwrite", ""}}), first);
}

TEST(EndToEndExisting, WhatWasWorkedOnAfterTheRunIsNotReplacedByGoingOnOrRestarting) {
  const SmallScene scene;
  (void)scene.painting({});
  for (const char* option : {"--resume", "--restart"}) {
    scene.write("out/00002.png", kPicture);
    EXPECT_TRUE(failedNaming(1, "out/00002.png: is there already", {"--overwrite"},
                             scene.paint({{option, ""}, {"--quiet", ""}})))
        << option;
    EXPECT_EQ(scene.read("out/00002.png"), kPicture);
  }
}

TEST(EndToEndExisting, GoingOnReplacesNothingButWhatItPaintsItself) {
  const SmallScene scene;
  const SmallScene::Painting all = scene.painting({{"--checkpoint-every", "1"}});
  const auto painted = [&scene](const ToolOptions& more) {
    ToolOptions options = quietly(more);
    options["--checkpoint-every"] = "1";
    return scene.paint(options);
  };
  for (const ToolOptions& goingOn :
       {ToolOptions{{"--resume", ""}}, ToolOptions{{"--render-frames", "3-4"}}}) {
    SCOPED_TRACE(goingOn.begin()->first);
    scene.remove("out");
    EXPECT_EQ(painted({{"--render-frames", "1-2"}}).exitCode, 0);
    // As painted after the last state was saved, and by somebody else
    scene.write("out/00003.png", all.at("00003.png"));
    scene.write("out/00004.png", kPicture);
    EXPECT_TRUE(failedWith(1,
                           "out/00004.png: is there already, and not as this run paints it; wanted "
                           "--overwrite to replace, --skip-existing to keep what is there, or "
                           "another --out-path",
                           painted(goingOn)));
    EXPECT_EQ(scene.read("out/00004.png"), kPicture);
    EXPECT_EQ(scene.read("out/00003.png"), all.at("00003.png"));
    EXPECT_EQ(painted({{"--skip-existing", ""}}).exitCode, 0);
    EXPECT_EQ(scene.read("out/00004.png"), kPicture);
    EXPECT_EQ(painted({{"--resume", ""}, {"--overwrite", ""}}).exitCode, 0);
    EXPECT_EQ(filesOf(scene.file("out")), all);
  }
}

TEST(EndToEndExisting, APictureWithoutAManifestIsNotReplaced) {
  const SmallScene scene;
  scene.write("out/00004.png", kPicture);
  EXPECT_TRUE(failedNaming(1, "out/00004.png: is there already", {"--overwrite"},
                           scene.paint({{"--quiet", ""}})));
  EXPECT_EQ(scene.names("out"), std::vector<std::string>{"00004.png"});
  // Frames that are not wanted do not matter.
  EXPECT_EQ(scene.paint({{"--render-frames", "1-2"}, {"--quiet", ""}}).exitCode, 0);
  EXPECT_EQ(scene.read("out/00004.png"), kPicture);
}

TEST(EndToEndExisting, WhatIsThereIsKeptAndTheRestPainted) {
  const SmallScene scene;
  const SmallScene::Painting all =
      scene.painting({{"--keep-states", ""}, {"--checkpoint-every", "1"}});
  scene.write("out/00001.png", kPicture);
  scene.remove("out/00002.png");
  scene.remove("out/00004.png");
  const ProcessResult result = scene.paint({{"--skip-existing", ""}});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_NE(result.err.find("--skip-existing: 2 of 4 frames are there and kept"),
            std::string::npos);
  EXPECT_EQ(scene.read("out/00001.png"), kPicture);
  // Each from the state of the frame before it
  for (const char* name : {"00002.png", "00003.png", "00004.png"}) {
    EXPECT_EQ(scene.read(std::string("out/") + name), all.at(name)) << name;
  }
}

TEST(EndToEndExisting, NothingIsDoneWhereAllIsThereAndAllWhereNothingIs) {
  const SmallScene scene;
  const SmallScene::Painting all = scene.painting({{"--skip-existing", ""}});
  const Bytes manifest = scene.read("out/fluidymation.json");
  const ProcessResult result = scene.paint({{"--skip-existing", ""}, {"--seed", "9"}});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(filesOf(scene.file("out")), all);
  EXPECT_EQ(scene.read("out/fluidymation.json"), manifest);
  EXPECT_EQ(scene.painting({{"--overwrite", ""}}), all);
}

TEST(EndToEndExisting, KeepingGoesWithNeitherResumeNorRestart) {
  const SmallScene scene;
  for (const char* other : {"--resume", "--restart"}) {
    EXPECT_TRUE(failedWith(
        2, "--skip-existing: not wanted with --resume or --restart, which know what is painted",
        scene.paint({{"--skip-existing", ""}, {other, ""}})));
  }
}

}  // namespace
}  // namespace fluidymation::test
