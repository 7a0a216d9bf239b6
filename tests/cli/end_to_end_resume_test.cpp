// That nothing is lost when the real program is stopped, killed or fails, and that what is painted
// afterwards is what would have been painted without.

#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <utility>

#include "resumed_scene.h"
#include "support/sanitizers.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

class Resume : public ResumedScene {};

TEST_F(Resume, AfterAKillGivesTheSameBytes) {
  for (int frames = 1; frames < kResumedFrames; ++frames) {
    for (const char* threads : {"1", "2"}) {
      SCOPED_TRACE(std::to_string(frames) + " frames, resumed with " + threads + " threads");
      scene_.remove("out");
      stopAfter(frames, SIGKILL);
      const ProcessResult result = scene_.paint(quietly(resuming({{"--threads", threads}})));
      EXPECT_EQ(result.exitCode, 0) << result.err;
      EXPECT_TRUE(isComplete());
    }
  }
}

TEST_F(Resume, AfterAKillAtAnyCallToTheDiskGivesTheSameBytes) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's runtime has to be loaded first";
  int call = 1;
  for (bool killed = true; killed; ++call) {
    SCOPED_TRACE("killed at call " + std::to_string(call));
    scene_.remove("out");
    ProcessSetup setup;
    setup.environment = {{"LD_PRELOAD", FLUIDYMATION_KILL_AT_CALL},
                         {"FLUIDYMATION_KILL_AT", std::to_string(call)}};
    killed = scene_.paint(quietly(everyFrame()), setup).signal == SIGKILL;
    const ProcessResult result =
        scene_.paint(quietly(resuming({{"--threads", call % 2 == 0 ? "1" : "2"}})));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    ASSERT_TRUE(isComplete());
  }
  EXPECT_GT(call, 5 * kResumedFrames);  // that there were calls to be killed at
}

TEST_F(Resume, AStopSignalSavesTheStateAndSaysHowToGoOn) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    SCOPED_TRACE(signal);
    scene_.remove("out");
    // Slow frames, and no state before the signal
    const ToolOptions slow = {{"--opt-iterations", "400"},
                              {"--checkpoint-every", "100"},
                              {"--src-frames", "6"},
                              {"--target-frames", "6"}};
    const ProcessResult result = stopAfter(1, signal, slow);
    EXPECT_EQ(result.exitCode, code) << result.err;
    EXPECT_EQ(states().size(), 1U);
    EXPECT_NE(result.err.find(" of 6 frames written; --resume goes on from there\n"
                              "fluidymation: go on with: "),
              std::string::npos)
        << result.err;
    EXPECT_EQ(result.err.substr(result.err.size() - 10), " --resume\n");
    ToolOptions goingOn = slow;
    goingOn["--resume"] = "";
    EXPECT_EQ(scene_.paint(goingOn).exitCode, 0);
    const Painting resumed = filesOf(scene_.file("out"));
    EXPECT_TRUE(resumed == scene_.painting(slow));
  }
}

TEST_F(Resume, AFullDiskLosesNothing) {
  ProcessSetup full;
  full.largestFileBytes = 1500;  // enough for a frame, and not for a state or a manifest
  const ProcessResult result = scene_.paint(everyFrame(), full);
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(scene_.paint(quietly(resuming())).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

TEST_F(Resume, WithoutAStateBeginsWithTheFirstFrameAndSaysSo) {
  const ProcessResult result = scene_.paint(resuming());
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err.find("fluidymation: note: there is no state to go on from; beginning with "
                            "frame 1\nfluidymation: note: memory: "),
            0U)
      << result.err;
  EXPECT_TRUE(isComplete());
}

TEST_F(Resume, OfWhatIsCompletePaintsNothing) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame())).exitCode, 0);
  const ProcessResult result = scene_.paint(resuming());
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, "fluidymation: note: all frames are painted already\n");
  EXPECT_TRUE(isComplete());
  scene_.remove(SmallScene::frame("out", 4));
  EXPECT_EQ(scene_.paint(quietly(resuming())).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

}  // namespace
}  // namespace fluidymation::test
