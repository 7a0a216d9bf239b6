// Movement as a whole, seen through the flow that is made of it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr int kFrames = 13;
constexpr int kMiddle = 6;  // a frame whose temporal window is whole

GuideFrame middleFrame(const std::function<Mask(int)>& maskOf, MotionModel model) {
  std::vector<Mask> masks;
  for (int i = 0; i < kFrames; ++i) masks.push_back(maskOf(i));
  std::vector<GuideFrame> frames = test::guidesOf(masks, 2.0F, model);
  return std::move(frames[kMiddle]);
}

/// Mean over the mask of the flow's error against `truth(p)`, as a share of the mean true speed.
double relativeError(const GuideFrame& frame, const std::function<Vec2(Vec2)>& truth) {
  double error = 0.0;
  double speed = 0.0;
  for (int y = 0; y < frame.mask.height(); ++y) {
    for (int x = 0; x < frame.mask.width(); ++x) {
      if (frame.mask(x, y) == 0) continue;
      const Vec2 expected = truth(test::place(x, y));
      error += static_cast<double>(length(frame.flow(x, y) - expected));
      speed += static_cast<double>(length(expected));
    }
  }
  return error / speed;
}

TEST(RigidMotion, ADiscThatTravelsMovesAtItsSpeedInside) {
  const Vec2 velocity{3.0F, 0.5F};
  const auto disc = [&](int i) {
    return test::disc({150, 90}, Vec2{40.0F, 40.0F} + static_cast<float>(i) * velocity, 25.0F);
  };
  const auto truth = [&](Vec2) { return velocity; };
  EXPECT_LT(relativeError(middleFrame(disc, MotionModel::kRigidParts), truth), 0.1);
  // Spread from the normals alone it is about half as fast.
  EXPECT_GT(relativeError(middleFrame(disc, MotionModel::kNormals), truth), 0.35);
}

/// The movement of a frame i - 1 to i of a turn by `rad` per frame, seen on frame i.
Vec2 turned(Vec2 p, Vec2 centre, float rad) {
  const Vec2 arm = p - centre;
  const Rotation back{std::cos(-rad), std::sin(-rad)};
  return arm - back.apply(arm);
}

TEST(RigidMotion, ABarThatTurnsMovesAlongItsTurn) {
  const Vec2 centre{60.0F, 60.0F};
  constexpr float kRad = 0.03F;
  const auto bar = [&](int i) {
    const float angle = kRad * static_cast<float>(i);
    const Vec2 axis{std::cos(angle), std::sin(angle)};
    return test::maskOf({120, 120}, [&](int x, int y) {
      const Vec2 arm = test::place(x, y) - centre;
      return std::abs(dot(arm, axis)) < 45.0F && std::abs(arm.x * axis.y - arm.y * axis.x) < 11.0F;
    });
  };
  const auto truth = [&](Vec2 p) { return turned(p, centre, kRad); };
  EXPECT_LT(relativeError(middleFrame(bar, MotionModel::kRigidParts), truth), 0.12);
}

TEST(RigidMotion, TheTeethOfACogwheelMoveAlongItsTurn) {
  const Vec2 centre{70.0F, 70.0F};
  constexpr float kRad = 0.02F;
  const auto wheel = [&](int i) {
    return test::maskOf({140, 140}, [&](int x, int y) {
      const Vec2 arm = test::place(x, y) - centre;
      const float angle = std::atan2(arm.y, arm.x) - kRad * static_cast<float>(i);
      return length(arm) > 20.0F && length(arm) < (std::sin(10.0F * angle) > 0.0F ? 60.0F : 46.0F);
    });
  };
  const auto truth = [&](Vec2 p) { return turned(p, centre, kRad); };
  EXPECT_LT(relativeError(middleFrame(wheel, MotionModel::kRigidParts), truth), 0.2);
  EXPECT_GT(relativeError(middleFrame(wheel, MotionModel::kNormals), truth), 0.5);
}

TEST(RigidMotion, AGrowingDiscStillGrows) {
  const Vec2 centre{45.0F, 45.0F};
  const auto disc = [&](int i) {
    return test::disc({90, 90}, centre, 15.0F + static_cast<float>(i));
  };
  const auto truth = [&](Vec2 p) { return (1.0F / (15.0F + kMiddle)) * (p - centre); };
  EXPECT_LT(relativeError(middleFrame(disc, MotionModel::kRigidParts), truth), 0.1);
}

TEST(RigidMotion, ABodyThatWavesAnArmDoesNotSlide) {
  // A large square at rest with a thin arm that swings on its right side
  const auto figure = [](int i) {
    const float angle = -0.6F + 0.1F * static_cast<float>(i);
    const Vec2 axis{std::cos(angle), std::sin(angle)};
    return test::maskOf({150, 110}, [&](int x, int y) {
      const Vec2 arm = test::place(x, y) - Vec2{78.0F, 55.0F};
      const bool inArm = dot(arm, axis) > 0.0F && dot(arm, axis) < 50.0F &&
                         std::abs(arm.x * axis.y - arm.y * axis.x) < 6.0F;
      return inArm || (x >= 10 && x < 80 && y >= 15 && y < 95);
    });
  };
  const GuideFrame frame = middleFrame(figure, MotionModel::kRigidParts);
  const GuideFrame plain = middleFrame(figure, MotionModel::kNormals);
  EXPECT_GT(length(frame.flow(118, 55)), 1.2F);  // the arm does move
  for (const int y : {25, 55, 85}) {
    for (const int x : {15, 40}) {
      EXPECT_LT(length(frame.flow(x, y)), length(plain.flow(x, y)) + 0.05F) << x << ", " << y;
    }
  }
}

TEST(RigidMotion, EachPartHasItsOwn) {
  const auto discs = [](int i) {
    const float step = 2.0F * static_cast<float>(i);
    const Mask left = test::disc({190, 70}, {30.0F + step, 35.0F}, 20.0F);
    const Mask right = test::disc({190, 70}, {160.0F - step, 35.0F}, 20.0F);
    return test::maskOf({190, 70}, [&](int x, int y) { return left(x, y) + right(x, y) > 0; });
  };
  const GuideFrame frame = middleFrame(discs, MotionModel::kRigidParts);
  EXPECT_NEAR(frame.flow(42, 35).x, 2.0F, 0.2F);
  EXPECT_NEAR(frame.flow(148, 35).x, -2.0F, 0.2F);
}

}  // namespace
}  // namespace fluidymation
