// That every option of the real program counts, and which values are refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

TEST(EndToEndFrames, EveryOptionChangesThePainting) {
  const SmallScene scene;
  const ToolOptions common = {{"--src-start", "2"}, {"--src-frames", "2"}};
  const Painting standard = scene.painting(common);
  ASSERT_EQ(standard.size(), 4U);
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"--src-start", "1"},          {"--src-frames", "3"},
      {"--src-speed", "-1"},         {"--src-scale", "0.8"},
      {"--target-start", "2"},       {"--target-frames", "3"},
      {"--target-speed", "2"},       {"--target-scale", "1.5"},
      {"--blur-sigma", "2"},         {"--target-blur-sigma", "2"},
      {"--mask-threshold", "0.45"},  {"--time-blur-sigma", "0"},
      {"--flow-blur-sigma", "1.5"},  {"--preset", "paper"},
      {"--shape-guide", "blurred"},  {"--segments", "none"},
      {"--dir-weight", "100"},       {"--tex-weight", "0"},
      {"--dist-weight", "0"},        {"--flow-weight", "100"},
      {"--prev-weight", "0"},        {"--prev-deepening", "0"},
      {"--prev-depth-reach", "0"},   {"--prev-color-correction", "0"},
      {"--change-blending", "0"},    {"--opt-vote-sigma", "0"},
      {"--seam-blending", "0"},      {"--new-material", "fresh"},
      {"--border-width", "2"},       {"--prev-modulation-bounds", "0.5,0.25"},
      {"--patchmatch-alpha", "0.3"}, {"--patchmatch-iterations", "1"},
      {"--opt-iterations", "1"},     {"--seed", "1"},
  };
  for (const auto& [option, value] : changes) {
    ToolOptions changed = common;
    changed[option] = value;
    EXPECT_TRUE(scene.painting(changed) != standard) << option;
  }

  // Uses of neighbouring frames: where they are many enough to decide something
  ToolOptions uniform = {{"--src-frames", "4"}, {"--lambda", "20"}};
  const Painting standardUses = scene.painting(uniform);
  uniform["--occ-radius"] = "0";
  EXPECT_TRUE(scene.painting(uniform) != standardUses);

  // The film's detail, and which of its places are used too often: where there are pixels enough
  const SmallScene larger(2, {64, 56}, {60, 56});
  const Painting standardLarger = larger.painting({});
  EXPECT_TRUE(larger.painting({{"--detail-restoration", "0"}}) != standardLarger);
  EXPECT_TRUE(larger.painting({{"--lambda", "0"}}) != standardLarger);
}

TEST(EndToEndFrames, TheCompressionLevelChangesTheFilesAndNoPixel) {
  const SmallScene scene;
  ASSERT_EQ(scene.paint({{"--out-path", "standard/%05d.png"}}).exitCode, 0);
  ASSERT_EQ(scene.paint({{"--out-path", "stored/%05d.png"}, {"--compression-level", "0"}}).exitCode,
            0);
  for (const std::string& name : kFourFrames) {
    const Image<Rgba> expected = readPng(scene.file("standard/" + name));
    const Image<Rgba> actual = readPng(scene.file("stored/" + name));
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), actual.begin(), actual.end(),
                           [](const Rgba& p, const Rgba& q) {
                             return std::tie(p.r, p.g, p.b, p.a) == std::tie(q.r, q.g, q.b, q.a);
                           }))
        << name;
    EXPECT_GT(readBytes(scene.file("stored/" + name)).size(),
              readBytes(scene.file("standard/" + name)).size());
  }
}

/// The options of the scene that suit small pictures would hide most of a preset.
TEST(EndToEndFrames, PresetsPaintEveryFrameEachInItsOwnWay) {
  const SmallScene scene(3);
  std::vector<Painting> paintings;
  for (const std::string preset : {"standard", "thesis", "paper"}) {
    ToolOptions options = SmallScene::defaults();
    for (const char* option : {"--border-width", "--prev-modulation-bounds", "--time-blur-sigma"}) {
      options.erase(option);
    }
    options["--preset"] = preset;
    scene.remove("out");
    const ProcessResult result = scene.paintWithoutDefaults(options);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    for (int number = 1; number <= 3; ++number) {
      EXPECT_TRUE(isPaintedExactly(scene.file(SmallScene::frame("out", number)),
                                   smoothed(scene.targetMask(number), 1.0F)));
    }
    paintings.push_back(filesOf(scene.file("out")));
  }
  EXPECT_TRUE(paintings[0] != paintings[1]);
  EXPECT_TRUE(paintings[1] != paintings[2]);
  EXPECT_TRUE(paintings[0] != paintings[2]);
}

TEST(EndToEndFrames, OptionsWithTheirDefaultsChangeNothing) {
  const SmallScene scene(2);
  // The defaults as users read them, all at once; the scene's own are for tiny pictures.
  const Painting standard = scene.painting({{"--blur-sigma", "2"}});
  ToolOptions given = {{"--blur-sigma", "2"},
                       {"--target-blur-sigma", "2"},
                       {"--src-start", "1"},
                       {"--src-frames", "50"},
                       {"--src-speed", "1"},
                       {"--src-scale", "1.0"},
                       {"--target-start", "1"},
                       {"--target-frames", "50"},
                       {"--target-speed", "1"},
                       {"--target-scale", "1.0"},
                       {"--mask-threshold", "0.3"},
                       {"--flow-blur-sigma", "0"},
                       {"--shape-guide", "distance"},
                       {"--segments", "hard"},
                       {"--dir-weight", "0"},
                       {"--dist-weight", "5.0"},
                       {"--flow-weight", "0.1"},
                       {"--prev-weight", "1.0"},
                       {"--prev-deepening", "1"},
                       {"--prev-depth-reach", "20"},
                       {"--prev-color-correction", "0.5"},
                       {"--opt-vote-sigma", "0.5"},
                       {"--seam-blending", "0.3"},
                       {"--change-blending", "0.4"},
                       {"--detail-restoration", "1"},
                       {"--new-material", "auto"},
                       {"--lambda", "2"},
                       {"--occ-radius", "10"},
                       {"--seed", "0"},
                       {"--patchmatch-alpha", "0.75"},
                       {"--opt-iterations", "4,3,2"},
                       {"--patchmatch-iterations", "6,4"}};
  EXPECT_TRUE(scene.painting(given) == standard);
}

TEST(EndToEndFrames, IterationListsBeginWithTheCoarsestLevel) {
  // 28x22 and 24x20 have three levels, and the finest is not optimized: two values count.
  // As in the thesis, where a picture of this size still depends on every sweep.
  const SmallScene scene(2);
  const auto paint = [&](const std::string& option, const std::string& list) {
    return scene.painting({{option, list}, {"--preset", "thesis"}});
  };
  for (const std::string option : {"--opt-iterations", "--patchmatch-iterations"}) {
    const std::string low = option == "--opt-iterations" ? "0" : "1";
    const Painting standard = paint(option, low + ",2");
    EXPECT_TRUE(paint(option, low + ",2,7,9") == standard) << option;
    EXPECT_TRUE(paint(option, low + ",2,2") == standard) << option;
    EXPECT_TRUE(paint(option, "2,2") != standard) << option;
    EXPECT_TRUE(paint(option, low + ",1") != standard) << option;
    EXPECT_TRUE(paint(option, "2") == paint(option, "2,2")) << option;
  }
}

TEST(EndToEndFrames, TheSmallerOfExemplarAndTargetLimitsTheLevels) {
  // 20x16 has two levels, of which only the coarser one is optimized; 70x60 alone has four.
  const Size large{70, 60};
  const Size small{20, 16};
  for (const bool smallTarget : {false, true}) {
    const SmallScene scene(1, smallTarget ? large : small, smallTarget ? small : large);
    for (const char* option : {"--opt-iterations", "--patchmatch-iterations"}) {
      EXPECT_TRUE(scene.painting({{option, "2,1"}}) == scene.painting({{option, "2,4"}})) << option;
    }
  }
}

TEST(EndToEndFrames, ValuesOutOfRangeAreWrongUsage) {
  const SmallScene scene(1);
  const std::vector<std::pair<std::string, std::vector<std::string>>> bad = {
      {"--src-start", {"x", "1.5", "99999999999"}},
      {"--target-start", {"nan", "2000000000"}},
      {"--src-frames", {"0", "-1", "2000000"}},
      {"--target-frames", {"0", "-3"}},
      {"--src-speed", {"0", "1e3"}},
      {"--target-speed", {"0", "inf"}},
      {"--src-scale", {"0", "-1", "nan", "inf", "1e999", "17"}},
      {"--target-scale", {"0", "-0.5", "-nan"}},
      {"--blur-sigma", {"-1", "inf", "1001", "abc"}},
      {"--target-blur-sigma", {"-0.1", "nan"}},
      {"--mask-threshold", {"0", "0.51", "-0.3", "nan"}},
      {"--time-blur-sigma", {"-1", "inf"}},
      {"--dist-weight", {"-1", "nan", "1e7"}},
      {"--flow-weight", {"-1", "inf"}},
      {"--prev-weight", {"-1", "-inf"}},
      {"--prev-deepening", {"-1", "1001"}},
      {"--prev-depth-reach", {"-1", "1.5", "10001"}},
      {"--prev-color-correction", {"-0.1", "1.01", "nan"}},
      {"--opt-vote-sigma", {"-0.5", "101"}},
      {"--seam-blending", {"-1", "101"}},
      {"--change-blending", {"-0.1", "1.01", "nan"}},
      {"--detail-restoration", {"-0.1", "1.01", "nan"}},
      {"--lambda", {"-2", "0x10"}},
      {"--occ-radius", {"-1", "0.5"}},
      {"--patchmatch-alpha", {"0", "1", "nan"}},
      {"--border-width", {"0", "-1", "inf"}},
      {"--prev-modulation-bounds", {"10", "2,10", "5,5", "10,2,1", "nan,1", ",", "10,-1"}},
      {"--patchmatch-iterations", {"0", "6,0", ",", "6,", "6,,4", "1001"}},
      {"--opt-iterations", {"-1", ",4", "4,3,x"}},
      {"--seed", {"-1", "1.5", "18446744073709551616"}},
      {"--compression-level", {"-1", "10", "best"}},
      {"--threads", {"0", "-1", "1025"}},
  };
  for (const auto& [option, values] : bad) {
    for (const std::string& value : values) {
      EXPECT_TRUE(failedNaming(2, option + " " + value + ": wanted ", {},
                               scene.paint({{option, value}, {"--quiet", ""}})));
    }
    const ProcessResult empty = scene.paint({{option + "=", ""}, {"--quiet", ""}});
    EXPECT_TRUE(failedNaming(2, option + " with an empty value: wanted ", {}, empty));
  }
  EXPECT_EQ(scene.names("out"), std::vector<std::string>{});
}

TEST(EndToEndFrames, NumbersBeyondTheRangeOfFileNumbersAreWrongUsage) {
  const SmallScene scene(1);
  EXPECT_TRUE(failedNaming(2,
                           "--target-start 1000000000, --target-frames 1000000, --target-speed "
                           "1000000: the last frame would have number ",
                           {},
                           scene.paint({{"--target-start", "1000000000"},
                                        {"--target-frames", "1000000"},
                                        {"--target-speed", "1000000"},
                                        {"--quiet", ""}})));
}

}  // namespace
}  // namespace fluidymation::test
