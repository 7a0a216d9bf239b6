#include "pipeline/medium_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fluidymation/core/error.h"
#include "support/small_scene.h"

namespace fluidymation {
namespace {

using test::messageOf;
using test::SmallScene;

constexpr Lab kPaper{90.0F, 1.0F, 5.0F};
constexpr Lab kPaint{40.0F, 30.0F, -20.0F};
constexpr Lab kBleeding{70.0F, 10.0F, -5.0F};

TEST(MediumColors, WeightPaintByCoverageAndKeepAwayFromItsEdge) {
  constexpr int kSide = 40;
  Image<Lab> picture({kSide, kSide}, kPaper);
  Image<float> coverage({kSide, kSide}, 0.0F);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < 10; ++x) {
      picture(x, y) = kPaint;
      coverage(x, y) = 1.0F;
    }
    coverage(10, y) = 0.25F;  // shows paper
    for (int x = 11; x < 14; ++x) picture(x, y) = kBleeding;
  }
  MediumColors colors;
  EXPECT_FALSE(colors.surface());
  EXPECT_FALSE(colors.medium());
  colors.add(picture, coverage);
  EXPECT_EQ(colors.surface()->l, kPaper.l);
  EXPECT_EQ(colors.surface()->b, kPaper.b);
  EXPECT_NEAR(colors.medium()->l, (10.0F * kPaint.l + 0.25F * kPaper.l) / 10.25F, 1e-4F);
}

/// Options that suit a small scene.
Options optionsFor(const SmallScene& scene) {
  Options options;
  options.source.path = scene.file("src/%05d.png");
  options.sourceMaskPath = scene.file("mask/%05d.png");
  options.target.path = scene.file("target/%05d.png");
  options.outPath = scene.file("out/%05d.png");
  options.blurSigmaPx = 1.0F;
  options.borderWidthPx = 3.0F;
  return options;
}

TEST(Recolor, ChangesColoursOnlyAndNoLightness) {
  const SmallScene scene(2);
  Options options = optionsFor(scene);
  stylize(options, {});
  options.recolor = Rgb8{20, 140, 60};
  options.outPath = scene.file("green/%05d.png");
  stylize(options, {});
  constexpr float kByteSteps = 1.2F;  // in L, of both files' rounding where it is coarsest
  int greens = 0;
  for (int number = 1; number <= 2; ++number) {
    const Image<Rgba> plain = readPng(scene.file(SmallScene::frame("out", number)));
    const Image<Rgba> green = readPng(scene.file(SmallScene::frame("green", number)));
    for (std::size_t i = 0; i < plain.pixelCount(); ++i) {
      const Rgba p = plain.data()[i];
      const Rgba g = green.data()[i];
      ASSERT_EQ(g.a, p.a);
      if (p.a == 0.0F) continue;
      // What lay outside sRGB was clipped channel by channel, at another lightness
      const auto [least, most] = std::minmax({p.r, p.g, p.b});
      if (least == 0.0F || most == 1.0F) continue;
      const Lab had = toLab(Rgb{p.r, p.g, p.b});
      const Lab has = toLab(Rgb{g.r, g.g, g.b});
      ASSERT_NEAR(has.l, had.l, kByteSteps);
      greens += has.a < had.a ? 1 : 0;
    }
  }
  EXPECT_GT(greens, 100);
}

TEST(Recolor, SaysWhatItCannotTellApart) {
  const SmallScene scene(2);
  Options options = optionsFor(scene);
  options.recolor = Rgb8{200, 0, 0};
  const auto fault = [&] { return messageOf<Error>([&] { stylize(options, {}); }); };
  const Image<Rgba8> gray({24, 20}, Rgba8{128, 128, 128, 255});
  for (int number = 1; number <= 2; ++number) {
    scene.write(SmallScene::frame("src", number), test::colorPng(gray));
  }
  EXPECT_EQ(fault(),
            "--recolor #c80000: paint and bare surface of the film differ by 0 in CIELAB; wanted "
            "2.3 or more, to tell them apart");
  for (int number = 1; number <= 2; ++number) {
    scene.write(SmallScene::frame("mask", number), test::maskPng(Mask({24, 20}, 1)));
  }
  EXPECT_EQ(fault(),
            "--recolor #c80000: the masks of --src-mask-path leave no bare surface in the film's "
            "frames; wanted some of both, to tell them apart");
}

}  // namespace
}  // namespace fluidymation
