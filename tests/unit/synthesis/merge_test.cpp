#include "fluidymation/synthesis/merge.h"

#include <gtest/gtest.h>

#include "fluidymation/synthesis/vote.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderWidthPx = 5.0F;

class MergeTest : public ::testing::Test {
 protected:
  [[nodiscard]] SearchProblem problem() const {
    return {exemplar_.level(0), expectedUse_, target_, options_, Place{}};
  }

  [[nodiscard]] NearestNeighborField field(int pass) const {
    NearestNeighborField nnf(target_.size());
    repair(problem(), pass, nnf);
    return nnf;
  }

  [[nodiscard]] Image<FixedLab> voteOf(const NearestNeighborField& nnf) const {
    return vote(exemplar_.level(0), target_.segment, nnf, options_.optVoteSigmaPx);
  }

  [[nodiscard]] NearestNeighborField merged(const NearestNeighborField& upscaled,
                                            const NearestNeighborField& downscaled) {
    target_.previous = voteOf(downscaled);  // as setPrevious leaves it
    return merge(problem(), weights_, upscaled.clone(), downscaled, target_);
  }

  /// Errors of a field against its own vote.
  [[nodiscard]] Image<float> errorsOf(const NearestNeighborField& nnf) {
    target_.picture = voteOf(nnf);
    return matchErrors(problem(), weights_, nnf);
  }

  test::GrowingDisc sourceDisc_{Size{40, 36}, {20.0F, 18.0F}, 9.0F, 1.0F, 6};
  test::GrowingDisc targetDisc_{Size{48, 44}, {24.0F, 22.0F}, 14.0F, 1.0F, 3};
  Exemplar exemplar_ = test::discExemplar(sourceDisc_, 0, kBorderWidthPx, 20);
  ExpectedUse expectedUse_{exemplar_.level(0), 10};
  TargetLevel target_{finestLevel(targetDisc_.guides(1)), kBorderWidthPx};
  SynthesisOptions options_;
  DistanceWeights weights_{1.0F, 5.0F, 0.1F, 1.0F};
};

bool same(const Match& a, const Match& b) { return a.x == b.x && a.y == b.y && a.frame == b.frame; }

TEST_F(MergeTest, EveryPixelKeepsTheMatchWithTheSmallerErrorOfItsOwnField) {
  const NearestNeighborField a = field(1);
  const NearestNeighborField b = field(2);
  const Image<float> errorsOfA = errorsOf(a);
  const Image<float> errorsOfB = errorsOf(b);
  const NearestNeighborField both = merged(a, b);
  int fromA = 0;
  int fromB = 0;
  for (int y = 0; y < both.height(); ++y) {
    for (int x = 0; x < both.width(); ++x) {
      if (!target_.inside(x, y)) continue;
      const bool takesB = errorsOfB(x, y) < errorsOfA(x, y);
      EXPECT_TRUE(same(both(x, y), takesB ? b(x, y) : a(x, y))) << x << ", " << y;
      ++(takesB ? fromB : fromA);
    }
  }
  EXPECT_GT(fromA, 50);
  EXPECT_GT(fromB, 50);
}

TEST_F(MergeTest, MissingAndIllegalMatchesLose) {
  const NearestNeighborField a = field(1);
  NearestNeighborField b = field(2);
  for (int y = 0; y < b.height(); ++y) {
    for (int x = 0; x < b.width(); ++x) {
      if (!b(x, y).exists()) continue;
      if (x % 2 == 0) b(x, y) = Match{};                   // missing
      if (x % 2 == 1) b(x, y) = Match{0.0F, 0.0F, 0, {}};  // outside the exemplar's mask
    }
  }
  const NearestNeighborField both = merged(a, b);
  const NearestNeighborField exchanged = merged(b, a);
  for (int y = 0; y < both.height(); ++y) {
    for (int x = 0; x < both.width(); ++x) {
      if (!target_.inside(x, y)) continue;
      EXPECT_TRUE(same(both(x, y), a(x, y)));
      EXPECT_TRUE(same(exchanged(x, y), a(x, y)));
    }
  }
}

TEST_F(MergeTest, WhereThePreviousFrameDoesNotReachThePictureGoesOn) {
  const NearestNeighborField a = field(1);
  NearestNeighborField b = field(2);
  for (int y = 0; y < b.height(); ++y) {
    for (int x = 24; x < b.width(); ++x) b(x, y) = Match{};
  }
  const Image<FixedLab> left = voteOf(b);
  const Image<FixedLab> right = voteOf(a);
  (void)merged(a, b);
  // A window reaches kPatchRadius: pixels from 26 on have no vote of the previous frame
  EXPECT_EQ(target_.picture(20, 22).l, left(20, 22).l);
  EXPECT_EQ(target_.picture(30, 22).l, right(30, 22).l);
}

}  // namespace
}  // namespace fluidymation
