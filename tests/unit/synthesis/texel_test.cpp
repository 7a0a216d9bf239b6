#include "fluidymation/synthesis/texel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "fluidymation/core/random.h"
#include "support/fixed_point.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

TEST(ToFixed, RoundsToTheNearestStepAndTiesUpwards) {
  EXPECT_EQ(toFixed(0.0F, 128.0F), 0);
  EXPECT_EQ(toFixed(1.0F, 128.0F), 128);
  EXPECT_EQ(toFixed(0.49F, 1.0F), 0);
  EXPECT_EQ(toFixed(0.5F, 1.0F), 1);
  EXPECT_EQ(toFixed(-0.49F, 1.0F), 0);
  EXPECT_EQ(toFixed(-0.5F, 1.0F), 0);
  EXPECT_EQ(toFixed(-0.51F, 1.0F), -1);
  EXPECT_EQ(toFixed(-1.5F, 1.0F), -1);
}

TEST(ToFixed, EveryStepStaysWhatItIs) {
  for (int step = -kLargestFixed; step <= kLargestFixed; ++step) {
    ASSERT_EQ(toFixed(static_cast<float>(step) / kColorSteps, kColorSteps), step);
  }
}

TEST(ToFixed, StaysWithinTheLargest) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float large : {16383.4F, 16384.0F, 1e6F, 1e38F, kInfinity}) {
    EXPECT_EQ(toFixed(large, 1.0F), kLargestFixed) << large;
    EXPECT_EQ(toFixed(-large, 1.0F), -kLargestFixed) << large;
  }
  EXPECT_EQ(toFixed(std::numeric_limits<float>::max(), kColorSteps), kLargestFixed);  // overflows
}

TEST(ToFixed, TakesNotANumberForTheSmallest) {
  EXPECT_EQ(toFixed(std::numeric_limits<float>::quiet_NaN(), 128.0F), -kLargestFixed);
  EXPECT_EQ(toFixed(-std::numeric_limits<float>::quiet_NaN(), 128.0F), -kLargestFixed);
}

TEST(FixedLab, KeepsColoursToHalfAStep) {
  constexpr float kHalfStep = 0.5F / kColorSteps;
  Random random({41, 0, 0, 0, 0, 0});
  const auto component = [&](int from, int to) {
    return static_cast<float>(random.uniform(1000 * from, 1000 * to)) / 1000.0F;
  };
  for (int i = 0; i < 10000; ++i) {
    const Lab lab{component(0, 100), component(-108, 108), component(-108, 108)};
    const FixedLab fixed = FixedLab::of(lab);
    ASSERT_TRUE(fixed.exists());
    ASSERT_EQ(fixed.weight, 1);
    ASSERT_LE(std::abs(fixed.lab().l - lab.l), kHalfStep);
    ASSERT_LE(std::abs(fixed.lab().a - lab.a), kHalfStep);
    ASSERT_LE(std::abs(fixed.lab().b - lab.b), kHalfStep);
    ASSERT_EQ(FixedLab::of(fixed.lab()).l, fixed.l);
  }
  EXPECT_FALSE(FixedLab{}.exists());
}

/// Guides of one frame of full material in which everything differs from pixel to pixel.
GuideLevel randomGuides(Size size, int frame) {
  GuideLevel guides{Mask(size, 1),
                    Image<float>(size),
                    Image<float>(size),
                    Image<float>(size),
                    Image<Vec2>(size),
                    Image<Vec2>(size),
                    {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Random random({42, frame, 0, 0, x, y});
      guides.distance(x, y) = static_cast<float>(random.uniform(0, 400)) / 100.0F;
      guides.extForward(x, y) = static_cast<float>(random.uniform(0, 900)) / 10.0F;
      guides.extBackward(x, y) = static_cast<float>(random.uniform(0, 900)) / 10.0F;
    }
  }
  return guides;
}

bool sameBytes(const Texel& a, const Texel& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(ExemplarLevelMargins, RepeatTheEdgeOfEveryFrame) {
  constexpr int kFrames = 3;
  constexpr int kMargin = ExemplarLevel::kMarginPx;
  for (const Size size : {Size{7, 6}, Size{1, 4}, Size{5, 1}, Size{1, 1}}) {
    ExemplarLevel level(size, kFrames, 5.0F);
    for (int k = 0; k < kFrames; ++k) {
      level.setColor(k, test::randomTexture(size, static_cast<std::uint64_t>(50 + k)));
      level.setGuides(k, randomGuides(size, k));
    }
    level.finish();
    for (int k = 0; k < kFrames; ++k) {
      for (int y = -kMargin; y < size.height + kMargin; ++y) {
        for (int x = -kMargin; x < size.width + kMargin; ++x) {
          const int ex = std::clamp(x, 0, size.width - 1);
          const int ey = std::clamp(y, 0, size.height - 1);
          ASSERT_TRUE(sameBytes(level.texel(x, y, k), level.texel(ex, ey, k)))
              << x << ", " << y << " of frame " << k;
        }
      }
    }
  }
}

TEST(ExemplarLevelTexels, HoldWhatWasSetInStepsOfTheirChannels) {
  const Size size{7, 6};
  const Image<Lab> color = test::randomTexture(size, 50);
  const GuideLevel guides = randomGuides(size, 0);
  constexpr float kBorderWidthPx = 5.0F;
  for (const ExtentScale& scale :
       {ExtentScale{}, ExtentScale::boundedAt(20.0F), ExtentScale::ofAges(70.0F)}) {
    ExemplarLevel level(size, 1, kBorderWidthPx);
    level.setColor(0, color);
    level.setGuides(0, guides);
    level.finish(scale);
    ASSERT_EQ(level.extentSteps(), scale.stepsPerUnit());
    // Half a step, and the rounding of what lies within +-100 to single precision
    constexpr float kRounding = 1e-5F;
    constexpr float kOfColor = 0.5F / kColorSteps + kRounding;
    constexpr float kOfEdge = 0.5F / kEdgeSteps + kRounding;
    const float ofExtent = 0.5F / scale.stepsPerUnit() + kRounding;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto value = [&, x, y](Channel channel) {
          return test::channelAt(level, x, y, 0, channel);
        };
        EXPECT_NEAR(value(kLightness), color(x, y).l, kOfColor);
        EXPECT_NEAR(value(kGreenRed), color(x, y).a, kOfColor);
        EXPECT_NEAR(value(kBlueYellow), color(x, y).b, kOfColor);
        EXPECT_NEAR(value(kEdge), edgeChannel(guides.distance(x, y), kBorderWidthPx), kOfEdge);
        EXPECT_NEAR(value(kExtForward), scale(guides.extForward(x, y)), ofExtent);
        EXPECT_NEAR(value(kExtBackward), scale(guides.extBackward(x, y)), ofExtent);
      }
    }
  }
}

TEST(ExtentScale, FixedPointHoldsTheLargestExtents) {
  EXPECT_LE(kLargestExtent * ExtentScale::boundedAt(1.0F).stepsPerUnit(), kLargestFixed);
  EXPECT_LE(kLargestAge * ExtentScale::ofAges(1.0F).stepsPerUnit(), kLargestFixed);
}

}  // namespace
}  // namespace fluidymation
