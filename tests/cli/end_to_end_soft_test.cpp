// Anti-aliased masks, through the program itself.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/png_maker.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

const Size kTarget{28, 22};

/// Coverage as a file of this kind holds it: in its alpha where it has one, else in its brightness.
Bytes coveragePng(const Image<float>& coverage, PngColor color = PngColor::kGray,
                  int bitDepth = 8) {
  PngSpec spec;
  spec.size = coverage.size();
  spec.color = color;
  spec.bitDepth = bitDepth;
  const unsigned unit = bitDepth == 16 ? 257 : 1;
  const bool alpha = color == PngColor::kGrayAlpha || color == PngColor::kRgba;
  for (const float c : coverage) {
    const auto value = static_cast<std::uint16_t>(unit * std::lround(255.0F * c));
    for (int channel = 0; channel < channelsOf(color); ++channel) {
      const bool holds = !alpha || channel + 1 == channelsOf(color);
      spec.samples.push_back(holds ? value : static_cast<std::uint16_t>(unit * 90));
    }
  }
  return makePng(spec);
}

Image<float> movingDisc(int number) {
  return softDisc(kTarget, {11.3F + 0.4F * static_cast<float>(number), 10.6F}, 7.3F);
}

void writeTargets(const SmallScene& scene, int frames, PngColor color = PngColor::kGray,
                  int bitDepth = 8) {
  for (int number = 1; number <= frames; ++number) {
    scene.write(SmallScene::frame("target", number),
                coveragePng(movingDisc(number), color, bitDepth));
  }
}

TEST(EndToEndSoft, TheAlphaOfAStraightEdgeIsItsCoverage) {
  const SmallScene scene(4);
  const std::vector<Vec2> normals = {{1.0F, 0.0F}, {0.8F, 0.6F}, {-0.6F, 0.8F}, {0.28F, -0.96F}};
  for (int number = 1; number <= 4; ++number) {
    scene.write(SmallScene::frame("target", number),
                coveragePng(softHalfPlane(kTarget, {13.3F, 10.9F},
                                          normals[static_cast<std::size_t>(number - 1)])));
  }
  ASSERT_EQ(scene.painting({{"--target-blur-sigma", "0"}}).size(), 4U);
  for (int number = 1; number <= 4; ++number) {
    const Image<Rgba> target = readPng(scene.file(SmallScene::frame("target", number)));
    const Image<Rgba> painted = readPng(scene.file(SmallScene::frame("out", number)));
    // Where the edge leaves the frame at a shallow angle its rows are cut short
    const Vec2 normal = normals[static_cast<std::size_t>(number - 1)];
    const int marginX = std::abs(normal.x) > 0.7F ? 1 : 0;
    const int marginY = std::abs(normal.y) > 0.7F ? 1 : 0;
    for (int y = marginY; y + marginY < kTarget.height; ++y) {
      for (int x = marginX; x + marginX < kTarget.width; ++x) {
        EXPECT_NEAR(painted(x, y).a, target(x, y).r, 2.01F / 255.0F)
            << number << ": " << x << ", " << y;
      }
    }
  }
}

TEST(EndToEndSoft, WhateverIsVisibleHasAColourOfThePaint) {
  const Rgba8 paint{200, 120, 40, 255};
  const SmallScene scene(3);
  for (int number = 1; number <= 3; ++number) {
    scene.write(SmallScene::frame("src", number), colorPng(Image<Rgba8>({24, 20}, paint)));
  }
  writeTargets(scene, 3);
  for (const char* sigma : {"0", "1.5"}) {
    for (const char* voteSigma : {"0", "0.01", "0.5"}) {
      ASSERT_EQ(
          scene.painting({{"--target-blur-sigma", sigma}, {"--vote-sigma", voteSigma}}).size(), 3U);
      for (int number = 1; number <= 3; ++number) {
        const Image<Rgba> picture = readPng(scene.file(SmallScene::frame("out", number)));
        int partly = 0;
        for (const Rgba& p : picture) {
          if (p.a == 0.0F && p.r + p.g + p.b == 0.0F) continue;  // far from the paint
          partly += p.a > 0.0F && p.a < 1.0F ? 1 : 0;
          ASSERT_NEAR(p.r, 200.0F / 255.0F, 1.5F / 255.0F);
          ASSERT_NEAR(p.g, 120.0F / 255.0F, 1.5F / 255.0F);
          ASSERT_NEAR(p.b, 40.0F / 255.0F, 1.5F / 255.0F);
        }
        EXPECT_GT(partly, 30);
      }
    }
  }
}

TEST(EndToEndSoft, EveryKindOfPngMeansTheSame) {
  const SmallScene scene(2);
  writeTargets(scene, 2);
  const SmallScene::Painting expected = scene.painting({{"--target-frames", "2"}});
  ASSERT_EQ(expected.size(), 2U);
  struct Kind {
    PngColor color;
    int bitDepth;
  };
  for (const Kind& kind :
       {Kind{PngColor::kGray, 16}, Kind{PngColor::kRgb, 8}, Kind{PngColor::kGrayAlpha, 8},
        Kind{PngColor::kGrayAlpha, 16}, Kind{PngColor::kRgba, 8}, Kind{PngColor::kRgba, 16}}) {
    writeTargets(scene, 2, kind.color, kind.bitDepth);
    EXPECT_TRUE(scene.painting({{"--target-frames", "2"}}) == expected)
        << static_cast<int>(kind.color) << ", " << kind.bitDepth << " bit";
  }
}

int partlyTransparent(const std::string& path) {
  int count = 0;
  for (const Rgba& p : readPng(path)) count += p.a > 0.0F && p.a < 1.0F ? 1 : 0;
  return count;
}

TEST(EndToEndSoft, OneSoftFrameMakesTheWholeSequenceSoftAndNoOther) {
  const SmallScene scene(4);
  const auto outFrame = [&](int number) {
    return partlyTransparent(scene.file(SmallScene::frame("out", number)));
  };
  (void)scene.painting();
  for (int number = 1; number <= 4; ++number) EXPECT_EQ(outFrame(number), 0);
  scene.write(SmallScene::frame("target", 3), coveragePng(movingDisc(3)));
  (void)scene.painting();
  for (int number = 1; number <= 4; ++number) EXPECT_GT(outFrame(number), 10) << number;
  // A soft exemplar says nothing about the animation
  const SmallScene other(2);
  for (int number = 1; number <= 2; ++number) {
    other.write(SmallScene::frame("mask", number),
                coveragePng(softDisc({24, 20}, {11.5F, 9.5F}, 6.3F)));
  }
  EXPECT_EQ(other.painting().size(), 2U);
  for (int number = 1; number <= 2; ++number) {
    EXPECT_EQ(partlyTransparent(other.file(SmallScene::frame("out", number))), 0);
  }
}

TEST(EndToEndSoft, HardMasksStayHardWhenTheyAreScaled) {
  const SmallScene scene(2);
  for (const char* scale : {"0.6", "1.7"}) {
    ASSERT_EQ(scene.painting({{"--target-scale", scale}, {"--src-scale", scale}}).size(), 2U);
    for (int number = 1; number <= 2; ++number) {
      EXPECT_EQ(partlyTransparent(scene.file(SmallScene::frame("out", number))), 0);
    }
  }
  writeTargets(scene, 2);
  for (const char* scale : {"0.6", "1.7"}) {
    ASSERT_EQ(scene.painting({{"--target-scale", scale}}).size(), 2U);
    for (int number = 1; number <= 2; ++number) {
      EXPECT_GT(partlyTransparent(scene.file(SmallScene::frame("out", number))), 10);
    }
  }
}

TEST(EndToEndSoft, FramesMayBeEmptyOrFull) {
  const SmallScene scene(5);
  writeTargets(scene, 5);
  scene.write(SmallScene::frame("target", 2), coveragePng(Image<float>(kTarget)));
  scene.write(SmallScene::frame("target", 4), coveragePng(Image<float>(kTarget, 1.0F)));
  ASSERT_EQ(scene.painting().size(), 5U);
  EXPECT_TRUE(isPaintedExactly(scene.file(SmallScene::frame("out", 2)), Mask(kTarget)));
  EXPECT_TRUE(isPaintedExactly(scene.file(SmallScene::frame("out", 4)), Mask(kTarget, 1)));
}

const Size kLarge{100, 80};

/// Both targets cover 0.4 of every pixel.
void writeFaintTargets(const SmallScene& scene) {
  for (int number = 1; number <= 2; ++number) {
    scene.write(SmallScene::frame("target", number), coveragePng(Image<float>(kLarge, 0.4F)));
  }
}

/// Runs the tool without a smoothing of the test's own: its width follows from the masks.
ProcessResult paintSmoothedBySize(const SmallScene& scene, const std::string& maskThreshold) {
  ToolOptions options = SmallScene::defaults();
  options.erase("--blur-sigma");
  options["--mask-threshold"] = maskThreshold;
  return scene.paintWithoutDefaults(options);
}

TEST(EndToEndSoft, FaintMasksArePaintedWhereTheThresholdTakesThemIn) {
  const SmallScene scene(2, {24, 20}, kLarge);
  writeFaintTargets(scene);
  // An area of 0.4 * 100 * 80 px^2 is enough for a smoothing
  const ProcessResult painted = paintSmoothedBySize(scene, "0.3");
  EXPECT_EQ(painted.exitCode, 0);
  EXPECT_NE(painted.err.find(" --target-blur-sigma 0.7"), std::string::npos) << painted.err;
  EXPECT_EQ(painted.err.find("empty"), std::string::npos) << painted.err;
  EXPECT_TRUE(isPaintedExactly(scene.file(SmallScene::frame("out", 2)), Mask(kLarge, 1)));
}

TEST(EndToEndSoft, ATargetThatIsEmptyAfterSmoothingIsSaidToBe) {
  const SmallScene scene(2, {24, 20}, kLarge);
  writeFaintTargets(scene);
  const ProcessResult empty = paintSmoothedBySize(scene, "0.45");
  EXPECT_EQ(empty.exitCode, 0);
  EXPECT_NE(
      empty.err.find("--target-path target/%05d.png: all 2 masks are empty after smoothing, so "
                     "nothing is painted; check the masks, --target-blur-sigma (now 0.7) and "
                     "--mask-threshold (now 0.45; "),
      std::string::npos)
      << empty.err;
  EXPECT_TRUE(isPaintedExactly(scene.file(SmallScene::frame("out", 2)), Mask(kLarge)));
  // One frame with anything in it is enough
  scene.write(SmallScene::frame("target", 1), coveragePng(Image<float>(kLarge, 0.5F)));
  EXPECT_EQ(paintSmoothedBySize(scene, "0.45").err.find("empty"), std::string::npos);
}

TEST(EndToEndSoft, ImagesSmallerThanAPatchWork) {
  for (const Size size : {Size{1, 1}, Size{3, 3}, Size{2, 7}}) {
    for (const char* sigma : {"0", "2"}) {
      const SmallScene scene(2, size, size);
      for (int number = 1; number <= 2; ++number) {
        Image<float> coverage(size, 0.2F);
        coverage(0, 0) = number == 1 ? 0.9F : 0.7F;
        scene.write(SmallScene::frame("mask", number), coveragePng(coverage));
        scene.write(SmallScene::frame("target", number), coveragePng(coverage));
      }
      EXPECT_EQ(scene.painting({{"--blur-sigma", sigma}, {"--mask-threshold", "0.2"}}).size(), 2U)
          << size.width << "x" << size.height << ", sigma " << sigma;
    }
  }
}

TEST(EndToEndSoft, TheNumberOfThreadsDoesNotShow) {
  const SmallScene scene(3, {60, 50}, {90, 80});
  for (int number = 1; number <= 3; ++number) {
    const float step = 0.3F * static_cast<float>(number);
    scene.write(SmallScene::frame("mask", number),
                coveragePng(softDisc({60, 50}, {29.5F, 24.5F}, 15.0F + step)));
    scene.write(SmallScene::frame("target", number),
                coveragePng(softDisc({90, 80}, {44.0F + step, 40.0F}, 27.3F)));
  }
  const SmallScene::Painting one = scene.painting();
  EXPECT_TRUE(scene.painting({{"--threads", "3"}}) == one);
}

}  // namespace
}  // namespace fluidymation::test
