#include "fluidymation/core/color.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

TEST(Color, LabOfTheSrgbPrimariesAgreesWithPublishedValues) {
  const Lab red = toLab(Rgb{1.0F, 0.0F, 0.0F});
  EXPECT_NEAR(red.l, 53.24F, 0.02F);
  EXPECT_NEAR(red.a, 80.09F, 0.05F);
  EXPECT_NEAR(red.b, 67.20F, 0.05F);
  const Lab blue = toLab(Rgb{0.0F, 0.0F, 1.0F});
  EXPECT_NEAR(blue.l, 32.30F, 0.02F);
  EXPECT_NEAR(blue.a, 79.19F, 0.05F);
  EXPECT_NEAR(blue.b, -107.86F, 0.05F);
}

TEST(Color, GraysAreNeutralAndWhiteIsHundred) {
  for (const float gray : {0.0F, 0.01F, 0.2F, 0.5F, 1.0F}) {
    const Lab lab = toLab(Rgb{gray, gray, gray});
    EXPECT_NEAR(lab.a, 0.0F, 1e-3F) << gray;
    EXPECT_NEAR(lab.b, 0.0F, 1e-3F) << gray;
  }
  EXPECT_NEAR(toLab(Rgb{1.0F, 1.0F, 1.0F}).l, 100.0F, 1e-3F);
}

TEST(Color, EightBitColoursSurviveTheRoundTrip) {
  constexpr float kHalfStep = 0.5F / 255.0F;
  for (int r = 0; r < 256; r += 17) {
    for (int g = 0; g < 256; g += 17) {
      for (int b = 0; b < 256; b += 15) {
        const Rgb color{static_cast<float>(r) / 255.0F, static_cast<float>(g) / 255.0F,
                        static_cast<float>(b) / 255.0F};
        const Rgb back = toRgb(toLab(color));
        ASSERT_NEAR(back.r, color.r, kHalfStep) << r << ' ' << g << ' ' << b;
        ASSERT_NEAR(back.g, color.g, kHalfStep) << r << ' ' << g << ' ' << b;
        ASSERT_NEAR(back.b, color.b, kHalfStep) << r << ' ' << g << ' ' << b;
      }
    }
  }
}

TEST(Color, OutOfGamutIsClipped) {
  const Rgb color = toRgb(Lab{50.0F, 200.0F, -200.0F});
  for (const float channel : {color.r, color.g, color.b}) {
    EXPECT_GE(channel, 0.0F);
    EXPECT_LE(channel, 1.0F);
  }
}

TEST(ToByte, RoundsToTheNearestAndClips) {
  EXPECT_EQ(toByte(-0.1F), 0);
  EXPECT_EQ(toByte(0.49F / 255.0F), 0);
  EXPECT_EQ(toByte(0.51F / 255.0F), 1);
  EXPECT_EQ(toByte(1.0F), 255);
  EXPECT_EQ(toByte(1.7F), 255);
}

}  // namespace
}  // namespace fluidymation
