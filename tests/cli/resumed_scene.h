#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include "support/finished_run.h"
#include "support/small_scene.h"

namespace fluidymation::test {

inline constexpr int kResumedFrames = 6;

/// Paints all frames of a scene of so many, with a state after each.
[[nodiscard]] inline ToolOptions everyFrame(ToolOptions more = {}) {
  more.insert({{"--checkpoint-every", "1"}, {"--src-frames", "6"}, {"--target-frames", "6"}});
  return more;
}

[[nodiscard]] inline ToolOptions resuming(ToolOptions more = {}) {
  more["--resume"] = "";
  return everyFrame(std::move(more));
}

/// A scene whose animation grows, holds still and vanishes for a frame.
class ResumedScene : public ::testing::Test {
 protected:
  ResumedScene() : scene_(kResumedFrames) {
    scene_.write(SmallScene::frame("target", 3), maskPng(scene_.targetMask(2)));
    scene_.write(SmallScene::frame("target", 5), maskPng(Mask(Size{28, 22})));
    expected_ = scene_.painting(everyFrame());
    manifest_ = scene_.read(kManifest);
    EXPECT_EQ(expected_.size(), std::size_t{kResumedFrames});
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
  SmallScene::Painting expected_;
  Bytes manifest_;
};

}  // namespace fluidymation::test
