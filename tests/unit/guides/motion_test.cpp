#include "fluidymation/guides/motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fluidymation/guides/distance_field.h"
#include "support/border_speed.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr int kFrames = 13;

/// Mean over all border pixels of a growing disc, at one of its frames, and over five positions on
/// the pixel grid: at a single one a slow disc gains its pixels in bursts.
class GrowingDiscs {
 public:
  GrowingDiscs(float firstRadius, float speed) {
    const float largest = std::max(firstRadius, firstRadius + speed * (kFrames - 1));
    const int side = 2 * static_cast<int>(largest) + 8;
    for (int phase = 0; phase < 5; ++phase) {
      const float shift = 0.2F * static_cast<float>(phase);
      const Vec2 centre{static_cast<float>(side / 2) + shift, static_cast<float>(side / 2) + 0.7F};
      std::vector<Mask> masks;
      for (int i = 0; i < kFrames; ++i) {
        const float radius = firstRadius + shift + speed * static_cast<float>(i);
        masks.push_back(test::disc({side, side}, centre, radius));
      }
      centres_.push_back(centre);
      discs_.push_back(test::guidesOf(masks, 2.0F));
    }
  }

  [[nodiscard]] test::BorderSpeed speed(std::size_t frame) const {
    test::BorderSpeedMean mean;
    for (std::size_t phase = 0; phase < discs_.size(); ++phase) {
      mean.add(discs_[phase][frame], centres_[phase]);
    }
    return mean.value();
  }

 private:
  std::vector<Vec2> centres_;
  std::vector<std::vector<GuideFrame>> discs_;
};

TEST(BorderPixels, AreThoseWithAnOutsideNeighbourWithinTheImage) {
  const Mask mask = test::maskOf({5, 4}, [](int x, int) { return x < 3; });
  const Mask expected = test::maskOf({5, 4}, [](int x, int) { return x == 2; });
  EXPECT_TRUE(test::equalEverywhere(expected, borderPixels(mask)));
  EXPECT_EQ(countInside(borderPixels(Mask(Size{3, 3}, 1))), 0U);
  EXPECT_EQ(countInside(borderPixels(Mask(Size{3, 3}))), 0U);
  const Mask dot = test::maskOf({3, 3}, [](int x, int y) { return x == 1 && y == 1; });
  EXPECT_TRUE(test::equalEverywhere(dot, borderPixels(dot)));
}

TEST(ContinuousDistance, ChangesByOneAcrossTheEdge) {
  const Mask half = test::maskOf({8, 1}, [](int x, int) { return x >= 4; });
  const Image<float> distance = continuousDistance(signedDistance(half));
  for (int x = 0; x < 8; ++x) EXPECT_EQ(distance(x, 0), static_cast<float>(x) - 3.5F);
}

TEST(MotionField, IsZeroWhereTheGradientVanishes) {
  // A line one pixel wide that has just become thicker: its ridge has no side to move to
  const Mask line = test::maskOf({9, 9}, [](int x, int) { return x == 4; });
  const Image<float> here = continuousDistance(signedDistance(line));
  Image<float> before = here.clone();
  for (float& d : before) d -= 0.25F;
  const MotionField motion =
      motionField(line, {partThicknesses(line, here), {{&here, 1.0F}}, {&before, &here}, {1.0F}});
  EXPECT_TRUE(test::nearEverywhere(Image<Vec2>(line.size()), motion.flow, 0.0F));
}

TEST(MotionField, NoPartMovesFurtherThanItIsThick) {
  // Two squares, 5 and 11 px wide: distances up to 2.5 and 5.5. Both have come from far away.
  const Size size{120, 30};
  const auto inSquares = [](int x, int y) {
    return (x >= 5 && x < 10 && y >= 5 && y < 10) || (x >= 30 && x < 41 && y >= 8 && y < 19);
  };
  std::vector<Mask> masks;
  masks.push_back(test::maskOf(size, [](int x, int y) { return x == 119 && y == 29; }));
  masks.push_back(test::maskOf(size, inSquares));
  const std::vector<GuideFrame> frames = test::guidesOf(masks, 0.0F);
  const Mask& mask = frames[1].mask;
  const Image<Vec2>& flow = frames[1].flow;
  float left = 0.0F;
  float right = 0.0F;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      float& largest = x < 20 ? left : right;
      largest = std::max(largest, length(flow(x, y)));
    }
  }
  EXPECT_NEAR(left, 2.5F, 1e-4F);
  EXPECT_NEAR(right, 5.5F, 1e-4F);
}

TEST(Flow, AGrowingDiscMovesOutwardsAtItsSpeedFromTheFirstFrameToTheLast) {
  for (const float speed : {0.2F, 0.5F, 1.0F, 2.0F, 3.0F}) {
    const GrowingDiscs discs(15.0F, speed);
    for (const std::size_t i : {0U, 6U, 12U}) {
      const test::BorderSpeed measured = discs.speed(i);
      EXPECT_NEAR(measured.outward, speed, 0.08F * speed) << "frame " << i;
      EXPECT_LT(measured.sideways, 0.1F * speed) << speed << ", frame " << i;
    }
  }
}

TEST(Flow, AShrinkingDiscMovesInwards) {
  const GrowingDiscs discs(30.0F, -1.0F);
  for (const std::size_t i : {0U, 6U, 12U}) {
    EXPECT_NEAR(discs.speed(i).outward, -1.0F, 0.08F) << "frame " << i;
  }
}

TEST(Flow, OfAGrowingDiscFadesLinearlyTowardsItsMiddle) {
  const Size size{80, 80};
  std::vector<Mask> masks;
  for (int i = 0; i < kFrames; ++i) {
    masks.push_back(test::disc(size, {40.0F, 40.0F}, 20.0F + static_cast<float>(i)));
  }
  const std::vector<GuideFrame> frames = test::guidesOf(masks, 2.0F);
  const Image<Vec2>& flow = frames[6].flow;  // radius 26
  EXPECT_LT(length(flow(40, 40)), 0.05F);
  EXPECT_NEAR(flow(40 + 13, 40).x, 0.5F, 0.05F);
  EXPECT_NEAR(flow(40, 40 - 13).y, -0.5F, 0.05F);
}

TEST(Flow, AMovingDiscFlowsAlongTheMotionAtItsFrontAndBack) {
  const Size size{110, 110};
  const Vec2 velocity{1.2F, 1.6F};
  constexpr float kSpeed = 2.0F;
  const auto centre = [&](int i) { return Vec2{45.0F, 45.0F} + static_cast<float>(i) * velocity; };
  std::vector<Mask> masks;
  for (int i = 0; i < kFrames; ++i) masks.push_back(test::disc(size, centre(i), 30.0F));
  const std::vector<GuideFrame> frames = test::guidesOf(masks, 2.0F);
  for (const int i : {0, 6, 12}) {
    const GuideFrame& frame = frames[static_cast<std::size_t>(i)];
    const Mask border = borderPixels(frame.mask);
    // Front and back: within 20 degrees of the motion
    constexpr float kCosine = 0.94F;
    float seen = 0.0F;
    Vec2 sum;
    for (int y = 0; y < border.height(); ++y) {
      for (int x = 0; x < border.width(); ++x) {
        if (border(x, y) == 0) continue;
        const Vec2 arm = test::place(x, y) - centre(i);
        if (std::abs(dot(arm, velocity)) < kCosine * kSpeed * length(arm)) continue;
        const Vec2 flow = frame.flow(x, y);
        EXPECT_GT(dot(flow, velocity), 0.8F * kSpeed * length(flow)) << x << ", " << y;
        sum += flow;
        seen += 1.0F;
      }
    }
    ASSERT_GT(seen, 20.0F);
    EXPECT_LT(length((1.0F / seen) * sum - velocity), 0.1F * kSpeed) << "frame " << i;
  }
}

TEST(Flow, ADiscThatCrossesItsOwnWidthWithinTheWindowStillMoves) {
  // Averaged over the window a disc this fast has no depth left anywhere, and its back is averaged
  // with the time when the pixel was its middle
  constexpr float kSpeed = 15.0F;
  const auto centre = [&](int i) { return Vec2{60.0F + kSpeed * static_cast<float>(i), 45.0F}; };
  std::vector<Mask> masks;
  for (int i = 0; i < 20; ++i) masks.push_back(test::disc({420, 90}, centre(i), 25.0F));
  const std::vector<GuideFrame> frames = test::guidesOf(masks, 2.0F);
  for (const int i : {7, 10, 12}) {
    const Image<Vec2>& flow = frames[static_cast<std::size_t>(i)].flow;
    const int middle = static_cast<int>(centre(i).x);
    for (const int side : {-24, 24}) {
      EXPECT_GT(flow(middle + side, 45).x, 0.35F * kSpeed) << "frame " << i << ", " << side;
      EXPECT_LT(flow(middle + side, 45).x, 1.05F * kSpeed) << "frame " << i << ", " << side;
    }
  }
}

TEST(Flow, AStillMaskHasNone) {
  std::vector<Mask> masks;
  for (int i = 0; i < 7; ++i) masks.push_back(test::randomBlobs({60, 50}, 2));
  for (const GuideFrame& frame : test::guidesOf(masks, 2.0F)) {
    EXPECT_GT(countInside(frame.mask), 100U);
    EXPECT_TRUE(test::nearEverywhere(Image<Vec2>({60, 50}), frame.flow, 1e-4F));
  }
}

}  // namespace
}  // namespace fluidymation
