#include "fluidymation/synthesis/previous_picture.h"

#include <gtest/gtest.h>

#include "fluidymation/synthesis/shape_rules.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

TEST(Smoothstep, RisesFallsAndSaturates) {
  EXPECT_EQ(smoothstep(-1.0F, 0.0F, 2.0F), 0.0F);
  EXPECT_EQ(smoothstep(3.0F, 0.0F, 2.0F), 1.0F);
  EXPECT_FLOAT_EQ(smoothstep(1.0F, 0.0F, 2.0F), 0.5F);
  EXPECT_FLOAT_EQ(smoothstep(0.5F, 0.0F, 2.0F), 3.0F / 16.0F - 2.0F / 64.0F);
}

TEST(Smoothstep, SwappedBoundsFallAsTheModulationNeeds) {
  // |T^dist - S^dist| of 2 px and less keeps the previous frame in full, 10 px and more drops it.
  EXPECT_EQ(smoothstep(0.0F, 10.0F, 2.0F), 1.0F);
  EXPECT_EQ(smoothstep(2.0F, 10.0F, 2.0F), 1.0F);
  EXPECT_FLOAT_EQ(smoothstep(6.0F, 10.0F, 2.0F), 0.5F);
  EXPECT_EQ(smoothstep(10.0F, 10.0F, 2.0F), 0.0F);
  EXPECT_EQ(smoothstep(99.0F, 10.0F, 2.0F), 0.0F);
}

/// One frame of a disc, and matches within it.
class BothNeighbors : public ::testing::Test {
 protected:
  [[nodiscard]] TargetLevel between(const Match& before, const Match& after) const {
    TargetLevel target(finestLevel(disc_.guides(1)), kBorderPx);
    NearestNeighborField first(disc_.size);
    NearestNeighborField second(disc_.size);
    first(24, 20) = before;
    second(24, 20) = after;
    setBothNeighbors(exemplar_.level(0), kBorderPx, {{5.0F, 1.0F}}, first, second, target);
    return target;
  }

  static constexpr float kBorderPx = 10.0F;
  test::GrowingDisc disc_{Size{48, 40}, {24.0F, 20.0F}, 16.0F, 0.0F, 2};
  Exemplar exemplar_ = test::discExemplar(disc_, 0, kBorderPx, 3);
  Match deep_{26.0F, 20.0F, 0, Rotation{}};
  Match alsoDeep_{20.0F, 22.0F, 1, Rotation{}};
  Match nearEdge_{38.0F, 20.0F, 1, Rotation{}};
};

TEST_F(BothNeighbors, OfOneAloneIsWhatThatOneSays) {
  TargetLevel alone(finestLevel(disc_.guides(1)), kBorderPx);
  NearestNeighborField field(disc_.size);
  field(24, 20) = deep_;
  setPrevious(exemplar_.level(0), kBorderPx, {{5.0F, 1.0F}}, field, alone);
  for (const TargetLevel& target : {between(deep_, Match{}), between(Match{}, deep_)}) {
    EXPECT_EQ(target.previous(24, 20).l, alone.previous(24, 20).l);
    EXPECT_EQ(target.modulation(24, 20), alone.modulation(24, 20));
  }
}

TEST_F(BothNeighbors, MeetHalfWayWhereBothCount) {
  const float before = between(deep_, Match{}).previous(24, 20).l;
  const float after = between(Match{}, alsoDeep_).previous(24, 20).l;
  ASSERT_NE(before, after);
  const TargetLevel target = between(deep_, alsoDeep_);
  EXPECT_NEAR(target.previous(24, 20).l, 0.5F * (before + after), 1.0F);
  EXPECT_EQ(target.modulation(24, 20), 1.0F);
}

TEST_F(BothNeighbors, TheOneThatDoesNotCountIsNotHeard) {
  ASSERT_EQ(between(nearEdge_, Match{}).modulation(24, 20), 0.0F);
  const TargetLevel target = between(nearEdge_, deep_);
  EXPECT_NEAR(target.previous(24, 20).l, between(Match{}, deep_).previous(24, 20).l, 5.0F);
  EXPECT_EQ(target.modulation(24, 20), 1.0F);
}

TEST(SetPrevious, ModulationComparesClampedDistances) {
  const test::GrowingDisc disc{Size{48, 40}, {24.0F, 20.0F}, 16.0F, 0.0F, 1};
  constexpr float kBorderWidthPx = 10.0F;
  const Exemplar exemplar = test::discExemplar(disc, 0, kBorderWidthPx, 1);
  TargetLevel target(finestLevel(disc.guides(0)), kBorderWidthPx);
  NearestNeighborField shifted(disc.size);
  shifted(24, 20) = {26.0F, 20.0F, 0, Rotation{}};  // 16 and 14 px deep: equal once clamped at 10
  shifted(36, 20) = {38.0F, 20.0F, 0, Rotation{}};  // 4 and 2 px deep: within m_l
  shifted(30, 20) = {38.0F, 20.0F, 0, Rotation{}};  // 10 and 2 px deep: 8 px apart
  setPrevious(exemplar.level(0), kBorderWidthPx, {{10.0F, 2.0F}}, shifted, target);
  EXPECT_FLOAT_EQ(target.modulation(24, 20), 1.0F);
  EXPECT_FLOAT_EQ(target.modulation(36, 20), 1.0F);
  EXPECT_NEAR(target.modulation(30, 20), 3.0F / 16.0F - 2.0F / 64.0F, 1e-5F);  // v = 1/4
  EXPECT_EQ(target.modulation(20, 20), 0.0F);                                  // no match
  EXPECT_TRUE(target.previous(24, 20).exists());
  EXPECT_FALSE(target.previous(14, 20).exists());
}

/// As above, where the distances count in full: 16 and 14 px are 2 px apart, 16 and 6 px 10.
TEST(SetPrevious, ModulationComparesFullDistancesWhereTheRulesSaySo) {
  const test::GrowingDisc disc{Size{48, 40}, {24.0F, 20.0F}, 16.0F, 0.0F, 1};
  constexpr float kBorderWidthPx = 5.0F;
  for (const ShapeGuide guide : {ShapeGuide::kEdgeDistance, ShapeGuide::kBlurredMask}) {
    for (const bool clamped : {false, true}) {
      const ShapeRules rules{
          guide, true, clamped ? ModulationDistance::kClamped : ModulationDistance::kUnclamped};
      const Exemplar exemplar = test::discExemplar(disc, 0, kBorderWidthPx, 1, rules);
      GuideFrame guides = disc.guides(0);
      guides.shape = Image<float>(disc.size);
      TargetLevel target(finestLevel(guides), kBorderWidthPx, {}, rules);
      NearestNeighborField shifted(disc.size);
      shifted(24, 20) = {34.0F, 20.0F, 0, Rotation{}};  // 16 and 6 px deep: 10 px apart
      shifted(26, 20) = {28.0F, 20.0F, 0, Rotation{}};  // 14 and 12 px deep
      shifted(37, 20) = {24.0F, 20.0F, 0, Rotation{}};  // 3 and 16 px deep: 13 px apart, or 2
      setPrevious(exemplar.level(0), kBorderWidthPx, {{10.0F, 2.0F}}, shifted, target);
      EXPECT_EQ(target.modulation(24, 20), clamped ? 1.0F : 0.0F);
      EXPECT_EQ(target.modulation(26, 20), 1.0F);
      EXPECT_EQ(target.modulation(37, 20), clamped ? 1.0F : 0.0F);
    }
  }
}

TEST(SetPrevious, AStandInOfAShapeWithoutEdgeIsComparedUpToTheBorderWidth) {
  constexpr float kBorderWidthPx = 5.0F;
  const test::GrowingDisc disc{Size{48, 40}, {24.0F, 20.0F}, 16.0F, 0.0F, 1};
  const ShapeRules rules{ShapeGuide::kEdgeDistance, true, ModulationDistance::kUnclamped};
  const Exemplar exemplar = test::discExemplar(disc, 0, kBorderWidthPx, 1, rules);
  GuideFrame full = disc.guides(0);
  full.mask = Mask(disc.size, 1);
  full.distance = Image<float>(disc.size, 88.0F);
  TargetLevel target(finestLevel(full), kBorderWidthPx, {}, rules);
  NearestNeighborField shifted(disc.size);
  shifted(24, 20) = {24.0F, 20.0F, 0, Rotation{}};  // inside is inside, however deep
  shifted(30, 20) = {38.0F, 20.0F, 0, Rotation{}};  // 2 px deep: 3 px apart
  setPrevious(exemplar.level(0), kBorderWidthPx, {{4.0F, 2.0F}}, shifted, target);
  EXPECT_EQ(target.modulation(24, 20), 1.0F);
  EXPECT_NEAR(target.modulation(30, 20), 0.5F, 1e-5F);
}

TEST(ModulationBoundsInPixels, AreMultiplesOfTheirUnit) {
  const ModulationBoundsPx px = inPixels({10.0F, 2.0F, ModulationUnit::kPixels}, 5.0F, {800, 500});
  EXPECT_EQ(px.upper, 10.0F);
  EXPECT_EQ(px.lower, 2.0F);
  const ModulationBounds widths{0.7F, 0.15F, ModulationUnit::kBorderWidths};
  EXPECT_FLOAT_EQ(inPixels(widths, 20.0F, {800, 500}).upper, 14.0F);
  EXPECT_FLOAT_EQ(inPixels(widths, 20.0F, {800, 500}).lower, 3.0F);
  const ModulationBounds sides{0.1F, 0.01F, ModulationUnit::kTargetSides};
  EXPECT_FLOAT_EQ(inPixels(sides, 20.0F, {800, 500}).upper, 80.0F);
  EXPECT_FLOAT_EQ(inPixels(sides, 20.0F, {500, 800}).lower, 8.0F);
}

}  // namespace
}  // namespace fluidymation
