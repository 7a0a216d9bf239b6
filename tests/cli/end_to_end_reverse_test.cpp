// Painting from the last frame to the first, through the program itself.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

constexpr int kFrames = 14;
const Size kTarget{60, 22};
const std::string kReversed =
    "--reverse auto: lines being drawn, so frames are painted from the last to the first\n";

/// A line that grows to the right.
class EndToEndReverse : public ::testing::Test {
 protected:
  EndToEndReverse() {
    for (int number = 1; number <= kFrames; ++number) {
      const Mask line = maskOf(
          kTarget, [&](int x, int y) { return x >= 4 && x < 9 + 3 * number && y >= 7 && y < 15; });
      scene_.write(SmallScene::frame("target", number), maskPng(line));
    }
  }

  /// Without what suits masks that are smoothed.
  [[nodiscard]] static ToolOptions options(const ToolOptions& more) {
    ToolOptions all = {{"--blur-sigma", "0"}, {"--time-blur-sigma", "1"}};
    for (const auto& [name, value] : more) all[name] = value;
    return all;
  }
  [[nodiscard]] Painting paint(const ToolOptions& more) const {
    return scene_.painting(options(more));
  }
  [[nodiscard]] std::string notes(const ToolOptions& more) const {
    const ProcessResult result = scene_.paint(options(more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.err;
  }

  SmallScene scene_{kFrames, {24, 20}, kTarget};
};

TEST_F(EndToEndReverse, PaintsTheAnimationPlayedBackwardsUnderItsOwnNumbers) {
  const Painting reversed = paint({{"--reverse", "on"}});
  EXPECT_TRUE(reversed == paint({{"--target-range", "14-1"}, {"--new-material", "plain"}}));
  EXPECT_TRUE(reversed != paint({{"--new-material", "plain"}}));
  // Twice backwards is forwards
  EXPECT_TRUE(paint({{"--reverse", "on"}, {"--target-range", "14-1"}}) ==
              paint({{"--new-material", "plain"}}));
}

TEST_F(EndToEndReverse, StepsAndRangesStayWhatTheyAre) {
  const Painting stepped = paint({{"--reverse", "on"}, {"--target-range", "2-12x3"}});
  ASSERT_EQ(stepped.size(), 4U);
  EXPECT_EQ(stepped.count("00011.png"), 1U);
  EXPECT_TRUE(stepped == paint({{"--target-range", "11-2x3"}, {"--new-material", "plain"}}));
}

TEST_F(EndToEndReverse, IsDecidedByHowMaterialAppears) {
  const ToolOptions plainly = {{"--reverse", "auto"}, {"--new-material", "plain"}};
  EXPECT_NE(notes(plainly).find(kReversed), std::string::npos);
  EXPECT_TRUE(paint(plainly) == paint({{"--reverse", "on"}}));
  const SmallScene disc(kFrames, {24, 20}, kTarget);
  const ProcessResult other = disc.paint(plainly);
  EXPECT_NE(other.err.find("--reverse auto: no lines being drawn, so frames are painted from the "
                           "first to the last\n"),
            std::string::npos)
      << other.err;
  EXPECT_TRUE(filesOf(disc.file("out")) == disc.painting({{"--new-material", "plain"}}));
  for (const char* material : {"auto", "fresh"}) {
    EXPECT_NE(notes({{"--reverse", "auto"}, {"--new-material", material}})
                  .find("--reverse auto: --new-material makes lines fresh as they are drawn, so "
                        "frames are painted from the first to the last\n"),
              std::string::npos);
  }
}

TEST_F(EndToEndReverse, MaterialIsPlain) {
  // Lines that are erased are drawn in the order of painting
  EXPECT_TRUE(
      paint({{"--reverse", "on"}, {"--target-range", "14-1"}}) ==
      paint({{"--reverse", "on"}, {"--target-range", "14-1"}, {"--new-material", "plain"}}));
  EXPECT_TRUE(failedWith(
      2,
      "--reverse on: not wanted with --new-material fresh, which paints lines being drawn in their "
      "own order",
      scene_.paint(quietly({{"--reverse", "on"}, {"--new-material", "fresh"}}))));
}

TEST_F(EndToEndReverse, PartsFollowOneAnotherFromTheEnd) {
  const Painting whole = paint({{"--reverse", "on"}});
  scene_.remove("out");
  const ToolOptions reversed = {{"--reverse", "on"}};
  ToolOptions part = reversed;
  part["--render-frames"] = "9-14";
  (void)paint(part);
  ASSERT_EQ(scene_.names("out").size(), 6U);
  ToolOptions rest = reversed;
  rest["--resume"] = "";
  EXPECT_NE(notes(rest).find("going on with frame 8, 6 of 14 are painted"), std::string::npos);
  EXPECT_TRUE(filesOf(scene_.file("out")) == whole);
  // In the other order it is another painting
  scene_.remove("out");
  (void)paint(part);
  EXPECT_TRUE(failedWith(
      1,
      "out/.fluidymation/state-9.bin: is the state of another run (--reverse was on, now off; "
      "--target-path had 14 frames, 14 to 1, now has 14 frames, 1 to 14); --restart discards it "
      "and begins anew",
      scene_.paint(options(quietly({{"--resume", ""}})))));
}

TEST_F(EndToEndReverse, MissingFramesArePainted) {
  const ToolOptions reversed = {{"--reverse", "on"}};
  (void)paint(reversed);
  scene_.remove("out/00003.png");
  scene_.remove("out/00004.png");
  ToolOptions mend = reversed;
  mend["--skip-existing"] = "";
  EXPECT_NE(notes(mend).find("12 of 14 frames are there and kept"), std::string::npos);
  EXPECT_EQ(scene_.names("out").size(), std::size_t{kFrames});
}

TEST_F(EndToEndReverse, TheManifestPaintsTheSameAgain) {
  for (const char* how : {"on", "auto"}) {
    const Painting first = paint({{"--reverse", how}, {"--new-material", "plain"}});
    const std::string manifest = [&] {
      const Bytes bytes = scene_.read("out/fluidymation.json");
      return std::string(bytes.begin(), bytes.end());
    }();
    EXPECT_NE(manifest.find("\"--reverse\": \"on\""), std::string::npos) << manifest;
    EXPECT_NE(manifest.find("\"--target-speed\": \"1\""), std::string::npos) << manifest;
    EXPECT_EQ(scene_
                  .paintWithoutDefaults(quietly({{"--config", "out/fluidymation.json"},
                                                 {"--out-path", "again/%05d.png"},
                                                 {"--overwrite", ""}}))
                  .exitCode,
              0);
    EXPECT_TRUE(filesOf(scene_.file("again")) == first) << how;
  }
}

TEST_F(EndToEndReverse, ProgressCountsInTheOrderOfPainting) {
  const ProcessResult result =
      scene_.paint(options({{"--reverse", "on"}, {"--progress", "json"}, {"--quiet", ""}}));
  ASSERT_EQ(result.exitCode, 0);
  const std::size_t first = result.out.find("out/00014.png");
  const std::size_t then = result.out.find("out/00001.png");
  ASSERT_NE(first, std::string::npos) << result.out;
  EXPECT_LT(first, then) << result.out;
}

/// The preview shows frames in the animation's order, while it is painted as at its end.
TEST_F(EndToEndReverse, PreviewsPlayForwards) {
  (void)paint({{"--reverse", "on"}, {"--preview", "look.png"}, {"--preview-every", "3"}});
  const Bytes sheet = scene_.read("look.png");
  ToolOptions all = SmallScene::defaults();  // without --reverse
  all["--preview"] = "again.png";
  std::vector<std::string> arguments = argumentsOf(all);
  arguments.insert(arguments.begin(), "preview");
  ProcessSetup setup;
  setup.workingFolder = scene_.file(".");
  ASSERT_EQ(runProcess(FLUIDYMATION_PROGRAM, arguments, setup).exitCode, 0);
  EXPECT_TRUE(scene_.read("again.png") == sheet);
}

}  // namespace
}  // namespace fluidymation::test
