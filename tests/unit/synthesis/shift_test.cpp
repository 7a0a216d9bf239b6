#include "fluidymation/synthesis/shift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "fluidymation/core/random.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

/// A frame that is full and 5 px deep, and moves right by `flowPx` as a whole.
GuideFrame movingRight(Size size, float flowPx) {
  return {Mask(size, 1),
          Image<float>(size, 5.0F),
          Image<Vec2>(size, Vec2{flowPx, 0.0F}),
          Image<Vec2>(size, Vec2{1.0F, 0.0F}),
          Image<Vec2>(size),
          Image<Vec2>(size),
          SolveReport{},
          {}};
}

/// An exemplar disc that grows by 1 px per frame, and a target whose every pixel moves right by
/// `targetSpeed`; the match sits on the exemplar's x axis, right of the centre.
class Shift : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{48, 40}, {24.0F, 20.0F}, 6.0F, 1.0F, 10};
  Exemplar exemplar_ = test::discExemplar(disc_, 0, 5.0F, 1);

  [[nodiscard]] int shiftedFrame(float targetSpeed, int startFrame, bool opposite) const {
    const Size one{1, 1};
    const GuideFrame target = movingRight(one, targetSpeed);
    // The exemplar flows to the right at (28, 20); turned by pi it runs against the target.
    const Rotation rotation = opposite ? Rotation{-1.0F, 0.0F} : Rotation{};
    const NearestNeighborField previous(one, Match{28.0F, 20.0F, startFrame, rotation});
    return shift(exemplar_, target, previous)(0, 0).frame;
  }
};

TEST_F(Shift, ForwardLandsWhereTheExemplarMovedAsFar) {
  EXPECT_EQ(shiftedFrame(1.0F, 2, false), 3);
  EXPECT_EQ(shiftedFrame(3.0F, 2, false), 5);
  EXPECT_EQ(shiftedFrame(2.6F, 2, false), 5);
  EXPECT_EQ(shiftedFrame(2.4F, 2, false), 4);
}

TEST_F(Shift, OppositeDirectionsWalkBackwards) {
  EXPECT_EQ(shiftedFrame(1.0F, 5, true), 4);
  EXPECT_EQ(shiftedFrame(3.0F, 5, true), 2);
}

TEST_F(Shift, StillTargetsKeepTheField) {
  EXPECT_EQ(shiftedFrame(0.0F, 4, false), 4);
  EXPECT_EQ(shiftedFrame(0.0F, 4, true), 4);
}

TEST_F(Shift, TiesGoToTheSmallestStep) { EXPECT_EQ(shiftedFrame(0.5F, 4, false), 4); }

TEST_F(Shift, TheWalkStopsAtTheSequencesEnds) {
  EXPECT_EQ(shiftedFrame(100.0F, 5, false), 9);
  EXPECT_EQ(shiftedFrame(100.0F, 5, true), 0);
}

TEST_F(Shift, TheWalkStopsWhereThePlaceLeavesTheMask) {
  // (34, 20) is 10 px from the centre: inside from radius 11 on, that is from frame 5.
  const Size one{1, 1};
  const GuideFrame target = movingRight(one, 9.0F);
  const NearestNeighborField previous(one, Match{34.0F, 20.0F, 8, Rotation{-1.0F, 0.0F}});
  EXPECT_EQ(shift(exemplar_, target, previous)(0, 0).frame, 5);
}

TEST_F(Shift, PixelsOutsideTheNewMaskAndPixelsWithoutMatchGetNone) {
  const Size two{2, 1};
  GuideFrame target{Mask(two),        Image<float>(two), Image<Vec2>(two), Image<Vec2>(two),
                    Image<Vec2>(two), Image<Vec2>(two),  SolveReport{},    {}};
  target.mask(1, 0) = 1;
  NearestNeighborField previous(two);
  previous(0, 0) = {28.0F, 20.0F, 2, Rotation{}};
  const NearestNeighborField shifted = shift(exemplar_, target, previous);
  EXPECT_FALSE(shifted(0, 0).exists());
  EXPECT_FALSE(shifted(1, 0).exists());
}

/// The exemplar's frame under a target that moves right by `speedPx` in each of `steps` frames.
class CarriedMotion : public Shift {
 protected:
  [[nodiscard]] int frameAfter(float speedPx, int steps, Image<float>* owed) const {
    const Size one{1, 1};
    const GuideFrame target = movingRight(one, speedPx);
    NearestNeighborField nnf(one, Match{28.0F, 20.0F, 2, Rotation{}});
    for (int i = 0; i < steps; ++i) nnf = shift(exemplar_, target, nnf, owed);
    return nnf(0, 0).frame;
  }
};

TEST_F(CarriedMotion, SlowTargetsMoveThroughTheExemplarAtTheirSpeed) {
  // (28, 20) lies half-way between middle and rim at frame 2, where the exemplar moves by about
  // half a pixel per frame.
  Image<float> none;
  const int fast = frameAfter(1.0F, 2, nullptr);
  for (const int slowness : {5, 10}) {
    Image<float> owed;
    EXPECT_EQ(frameAfter(1.0F / static_cast<float>(slowness), 2 * slowness, &owed), fast);
    EXPECT_EQ(frameAfter(1.0F / static_cast<float>(slowness), 2 * slowness, nullptr), 2);
  }
}

TEST_F(CarriedMotion, AHoldStaysStill) {
  Image<float> owed;
  const int before = frameAfter(0.3F, 1, &owed);
  EXPECT_NE(owed(0, 0), 0.0F);
  const float kept = owed(0, 0);
  const Size one{1, 1};
  const GuideFrame still = movingRight(one, 0.0F);
  NearestNeighborField nnf(one, Match{28.0F, 20.0F, before, Rotation{}});
  for (int i = 0; i < 20; ++i) nnf = shift(exemplar_, still, nnf, &owed);
  EXPECT_EQ(nnf(0, 0).frame, before);
  EXPECT_EQ(owed(0, 0), kept);
}

TEST_F(CarriedMotion, WhatTheExemplarsEndStoppedIsNotOwed) {
  Image<float> owed;
  EXPECT_EQ(frameAfter(100.0F, 1, &owed), 9);
  EXPECT_EQ(owed(0, 0), 0.0F);
}

/// An exemplar of full frames whose every pixel moves right by `stepsPx[k]` on the way to frame k.
Exemplar movingExemplar(const std::vector<float>& stepsPx) {
  const Size size{8, 8};
  Exemplar exemplar(size, static_cast<int>(stepsPx.size()), 0, 2.0F);
  const float wholePx = std::accumulate(stepsPx.begin(), stepsPx.end(), 0.0F);
  float pastPx = 0.0F;
  for (std::size_t k = 0; k < stepsPx.size(); ++k) {
    pastPx += stepsPx[k];
    exemplar.setColor(static_cast<int>(k), Image<Lab>(size));
    GuideFrame guides = movingRight(size, stepsPx[k]);
    guides.accForward = Image<Vec2>(size, Vec2{pastPx, 0.0F});
    guides.accBackward = Image<Vec2>(size, Vec2{wholePx - pastPx, 0.0F});
    exemplar.setGuides(static_cast<int>(k), guides);
  }
  exemplar.finish();
  return exemplar;
}

/// One pixel that moves right by `speedPx` per frame, with a match in the middle of
/// `movingExemplar`.
class OwedMotion : public ::testing::Test {
 protected:
  void step(const Exemplar& exemplar, float speedPx) {
    const Size one{1, 1};
    const GuideFrame target = movingRight(one, speedPx);
    nnf_ = shift(exemplar, target, nnf_, &owed_);
  }
  [[nodiscard]] int frame() const { return nnf_(0, 0).frame; }
  [[nodiscard]] float owedPx() const { return owed_(0, 0); }

  NearestNeighborField nnf_{Size{1, 1}, Match{4.0F, 4.0F, 0, Rotation{}}};
  Image<float> owed_;
};

TEST_F(OwedMotion, AtAStillPlaceIsNothing) {
  const Exemplar exemplar = movingExemplar(std::vector<float>(40, 0.0F));
  for (int i = 0; i < 25; ++i) {
    step(exemplar, 1.0F);
    ASSERT_EQ(frame(), 0);
    ASSERT_EQ(owedPx(), 0.0F);
  }
  // A search that moves the match to a moving place finds no debt to pay at once
  const Exemplar moving = movingExemplar(std::vector<float>(40, 1.0F));
  step(moving, 1.0F);
  EXPECT_EQ(frame(), 1);
}

TEST_F(OwedMotion, AtAPlaceThatSwingsDoesNotGrow) {
  std::vector<float> stepsPx;
  for (int k = 0; k < 40; ++k) stepsPx.push_back(k % 2 == 0 ? -0.4F : 0.4F);
  const Exemplar exemplar = movingExemplar(stepsPx);
  for (int i = 0; i < 25; ++i) {
    step(exemplar, 1.0F);
    ASSERT_EQ(owedPx(), 0.0F) << i;
  }
}

TEST_F(OwedMotion, KeepsTheTrueSpeedOfSlowTargetsInAMovingRegion) {
  const Exemplar exemplar = movingExemplar(std::vector<float>(40, 2.0F));
  for (int i = 1; i <= 100; ++i) {
    step(exemplar, 0.25F);
    ASSERT_NEAR(static_cast<float>(frame()), 0.125F * static_cast<float>(i), 0.5F);
  }
}

TEST_F(OwedMotion, IsAtMostHalfOfTheStepThatPassesIt) {
  // Still stretches, long and short steps, and some back
  std::vector<float> stepsPx;
  float longestPx = 0.0F;
  for (int k = 0; k < 200; ++k) {
    Random random({3, 0, 0, 0, k, 0});
    const auto drawn = static_cast<float>(random.uniform(-40, 120)) / 40.0F;
    stepsPx.push_back(k % 7 < 2 ? 0.0F : drawn);
    longestPx = std::max(longestPx, std::abs(stepsPx.back()));
  }
  const Exemplar exemplar = movingExemplar(stepsPx);
  float mostPx = 0.0F;
  for (int i = 0; i < 300; ++i) {
    Random random({4, 0, 0, 0, i, 0});
    step(exemplar, static_cast<float>(random.uniform(0, 100)) / 100.0F);
    ASSERT_LE(std::abs(owedPx()), 0.5F * longestPx + 1e-4F) << i;
    mostPx = std::max(mostPx, std::abs(owedPx()));
  }
  EXPECT_GT(mostPx, 0.25F * longestPx);
}

TEST_F(Shift, BackwardsUndoesForwards) {
  const Exemplar exemplar = movingExemplar({0.0F, 1.0F, 0.5F, 2.0F, 1.0F, 0.7F, 1.0F, 0.4F, 1.0F,
                                            1.0F, 0.6F, 1.0F, 1.5F, 1.0F, 1.0F, 1.0F});
  const Size one{1, 1};
  for (const float speedPx : {0.1F, 0.3F, 0.9F, 1.7F}) {
    for (const float turn : {1.0F, -1.0F}) {  // with the exemplar's flow, and against it
      SCOPED_TRACE(turn * speedPx);
      GuideFrame step = movingRight(one, turn * speedPx);
      step.direction(0, 0) = {turn, 0.0F};
      const NearestNeighborField first(one, Match{4.0F, 4.0F, 7, Rotation{}});
      Image<float> owed;
      const NearestNeighborField moved = shift(exemplar, step, first, &owed);
      const NearestNeighborField back = shiftBack(exemplar, step.mask, step, moved, &owed);
      EXPECT_EQ(back(0, 0).frame, 7);
      EXPECT_NEAR(owed(0, 0), 0.0F, 1e-5F);
    }
  }
}

TEST_F(Shift, BackwardsToPixelsOfTheEarlierMaskOnly) {
  const Size two{2, 1};
  GuideFrame next = movingRight(two, 1.0F);
  Mask mask(two);
  mask(1, 0) = 1;
  const NearestNeighborField matches(two, Match{28.0F, 20.0F, 4, Rotation{}});
  const NearestNeighborField shifted = shiftBack(exemplar_, mask, next, matches);
  EXPECT_FALSE(shifted(0, 0).exists());
  EXPECT_TRUE(shifted(1, 0).exists());
  EXPECT_LT(shifted(1, 0).frame, 4);
}

}  // namespace
}  // namespace fluidymation
