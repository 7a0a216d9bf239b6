// --src-window: a film of which only some frames are in memory at a time.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

constexpr int kFilmFrames = 14;
constexpr int kFrames = 6;
constexpr int kWindow = 5;
constexpr Size kTarget{28, 22};

/// The first film frame in memory for a frame of the animation, from 1: 1, 3, 5, 6, 8, 10.
int firstHeld(int number) {
  const double step = static_cast<double>(kFilmFrames - kWindow) / (kFrames - 1);
  return 1 + static_cast<int>(std::floor(step * (number - 1) + 0.5));
}

/// Numbers of the film's frames that a dumped field has matches in: the smallest and the largest.
std::pair<int, int> matchedFrames(const Bytes& pfm) {
  constexpr std::size_t kPixelBytes = 3 * sizeof(float);
  const std::size_t pixels = std::size_t{28} * 22;
  std::pair<int, int> range{kFilmFrames + 1, 0};
  for (std::size_t i = 0; i < pixels; ++i) {
    float number = 0.0F;
    std::memcpy(&number, pfm.data() + pfm.size() - (i + 1) * kPixelBytes + 2 * sizeof(float),
                sizeof number);
    if (std::isnan(number)) continue;
    range.first = std::min(range.first, static_cast<int>(number));
    range.second = std::max(range.second, static_cast<int>(number));
  }
  return range;
}

/// A film of 14 frames of which 5 are held, and an animation that holds still from its second to
/// its third frame and is gone in its fifth.
class SourceWindow : public ::testing::Test {
 protected:
  SourceWindow() {
    scene_.write(SmallScene::frame("target", 3), maskPng(scene_.targetMask(2)));
    scene_.write(SmallScene::frame("target", 5), maskPng(Mask(kTarget)));
  }

  [[nodiscard]] static ToolOptions with(ToolOptions more) {
    more.insert({{"--src-window", std::to_string(kWindow)},
                 {"--checkpoint-every", "1"},
                 {"--src-frames", std::to_string(kFilmFrames)},
                 {"--target-frames", std::to_string(kFrames)}});
    return more;
  }

  /// Paints with these options besides, beside what is there already; @return  all that is then.
  [[nodiscard]] Painting painted(const ToolOptions& more) const {
    const ProcessResult result = scene_.paint(quietly(with(more)));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return filesOf(scene_.file("out"));
  }

  SmallScene scene_{kFilmFrames};
};

TEST_F(SourceWindow, OfAllFramesChangesNothing) {
  const Painting expected = scene_.painting(with({{"--src-window", "0"}}));
  const Bytes manifest = scene_.read("out/fluidymation.json");
  EXPECT_EQ(expected.size(), std::size_t{kFrames});
  for (const char* window : {"14", "15", "9999"}) {
    EXPECT_TRUE(scene_.painting(with({{"--src-window", window}})) == expected) << window;
    EXPECT_TRUE(scene_.read("out/fluidymation.json") == manifest) << window;
  }
  EXPECT_FALSE(scene_.painting(with({})) == expected);
}

TEST_F(SourceWindow, MatchesLieInTheFramesThatAreHeld) {
  for (const char* coherence : {"forward", "bidirectional"}) {
    scene_.remove("dump");
    (void)scene_.painting(with({{"--dump-guides", "dump"}, {"--temporal-coherence", coherence}}));
    int latest = 0;
    for (const int number : {1, 2, 4, 6}) {  // of 3 those of 2 are kept
      SCOPED_TRACE(std::string(coherence) + " " + std::to_string(number));
      const std::string name = "dump/target/0000" + std::to_string(number) + ".nnf.pfm";
      const auto [first, last] = matchedFrames(scene_.read(name));
      // Windows of a few frames, all within one of the other kind, stay where they are
      const int begin = std::string(coherence) == "forward" ? firstHeld(number) : 1;
      EXPECT_GE(first, begin);
      EXPECT_LT(last, begin + kWindow);
      latest = std::max(latest, last);
    }
    EXPECT_EQ(latest > kWindow, std::string(coherence) == "forward");
  }
}

TEST_F(SourceWindow, IsPaintedAlikeByAnyNumberOfThreads) {
  const Painting expected = scene_.painting(with({}));
  EXPECT_TRUE(scene_.painting(with({{"--threads", "2"}})) == expected);
  EXPECT_TRUE(scene_.painting(with({{"--threads", "3"}})) == expected);
}

TEST_F(SourceWindow, AfterAKillGivesTheSameBytes) {
  for (const char* coherence : {"forward", "bidirectional"}) {
    const Painting expected = scene_.painting(with({{"--temporal-coherence", coherence}}));
    for (int frames = 1; frames < kFrames; ++frames) {
      SCOPED_TRACE(std::string(coherence) + ", " + std::to_string(frames) + " frames");
      scene_.remove("out");
      ProcessSetup setup;
      setup.signalAfterOutput = SIGKILL;
      setup.linesBeforeSignal = 2 + frames;  // of memory, and that painting begins
      (void)scene_.paint(with({{"--temporal-coherence", coherence}}), setup);
      EXPECT_TRUE(painted({{"--resume", ""}, {"--temporal-coherence", coherence}}) == expected);
    }
  }
}

TEST_F(SourceWindow, PartsAreThoseOfTheWhole) {
  const Painting expected = scene_.painting(with({}));
  for (int end = 1; end < kFrames; ++end) {  // amid the hold too
    SCOPED_TRACE(end);
    scene_.remove("out");
    EXPECT_EQ(painted({{"--render-frames", "1-" + std::to_string(end)}}).size(),
              static_cast<std::size_t>(end));
    const std::string rest = std::to_string(end + 1) + "-" + std::to_string(kFrames);
    EXPECT_TRUE(painted({{"--render-frames", rest}, {"--threads", "2"}}) == expected);
  }
}

/// Large enough for the film's detail to be known, of frames that are held no more as well.
TEST(SourceWindowOfALargerScene, PartsAreThoseOfTheWhole) {
  constexpr int kLargerFrames = 5;
  const SmallScene scene(12, {64, 56}, {60, 56});
  const auto with = [](ToolOptions more) {
    more.insert({{"--src-window", std::to_string(kWindow)},
                 {"--checkpoint-every", "1"},
                 {"--src-frames", "12"},
                 {"--target-frames", std::to_string(kLargerFrames)}});
    return more;
  };
  const Painting expected = scene.painting(with({}));
  EXPECT_FALSE(scene.painting(with({{"--detail-restoration", "0"}})) == expected);
  for (int end = 1; end < kLargerFrames; ++end) {
    SCOPED_TRACE(end);
    scene.remove("out");
    for (const std::string& part :
         {"1-" + std::to_string(end),
          std::to_string(end + 1) + "-" + std::to_string(kLargerFrames)}) {
      const ProcessResult result = scene.paint(quietly(with({{"--render-frames", part}})));
      EXPECT_EQ(result.exitCode, 0) << result.err;
    }
    EXPECT_TRUE(filesOf(scene.file("out")) == expected);
  }
}

TEST_F(SourceWindow, IsPartOfWhatARunIs) {
  (void)painted({{"--render-frames", "1-3"}});
  const ProcessResult result =
      scene_.paint(quietly(with({{"--resume", ""}, {"--src-window", "6"}})));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.err.find("--src-window was 5, now 6"), std::string::npos) << result.err;
}

TEST_F(SourceWindow, WhatCannotBeReadIsFoundBeforeAnythingIsWritten) {
  const Painting expected = scene_.painting(with({{"--threads", "1"}}));
  scene_.remove("out");
  const Bytes last = scene_.read(SmallScene::frame("src", kFilmFrames));
  scene_.write(SmallScene::frame("src", kFilmFrames), Bytes(last.begin(), last.end() - 40));
  EXPECT_TRUE(failedNaming(1, "src/00014.png: ", {}, scene_.paint(quietly(with({})))));
  EXPECT_TRUE(scene_.names("out").empty());
  scene_.write(SmallScene::frame("src", kFilmFrames), last);
  EXPECT_TRUE(painted({}) == expected);
}

TEST_F(SourceWindow, NothingCanMoveInOfIsRefused) {
  EXPECT_TRUE(failedWith(2,
                         "--src-window 1: nothing can move in it; wanted 0 for all frames, or at "
                         "least 2",
                         scene_.paint(with({{"--src-window", "1"}}))));
  EXPECT_TRUE(
      failedNaming(2, "--src-window -1: ", {"[0, "}, scene_.paint(with({{"--src-window", "-1"}}))));
}

TEST_F(SourceWindow, WithoutMaterialIsRefused) {
  for (int number = 4; number <= 8; ++number) {
    scene_.write(SmallScene::frame("mask", number), maskPng(Mask(Size{24, 20})));
  }
  EXPECT_TRUE(failedWith(2,
                         "--src-window 5: 5 masks in a row of --src-mask-path mask/%05d.png are "
                         "empty after smoothing, and a window without material paints nothing; "
                         "wanted at least 6, or --src-range without these frames",
                         scene_.paint(quietly(with({})))));
  EXPECT_TRUE(scene_.names("out").empty());
  EXPECT_EQ(scene_.painting(with({{"--src-window", "6"}})).size(), std::size_t{kFrames});
}

TEST_F(SourceWindow, AgesCountFromTheFilmsBegin) {
  const Painting fresh = scene_.painting(with({{"--new-material", "fresh"}}));
  EXPECT_EQ(fresh.size(), std::size_t{kFrames});
  EXPECT_FALSE(fresh == scene_.painting(with({})));
  EXPECT_TRUE(scene_.painting(with({{"--new-material", "fresh"}, {"--threads", "2"}})) == fresh);
}

}  // namespace
}  // namespace fluidymation::test
