// That a run which replaces the frames of a complete one may be stopped, killed and gone on with as
// any other, and still replaces nothing that somebody has worked on.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include "support/finished_run.h"
#include "support/sanitizers.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

constexpr int kFrames = 6;

/// Frames slow enough to be stopped between, with a state after every second.
ToolOptions withSeed(const std::string& seed, ToolOptions more = {}) {
  more.insert({{"--seed", seed},
               {"--checkpoint-every", "2"},
               {"--opt-iterations", "100"},
               {"--src-frames", "6"},
               {"--target-frames", "6"}});
  return more;
}

ToolOptions resuming(const std::string& seed) { return withSeed(seed, {{"--resume", ""}}); }

/// A scene that is painted with one seed, and what another seed makes of it. Its fifth frame is
/// empty, and so is the same with both.
class Replacement : public ::testing::Test {
 protected:
  Replacement() : scene_(kFrames) {
    scene_.write(SmallScene::frame("target", 5), maskPng(Mask(Size{28, 22})));
    expected_ = scene_.painting(withSeed("2"));
    manifest_ = scene_.read(kManifest);
    scene_.remove("out");
    first_ = scene_.painting(withSeed("1"));
    firstManifest_ = scene_.read(kManifest);
  }

  /// As after the first run.
  void paintFirst() const {
    scene_.remove("out");
    for (const auto& [name, bytes] : first_) scene_.write("out/" + name, bytes);
    scene_.write(kManifest, firstManifest_);
  }

  /// Ends a run with the other seed as soon as it has told of `frames` frames.
  ProcessResult stopAfter(int frames, int signal,
                          const ToolOptions& options = withSeed("2")) const {
    ProcessSetup setup;
    setup.signalAfterOutput = signal;
    setup.linesBeforeSignal = 2 + frames;  // of memory, and that painting begins
    return scene_.paint(options, setup);
  }

  /// Whether all is there as if the other run had not been stopped, and nothing else.
  [[nodiscard]] ::testing::AssertionResult isComplete() const {
    return isFinished(scene_, expected_, manifest_);
  }

  SmallScene scene_;
  Painting expected_;
  Bytes manifest_;
  Painting first_;
  Bytes firstManifest_;
};

TEST_F(Replacement, StoppedByASignalGoesOnAsItSays) {
  for (int frames = 1; frames < kFrames - 1; ++frames) {
    SCOPED_TRACE(frames);
    paintFirst();
    const ProcessResult stopped = stopAfter(frames, SIGINT);
    ASSERT_EQ(stopped.exitCode, 130) << stopped.err;
    ASSERT_EQ(stopped.err.substr(stopped.err.size() - 10), " --resume\n");
    // Frames of the first run are still there
    ASSERT_EQ(scene_.read("out/00006.png"), first_.at("00006.png"));
    const ProcessResult result = scene_.paint(quietly(resuming("2")));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_TRUE(isComplete());
  }
}

TEST_F(Replacement, KilledGoesOn) {
  for (int frames = 1; frames < kFrames; ++frames) {
    SCOPED_TRACE(frames);
    paintFirst();
    EXPECT_EQ(stopAfter(frames, SIGKILL).signal, SIGKILL);
    const ProcessResult result = scene_.paint(quietly(resuming("2")));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_TRUE(isComplete());
  }
}

TEST_F(Replacement, KilledTwiceAtAnyCallToTheDiskGoesOn) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's runtime has to be loaded first";
  int call = 1;
  const auto killedAt = [this](const ToolOptions& options, int number) {
    ProcessSetup setup;
    setup.environment = {{"LD_PRELOAD", FLUIDYMATION_KILL_AT_CALL},
                         {"FLUIDYMATION_KILL_AT", std::to_string(number)}};
    return scene_.paint(quietly(options), setup).signal == SIGKILL;
  };
  constexpr int kStep = 5;  // calls to the disk between the places where it is killed
  for (bool killed = true; killed; call += kStep) {
    SCOPED_TRACE("killed at call " + std::to_string(call));
    paintFirst();
    killed = killedAt(withSeed("2"), call);
    killedAt(resuming("2"), 1 + 7 * call % 20);
    const ProcessResult result = scene_.paint(quietly(resuming("2")));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    ASSERT_TRUE(isComplete());
  }
  EXPECT_GT(call, 5 * kFrames);  // that there were calls to be killed at
}

TEST_F(Replacement, OfFramesThatWereDeletedGoesOn) {
  if (kSanitized) GTEST_SKIP() << "a slow program is not killed in time";
  for (int number = 1; number < kFrames; ++number) scene_.remove(SmallScene::frame("out", number));
  // Before the first state: the manifest is still the first run's
  EXPECT_EQ(stopAfter(1, SIGKILL).signal, SIGKILL);
  const ProcessResult result = scene_.paint(quietly(resuming("2")));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_TRUE(isComplete());
}

TEST_F(Replacement, DoesNotReplaceWhatWasRetouchedMeanwhile) {
  for (const int signal : {SIGINT, SIGKILL}) {
    SCOPED_TRACE(signal);
    paintFirst();
    (void)stopAfter(2, signal);
    const Painting stopped = filesOf(scene_.file("out"));
    const Bytes retouched = bytesOf("retouched");
    scene_.write("out/00006.png", retouched);
    // Before anything is painted, and as often as it is tried
    for (int attempt = 0; attempt < 2; ++attempt) {
      const ProcessResult refused = scene_.paint(quietly(resuming("2")));
      EXPECT_TRUE(failedWith(
          1,
          "out/00006.png: is there already, and not as a run that is recorded there has painted "
          "it; wanted --overwrite to replace, --skip-existing to keep what is there, or another "
          "--out-path",
          refused));
      Painting now = filesOf(scene_.file("out"));
      EXPECT_EQ(now.at("00006.png"), retouched);
      now["00006.png"] = stopped.at("00006.png");
      EXPECT_TRUE(now == stopped);
    }
    ToolOptions overwriting = resuming("2");
    overwriting["--overwrite"] = "";
    EXPECT_EQ(scene_.paint(quietly(overwriting)).exitCode, 0);
    EXPECT_TRUE(isComplete());
  }
}

TEST_F(Replacement, ByARestartGoesOnAsItSays) {
  (void)stopAfter(2, SIGINT, withSeed("3"));
  // What is there belongs to two runs, and one is somebody's own: a restart replaces all
  scene_.write("out/00004.png", bytesOf("somebody's own"));
  const ProcessResult stopped = stopAfter(2, SIGINT, withSeed("2", {{"--restart", ""}}));
  ASSERT_EQ(stopped.exitCode, 130) << stopped.err;
  const ProcessResult result = scene_.paint(quietly(resuming("2")));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_TRUE(isComplete());
}

TEST_F(Replacement, OfAPartLeavesTheOtherFramesToBeReplaced) {
  EXPECT_EQ(scene_.paint(quietly(withSeed("2", {{"--render-frames", "1-3"}}))).exitCode, 0);
  EXPECT_EQ(scene_.read("out/00004.png"), first_.at("00004.png"));
  EXPECT_EQ(scene_.paint(quietly(resuming("2"))).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

TEST_F(Replacement, StoppedIsNotVerified) {
  (void)stopAfter(2, SIGINT);
  const ProcessResult result = scene_.paintWithoutDefaults({{"--verify", kManifest}});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.out.find("out/00006.png: extra, not in the manifest\n"), std::string::npos);
}

}  // namespace
}  // namespace fluidymation::test
