// Parts of a shot (--render-frames) by the real program, alone, one after the other and resumed.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <string>
#include <vector>

#include "resumed_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

class RenderedPart : public ResumedScene {};

TEST_F(RenderedPart, ConsecutivePartsGiveTheWhole) {
  for (const char* part : {"1-2", "3-3", "4-6"}) {
    const ProcessResult result = scene_.paint(everyFrame({{"--render-frames", part}}));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err.find("afresh"), std::string::npos) << result.err;
  }
  EXPECT_TRUE(isComplete());
}

TEST_F(RenderedPart, AFrameIsMendedWhereStatesAreKept) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--keep-states", ""}}))).exitCode, 0);
  EXPECT_EQ(states().size(), std::size_t{kResumedFrames - 1});
  scene_.remove(SmallScene::frame("out", 4));
  scene_.write(SmallScene::frame("out", 3), bytesOf("scratched"));
  const ProcessResult result = scene_.paint(
      everyFrame({{"--render-frames", "3-4"}, {"--threads", "2"}, {"--overwrite", ""}}));
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(
      result.err.find("note: going on after the state of frame 2\nfluidymation: note: memory: "),
      std::string::npos)
      << result.err;
  EXPECT_TRUE(filesOf(scene_.file("out")) == expected_);
  EXPECT_EQ(scene_.read(kManifest), manifest_);
}

TEST_F(RenderedPart, APartWithoutAStateStartsAfreshAndSaysSo) {
  const ProcessResult result = scene_.paint(everyFrame({{"--render-frames", "2-3"}}));
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err.find(
                "fluidymation: note: frame 2 starts afresh and looks other than after "
                "the frames before it: there is no state of frame 1\nfluidymation: note: memory: "),
            0U)
      << result.err;
  EXPECT_EQ(scene_.names("out"), (std::vector<std::string>{"00002.png", "00003.png"}));
  EXPECT_NE(scene_.read(SmallScene::frame("out", 2)), expected_.at("00002.png"));
  // After the frame without anything all start afresh.
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--render-frames", "6"}}))).exitCode, 0);
  EXPECT_EQ(scene_.read(SmallScene::frame("out", 6)), expected_.at("00006.png"));
}

TEST_F(RenderedPart, APlainRunAfterAPartIsOfferedWhatWorks) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--render-frames", "2-3"}}))).exitCode, 0);
  EXPECT_TRUE(failedWith(1,
                         "out/.fluidymation: holds the state of a part that was painted by itself, "
                         "frames 2 to 3; wanted --render-frames 2-6 --resume to go on with it, or "
                         "--restart to discard it and paint all 6",
                         scene_.paint(quietly(everyFrame()))));
  EXPECT_TRUE(failedWith(1,
                         "out/.fluidymation/state-3.bin: its frames start afresh with frame 2, "
                         "those wanted with frame 1; --restart discards it and begins anew",
                         scene_.paint(quietly(resuming()))));
  const Bytes second = scene_.read(SmallScene::frame("out", 2));
  EXPECT_EQ(scene_.paint(quietly(resuming({{"--render-frames", "2-6"}}))).exitCode, 0);
  EXPECT_EQ(scene_.names("out").size(), std::size_t{5});
  EXPECT_EQ(scene_.read(SmallScene::frame("out", 2)), second);
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--restart", ""}}))).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

TEST_F(RenderedPart, APartAheadDoesNotHideTheStateOfTheFramesBefore) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--render-frames", "1-2"}}))).exitCode, 0);
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--render-frames", "4-5"}}))).exitCode, 0);
  EXPECT_TRUE(failedNaming(1, "out/.fluidymation: holds the state of a run that ended after 2 of ",
                           {"wanted --resume to go on with it"},
                           scene_.paint(quietly(everyFrame()))));
  EXPECT_EQ(scene_.paint(quietly(resuming())).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

TEST_F(RenderedPart, APartIsResumedToo) {
  const ToolOptions part = everyFrame({{"--render-frames", "2-6"}, {"--opt-iterations", "100"}});
  EXPECT_EQ(scene_.paint(quietly(part)).exitCode, 0);
  const Painting whole = filesOf(scene_.file("out"));
  scene_.remove("out");
  stopAfter(2, SIGKILL, part);  // a note and a frame
  ToolOptions goingOn = part;
  goingOn["--resume"] = "";
  const ProcessResult result = scene_.paint(quietly(goingOn));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_TRUE(filesOf(scene_.file("out")) == whole);
}

TEST_F(RenderedPart, ARestartedPartStartsAfresh) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--keep-states", ""}}))).exitCode, 0);
  const ProcessResult result =
      scene_.paint(everyFrame({{"--render-frames", "2-3"}, {"--restart", ""}}));
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(
      result.err.find("fluidymation: note: frame 2 starts afresh and looks other than after "
                      "the frames before it: --restart was given\nfluidymation: note: memory: "),
      0U)
      << result.err;
  EXPECT_NE(scene_.read(SmallScene::frame("out", 2)), expected_.at("00002.png"));
  std::vector<std::string> left = states();
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left,
            (std::vector<std::string>{"state-1.bin", "state-3.bin", "state-4.bin", "state-5.bin"}));
}

TEST_F(RenderedPart, APartThatIsGoneOnWithKeepsWhatIsKnownOfOthers) {
  const ToolOptions slow = {{"--opt-iterations", "400"}};
  const auto part = [&](const char* frames) {
    ToolOptions options = everyFrame(slow);
    options["--render-frames"] = frames;
    return options;
  };
  stopAfter(2, SIGKILL, part("1-4"));
  ASSERT_FALSE(states().empty());
  EXPECT_EQ(scene_.paint(quietly(part("5-6"))).exitCode, 0);
  ToolOptions goingOn = part("1-4");
  goingOn["--resume"] = "";
  EXPECT_EQ(scene_.paint(quietly(goingOn)).exitCode, 0);
  EXPECT_EQ(scene_.paintWithoutDefaults({{"--verify", kManifest}}).out,
            std::string(kManifest) + ": 6 frames are as painted\n");
}

TEST_F(RenderedPart, PartsAreGivenByTheTargetsOwnNumbers) {
  const auto complaint = [&](const char* part) {
    return scene_.paint(quietly(everyFrame({{"--render-frames", part}})));
  };
  EXPECT_TRUE(failedWith(2,
                         "--render-frames: 7 is no frame of --target-path; wanted frames among 1 "
                         "to 6",
                         complaint("3-7")));
  for (const char* bad : {"a-b", "1-", "1-2-3", "1..2"}) {
    EXPECT_TRUE(failedWith(
        2, "--render-frames " + std::string(bad) + ": wanted two frame numbers, e.g. 10-80",
        complaint(bad)));
  }
  EXPECT_TRUE(failedWith(2, "--render-frames 5-3: wanted the first frame before the last, 3-5",
                         complaint("5-3")));
  ToolOptions backwards = everyFrame({{"--target-speed", "-1"}, {"--target-start", "6"}});
  const Painting whole = scene_.painting(backwards);
  scene_.remove("out");
  for (const char* part : {"4-6", "3-1"}) {
    backwards["--render-frames"] = part;
    EXPECT_EQ(scene_.paint(quietly(backwards)).exitCode, 0);
  }
  EXPECT_TRUE(filesOf(scene_.file("out")) == whole);
}

}  // namespace
}  // namespace fluidymation::test
