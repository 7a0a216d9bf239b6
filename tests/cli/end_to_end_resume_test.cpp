// That nothing is lost when the real program is stopped, killed or fails, and that what is painted
// afterwards is what would have been painted without.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "support/finished_run.h"
#include "support/sanitizers.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

constexpr int kFrames = 6;

/// Paints all frames of a scene of so many, with a state after each.
ToolOptions everyFrame(ToolOptions more = {}) {
  more.insert({{"--checkpoint-every", "1"}, {"--src-frames", "6"}, {"--target-frames", "6"}});
  return more;
}

ToolOptions resuming(ToolOptions more = {}) {
  more["--resume"] = "";
  return everyFrame(std::move(more));
}

/// A scene whose animation grows, holds still and vanishes for a frame.
class Resume : public ::testing::Test {
 protected:
  Resume() : scene_(kFrames) {
    scene_.write(SmallScene::frame("target", 3), maskPng(scene_.targetMask(2)));
    scene_.write(SmallScene::frame("target", 5), maskPng(Mask(Size{28, 22})));
    expected_ = scene_.painting(everyFrame());
    manifest_ = scene_.read(kManifest);
    EXPECT_EQ(expected_.size(), std::size_t{kFrames});
    scene_.remove("out");
  }

  /// Whether all is there as if nothing had happened, and nothing else.
  [[nodiscard]] ::testing::AssertionResult isComplete() const {
    return isFinished(scene_, expected_, manifest_);
  }

  /// Ends a run as soon as it has told of `frames` frames.
  ProcessResult stopAfter(int frames, int signal, const ToolOptions& options = everyFrame()) const {
    ProcessSetup setup;
    setup.signalAfterOutput = signal;
    setup.linesBeforeSignal = 2 + frames;  // of memory, and that painting begins
    return scene_.paint(options, setup);
  }

  /// Leaves a state after some frames, as a run that was killed does.
  void leaveState() const {
    stopAfter(2, SIGKILL, everyFrame({{"--opt-iterations", "400"}}));
    ASSERT_FALSE(states().empty());
  }

  /// Names of all states, in no useful order.
  [[nodiscard]] std::vector<std::string> states() const {
    std::vector<std::string> names = scene_.names("out/.fluidymation");
    names.erase(std::remove_if(names.begin(), names.end(),
                               [](const std::string& n) { return n.find("state") != 0; }),
                names.end());
    return names;
  }

  SmallScene scene_;
  Painting expected_;
  Bytes manifest_;
};

TEST_F(Resume, AfterAKillGivesTheSameBytes) {
  for (int frames = 1; frames < kFrames; ++frames) {
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
  EXPECT_GT(call, 5 * kFrames);  // that there were calls to be killed at
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

TEST_F(Resume, IsRefusedNamingTheOptionsAndFilesThatDiffer) {
  leaveState();
  const ToolOptions same = {{"--opt-iterations", "400"}};
  const std::string state = "out/.fluidymation/" + states().front();
  const std::string end = "); --restart discards it and begins anew";
  EXPECT_TRUE(failedWith(
      1, state + ": is the state of another run (--lambda was 2, now 3" + end,
      scene_.paint(quietly(resuming({{"--lambda", "3"}, {"--opt-iterations", "400"}})))));
  EXPECT_TRUE(failedWith(
      1, state + ": is the state of another run (--opt-iterations was 400, now 4,3,2" + end,
      scene_.paint(quietly(resuming()))));
  EXPECT_TRUE(failedWith(
      1, state + ": is the state of another run (--compression-level was 2, now 9" + end,
      scene_.paint(
          quietly(resuming({{"--compression-level", "9"}, {"--opt-iterations", "400"}})))));
  for (const char* input : {"src", "mask", "target"}) {
    const std::string name = SmallScene::frame(input, 6);
    const Bytes before = scene_.read(name);
    scene_.write(name, scene_.read(SmallScene::frame(input, 1)));
    const std::string option = input == std::string("mask") ? "src-mask" : input;
    EXPECT_TRUE(failedWith(
        1,
        state + ": is the state of another run (--" + option + "-path: frame 6 has changed" + end,
        scene_.paint(quietly(resuming(same)))));
    scene_.write(name, before);
  }
  scene_.remove(SmallScene::frame("target", 6));
  EXPECT_TRUE(failedNaming(1, state + ": is the state of another run (--target-frames was 6, now 5",
                           {"--target-path had 6 frames, 1 to 6, now has 5 frames, 1 to 5"},
                           scene_.paint(quietly(resuming(same)))));
}

TEST_F(Resume, IsRefusedWhereTheStateIsDamaged) {
  leaveState();
  const ToolOptions same = {{"--opt-iterations", "400"}};
  const std::string state = "out/.fluidymation/" + states().front();
  const Bytes good = scene_.read(state);
  for (const std::size_t place :
       {std::size_t{0}, std::size_t{9}, good.size() / 2, good.size() - 1}) {
    Bytes bad = good;
    bad[place] = static_cast<std::uint8_t>(bad[place] ^ 1U);
    scene_.write(state, bad);
    EXPECT_TRUE(failedNaming(1, state + ": it is ", {"; --restart discards it and begins anew"},
                             scene_.paint(quietly(resuming(same)))));
  }
  scene_.write(state, Bytes(good.begin(), good.begin() + 100));
  EXPECT_TRUE(
      failedNaming(1, state + ": it is damaged", {}, scene_.paint(quietly(resuming(same)))));
}

TEST_F(Resume, IsRefusedWhereAFrameIsNotAsItWasPainted) {
  leaveState();
  const ToolOptions same = {{"--opt-iterations", "400"}};
  const std::string first = SmallScene::frame("out", 1);
  const Bytes before = scene_.read(first);
  scene_.write(first, bytesOf("retouched"));
  EXPECT_TRUE(failedWith(1, first + ": has changed since it was painted; --restart paints all anew",
                         scene_.paint(quietly(resuming(same)))));
  EXPECT_EQ(scene_.read(first), bytesOf("retouched"));
  scene_.remove(first);
  EXPECT_TRUE(failedWith(1, first + ": is missing since it was painted; --restart paints all anew",
                         scene_.paint(quietly(resuming(same)))));
}

TEST_F(Resume, AStoppedRunIsNeitherGoneOnWithNorDiscardedUnasked) {
  leaveState();
  EXPECT_TRUE(failedNaming(1, "out/.fluidymation: holds the state of a run that ended after ",
                           {" of 6 frames; wanted --resume to go on with it, or --restart to "
                            "discard it"},
                           scene_.paint(quietly(everyFrame({{"--opt-iterations", "400"}})))));
  // With other options it could not be gone on with
  EXPECT_TRUE(failedNaming(1, "out/.fluidymation/state-",
                           {": is the state of another run (--opt-iterations was 400, now 4,3,2); "
                            "--restart discards it and begins anew"},
                           scene_.paint(quietly(everyFrame()))));
  EXPECT_FALSE(states().empty());
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--restart", ""}}))).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

TEST_F(Resume, AndRestartContradictEachOther) {
  EXPECT_TRUE(failedWith(2, "--resume, --restart: wanted one of them at most",
                         scene_.paint(quietly(resuming({{"--restart", ""}})))));
}

// ---------------------------------------------------------------------------------------------
// A part of a shot

TEST_F(Resume, ConsecutivePartsGiveTheWhole) {
  for (const char* part : {"1-2", "3-3", "4-6"}) {
    const ProcessResult result = scene_.paint(everyFrame({{"--render-frames", part}}));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err.find("afresh"), std::string::npos) << result.err;
  }
  EXPECT_TRUE(isComplete());
}

TEST_F(Resume, AFrameIsMendedWhereStatesAreKept) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--keep-states", ""}}))).exitCode, 0);
  EXPECT_EQ(states().size(), std::size_t{kFrames - 1});
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

TEST_F(Resume, APartWithoutAStateStartsAfreshAndSaysSo) {
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

TEST_F(Resume, APlainRunAfterAPartIsOfferedWhatWorks) {
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

TEST_F(Resume, APartAheadDoesNotHideTheStateOfTheFramesBefore) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--render-frames", "1-2"}}))).exitCode, 0);
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--render-frames", "4-5"}}))).exitCode, 0);
  EXPECT_TRUE(failedNaming(1, "out/.fluidymation: holds the state of a run that ended after 2 of ",
                           {"wanted --resume to go on with it"},
                           scene_.paint(quietly(everyFrame()))));
  EXPECT_EQ(scene_.paint(quietly(resuming())).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

TEST_F(Resume, APartIsResumedToo) {
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

TEST_F(Resume, ARestartedPartStartsAfresh) {
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

TEST_F(Resume, APartThatIsGoneOnWithKeepsWhatIsKnownOfOthers) {
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

TEST_F(Resume, FramesWithOtherNamesAreNotTakenForThese) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame())).exitCode, 0);
  EXPECT_TRUE(
      failedNaming(1, "out/fluidymation.json: is of the frames out/%05d.png, not of out/%04d.png",
                   {"wanted another name or folder"},
                   scene_.paint(quietly(everyFrame({{"--out-path", "out/%04d.png"}})))));
  EXPECT_EQ(scene_.read(kManifest), manifest_);
}

TEST_F(Resume, PartsAreGivenByTheTargetsOwnNumbers) {
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

// ---------------------------------------------------------------------------------------------
// The manifest

TEST_F(Resume, TheManifestIsTheSameWhateverTheThreads) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--threads", "3"}}))).exitCode, 0);
  EXPECT_EQ(scene_.read(kManifest), manifest_);
}

TEST_F(Resume, VerifyTellsOfEachFrameThatIsNotAsItWasPainted) {
  const auto check = [&] { return scene_.paintWithoutDefaults({{"--verify", kManifest}}); };
  EXPECT_TRUE(failedWith(
      1, std::string(kManifest) + ": cannot be opened (No such file or directory)", check()));
  EXPECT_EQ(scene_.paint(quietly(everyFrame())).exitCode, 0);
  const ProcessResult good = check();
  EXPECT_EQ(good.exitCode, 0);
  EXPECT_EQ(good.out, std::string(kManifest) + ": 6 frames are as painted\n");
  scene_.remove(SmallScene::frame("out", 2));
  scene_.write(SmallScene::frame("out", 4), bytesOf("retouched"));
  scene_.write(SmallScene::frame("out", 9), bytesOf("extra"));
  const ProcessResult bad = check();
  EXPECT_EQ(bad.exitCode, 1);
  EXPECT_EQ(bad.out,
            "out/00002.png: missing\nout/00004.png: changed\n"
            "out/00009.png: extra, not in the manifest\n");
  EXPECT_TRUE(failedWith(2, "--verify, --seed: wanted --verify alone",
                         scene_.paintWithoutDefaults({{"--verify", kManifest}, {"--seed", "1"}})));
}

TEST_F(Resume, TheManifestOfAStoppedRunSaysThatItIsIncomplete) {
  leaveState();
  const ProcessResult result = scene_.paintWithoutDefaults({{"--verify", kManifest}});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.out.find(std::string(kManifest) +
                            ": not all frames of the shot are painted; it lacks "),
            std::string::npos);
}

}  // namespace
}  // namespace fluidymation::test
