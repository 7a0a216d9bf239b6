// Which frames the real program paints, of which size and shape.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/png_maker.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

std::vector<std::string> namesOf(const Painting& painting) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : painting) names.push_back(name);
  return names;
}

/// The painting under the numbers 1, 2, ... in the order of `numbers`.
Painting renumbered(const Painting& painting, const std::vector<int>& numbers) {
  Painting result;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto name = [](int number) { return SmallScene::frame("", number).substr(1); };
    result[name(static_cast<int>(i) + 1)] = painting.at(name(numbers[i]));
  }
  return result;
}

/// Gives the frames of `input` the numbers 1, 2, ... in the order of `numbers`; removes the others.
void renumber(const SmallScene& scene, const std::string& input, const std::vector<int>& numbers) {
  const Painting before = filesOf(scene.file(input));
  scene.remove(input);
  for (const auto& [name, bytes] : renumbered(before, numbers)) {
    scene.write(input + "/" + name, bytes);
  }
}

// ---------------------------------------------------------------------------------------------
// Numbers

TEST(EndToEndFrames, BearTheTargetsOwnNumbers) {
  const SmallScene scene(9);
  const auto namesWith = [&](const ToolOptions& options) {
    return namesOf(scene.painting(options));
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(namesWith({{"--target-start", "3"}, {"--target-frames", "2"}}),
            (Names{"00003.png", "00004.png"}));
  EXPECT_EQ(namesWith({{"--target-start", "2"}, {"--target-speed", "3"}, {"--target-frames", "3"}}),
            (Names{"00002.png", "00005.png", "00008.png"}));
  EXPECT_EQ(namesWith({{"--target-start", "3"}, {"--target-speed", "-1"}}),
            (Names{"00001.png", "00002.png", "00003.png"}));
  EXPECT_EQ(namesWith({{"--out-path", "out/x%d_.png"}, {"--target-start", "9"}}),
            (Names{"x9_.png"}));
  // Frames before the number 0, and a number longer than its field.
  scene.write("far/-0001.png", maskPng(scene.targetMask(1)));
  scene.write("far/00000.png", maskPng(scene.targetMask(2)));
  EXPECT_EQ(namesWith({{"--target-path", "far/%05d.png"}, {"--target-start", "-1"}}),
            (Names{"-0001.png", "00000.png"}));
  scene.write("far/1234567.png", maskPng(scene.targetMask(1)));
  EXPECT_EQ(namesWith({{"--target-path", "far/%05d.png"}, {"--target-start", "1234567"}}),
            (Names{"1234567.png"}));
}

TEST(EndToEndFrames, StartsAndSpeedsPickTheTargetsFrames) {
  const ToolOptions picked = {
      {"--target-start", "8"}, {"--target-speed", "-3"}, {"--target-frames", "3"}};
  const SmallScene scene(9);
  const Painting painting = scene.painting(picked);
  renumber(scene, "target", {8, 5, 2});
  EXPECT_TRUE(renumbered(painting, {8, 5, 2}) == scene.painting());
}

TEST(EndToEndFrames, StartsAndSpeedsPickTheExemplarsFrames) {
  for (const bool backwards : {false, true}) {
    const SmallScene scene(9);
    const Painting painting = scene.painting({{"--src-start", backwards ? "8" : "2"},
                                              {"--src-speed", backwards ? "-3" : "3"},
                                              {"--src-frames", "3"}});
    const std::vector<int> numbers =
        backwards ? std::vector<int>{8, 5, 2} : std::vector<int>{2, 5, 8};
    EXPECT_TRUE(painting != scene.painting({{"--src-frames", "3"}}));
    renumber(scene, "src", numbers);
    renumber(scene, "mask", numbers);
    EXPECT_TRUE(painting == scene.painting()) << (backwards ? "backwards" : "forwards");
  }
}

// ---------------------------------------------------------------------------------------------
// Sizes and shapes

/// Paints with these sizes and a mask of its own for each sequence, and checks every frame's size
/// and alpha.
void expectPaints(Size source, const Mask& sourceMask, Size target, const Mask& targetMask,
                  const std::string& sigma, int frames = 2) {
  const SmallScene scene(frames, source, target);
  for (int number = 1; number <= frames; ++number) {
    scene.write(SmallScene::frame("mask", number), maskPng(sourceMask));
    scene.write(SmallScene::frame("target", number), maskPng(targetMask));
  }
  const Painting painting = scene.painting({{"--blur-sigma", sigma}});
  ASSERT_EQ(painting.size(), static_cast<std::size_t>(frames));
  for (int number = 1; number <= frames; ++number) {
    EXPECT_TRUE(isPaintedExactly(scene.file(SmallScene::frame("out", number)),
                                 smoothed(targetMask, std::stof(sigma))))
        << source.width << "x" << source.height << " onto " << target.width << "x" << target.height
        << ", sigma " << sigma;
  }
}

Mask full(Size size) { return Mask(size, 1); }

TEST(EndToEndFrames, ImagesSmallerThanAPatchWork) {
  for (const Size source : {Size{1, 1}, Size{3, 3}, Size{4, 9}, Size{24, 20}}) {
    for (const Size target : {Size{1, 1}, Size{3, 3}, Size{2, 7}, Size{17, 13}}) {
      for (const char* sigma : {"0", "8"}) {
        expectPaints(source, full(source), target, full(target), sigma);
      }
    }
  }
}

TEST(EndToEndFrames, ASinglePixelIsEnough) {
  Mask source(Size{24, 20});
  source(7, 9) = 1;
  Mask target(Size{28, 22});
  target(20, 3) = 1;
  target(0, 21) = 1;
  expectPaints({24, 20}, source, {28, 22}, target, "0");
}

TEST(EndToEndFrames, MasksMayFillOrTouchTheFrame) {
  const Size source{24, 20};
  const Size target{28, 22};
  const auto leftHalf = [](Size size) {
    return maskOf(size, [size](int x, int) { return 2 * x < size.width; });
  };
  const auto corner = [](Size size) {
    return disc(size, {static_cast<float>(size.width - 1), 0.0F}, 9.0F);
  };
  for (const auto& [s, t] :
       {std::pair{full(source), full(target)}, std::pair{full(source), corner(target)},
        std::pair{corner(source), full(target)}, std::pair{leftHalf(source), leftHalf(target)},
        std::pair{corner(source), leftHalf(target)}}) {
    for (const char* sigma : {"0", "2"}) expectPaints(source, s, target, t, sigma);
  }
}

TEST(EndToEndFrames, SpecksHolesAndThinPartsWork) {
  const Size size{31, 23};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    expectPaints(size, randomBlobs(size, seed), size, randomMask(size, seed, 30), "0");
    expectPaints(size, randomMask(size, seed, 30), size, randomBlobs(size, seed), "0");
    expectPaints(size, randomMask(size, seed, 30), size, randomMask(size, seed, 30), "1");
  }
}

TEST(EndToEndFrames, OneFrameIsASequence) {
  for (const char* option : {"--src-frames", "--target-frames"}) {
    const SmallScene scene(3);
    const Painting painting = scene.painting({{option, "1"}});
    EXPECT_EQ(painting.size(), std::string(option) == "--src-frames" ? 3U : 1U);
  }
  expectPaints({24, 20}, full({24, 20}), {28, 22}, disc({28, 22}, {14.0F, 11.0F}, 8.0F), "1", 1);
}

TEST(EndToEndFrames, AnExemplarMayBeLargerThanItsTarget) {
  const Size source{70, 60};
  const Size target{20, 16};
  expectPaints(source, disc(source, {35.0F, 30.0F}, 22.0F), target,
               disc(target, {10.0F, 8.0F}, 6.0F), "1");
}

TEST(EndToEndFrames, AlphaIsTheSmoothedMaskAtEverySigma) {
  for (const char* sigma : {"0", "0.5", "2", "8"}) {
    const SmallScene scene(3);
    const Painting painting =
        scene.painting({{"--blur-sigma", "1"}, {"--target-blur-sigma", sigma}});
    ASSERT_EQ(painting.size(), 3U);
    for (int number = 1; number <= 3; ++number) {
      EXPECT_TRUE(isPaintedExactly(scene.file(SmallScene::frame("out", number)),
                                   smoothed(scene.targetMask(number), std::stof(sigma))));
    }
  }
}

TEST(EndToEndFrames, HalfCoverageIsInside) {
  const SmallScene scene(1, {24, 20}, {28, 22});
  const ToolOptions sharp = {{"--target-blur-sigma", "0"}};
  PngSpec spec;
  spec.size = {28, 22};
  for (int i = 0; i < 28 * 22; ++i) spec.samples.push_back(i % 28 < 10 ? 127 : 128);
  scene.write("target/00001.png", makePng(spec));
  ASSERT_EQ(scene.painting(sharp).size(), 1U);
  EXPECT_TRUE(isPaintedExactly(scene.file("out/00001.png"),
                               maskOf(Size{28, 22}, [](int x, int) { return x >= 10; })));
  // Two pixels make one: the column that is half covered counts.
  scene.write("target/00001.png",
              maskPng(maskOf(Size{28, 22}, [](int x, int) { return x >= 11; })));
  ToolOptions halved = sharp;
  halved["--target-scale"] = "0.5";
  ASSERT_EQ(scene.painting(halved).size(), 1U);
  EXPECT_TRUE(isPaintedExactly(scene.file("out/00001.png"),
                               maskOf(Size{14, 11}, [](int x, int) { return x >= 5; })));
}

TEST(EndToEndFrames, TheTargetsScaleIsTheOutputsSize) {
  const SmallScene scene(1);
  const auto sizeWith = [&](const ToolOptions& options) {
    EXPECT_EQ(scene.painting(options).size(), 1U);
    return readPngSize(scene.file("out/00001.png"));
  };
  EXPECT_EQ(sizeWith({{"--target-scale", "2"}}), (Size{56, 44}));
  EXPECT_EQ(sizeWith({{"--target-scale", "0.5"}}), (Size{14, 11}));
  EXPECT_EQ(sizeWith({{"--target-scale", "0.001"}}), (Size{1, 1}));
  EXPECT_EQ(sizeWith({{"--src-scale", "2"}}), (Size{28, 22}));
  EXPECT_EQ(sizeWith({{"--src-scale", "0.3"}}), (Size{28, 22}));
}

TEST(EndToEndFrames, AScaleBeyondAllMemoryIsWrongUsage) {
  const SmallScene scene(1, {1, 1200}, {1, 1200});
  for (const std::string option : {"--src-scale", "--target-scale"}) {
    const ProcessResult result = scene.paint({{option, "16"}, {"--quiet", ""}});
    EXPECT_TRUE(failedNaming(2, option.substr(0, option.size() - 6) + "-path: frames scaled to ",
                             {"16x19200; wanted at most 16384 px a side"}, result));
  }
}

// ---------------------------------------------------------------------------------------------
// Empty frames

TEST(EndToEndFrames, EmptyFramesAreTransparent) {
  const Mask nothing(Size{28, 22});
  for (const std::vector<int>& empty :
       {std::vector<int>{1}, {2}, {4}, {2, 3}, {1, 2, 4}, {1, 2, 3, 4}}) {
    const SmallScene scene;
    for (const int number : empty)
      scene.write(SmallScene::frame("target", number), maskPng(nothing));
    const Painting painting = scene.painting();
    ASSERT_EQ(painting.size(), 4U);
    for (int number = 1; number <= 4; ++number) {
      const bool isEmpty = std::find(empty.begin(), empty.end(), number) != empty.end();
      EXPECT_TRUE(
          isPaintedExactly(scene.file(SmallScene::frame("out", number)),
                           isEmpty ? nothing.clone() : smoothed(scene.targetMask(number), 1.0F)));
    }
  }
}

TEST(EndToEndFrames, ThePreviousFrameCountsUnlessItWasEmpty) {
  const SmallScene scene;
  const auto same = [&](const std::string& name) {
    return scene.painting({{"--prev-weight", "0"}}).at(name) ==
           scene.painting({{"--prev-weight", "50"}}).at(name);
  };
  EXPECT_TRUE(same("00001.png"));
  EXPECT_FALSE(same("00002.png"));
  EXPECT_FALSE(same("00003.png"));
  scene.write("target/00002.png", maskPng(Mask(Size{28, 22})));
  EXPECT_TRUE(same("00003.png")) << "starts afresh";
  EXPECT_FALSE(same("00004.png"));
}

}  // namespace
}  // namespace fluidymation::test
