#include "fluidymation/synthesis/patchmatch.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/vote.h"
#include "patchmatch_fixture.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

/// One frame of the exemplar as its own target, turned by a quarter: every pixel has a perfect
/// match, known in advance, and one of them is given. Whatever else is found, a random search that
/// draws once per pixel did not find.
class Propagation : public ::testing::Test {
 protected:
  static constexpr int kFrame = 2;
  static constexpr int kMiddle = 64;  // of the disc, and the first pixel of a tile

  Propagation() {
    options_.lambda = 0.0F;
    options_.patchmatchAlpha = 0.001F;
    const Image<Lab> original = test::paintedDisc(disc_, kFrame, 20);
    for (int y = 0; y < disc_.size.height; ++y) {
      for (int x = 0; x < disc_.size.width; ++x) {
        if (!target_.inside(x, y)) continue;
        const Match p = perfect(x, y);
        target_.picture(x, y) = FixedLab::of(original.clamped(p.nearestX(), p.nearestY()));
      }
    }
  }

  /// R_-90 about the middle.
  [[nodiscard]] static Match perfect(int x, int y) {
    return {static_cast<float>(kMiddle + (y - kMiddle)),
            static_cast<float>(kMiddle - (x - kMiddle)), kFrame, Rotation{0.0F, 1.0F}};
  }

  /// Random matches but for a perfect one at (x, y), after sweep number `pass`.
  [[nodiscard]] NearestNeighborField sweptFrom(int x, int y, int pass) const {
    const SearchProblem problem{exemplar_.level(0), expectedUse_, target_, options_, Place{}};
    NearestNeighborField nnf(target_.size());
    repair(problem, -1, nnf);
    nnf(x, y) = perfect(x, y);
    findNearestNeighbors(problem, {1.0F, 5.0F, 0.1F, 0.0F}, 1, pass, nnf);
    return nnf;
  }

  [[nodiscard]] static bool isPerfect(const NearestNeighborField& nnf, int x, int y) {
    const Match& found = nnf(x, y);
    const Match wanted = perfect(x, y);
    return found.x == wanted.x && found.y == wanted.y && found.frame == wanted.frame &&
           found.rotation.cosine == wanted.rotation.cosine &&
           found.rotation.sine == wanted.rotation.sine;
  }

  test::GrowingDisc disc_{Size{129, 129}, {64.0F, 64.0F}, 26.0F, 1.0F, 4};
  Exemplar exemplar_ = test::discExemplar(disc_, 0, kBorderWidthPx, 20);
  ExpectedUse expectedUse_{exemplar_.level(0), 10};
  TargetLevel target_{finestLevel(disc_.guides(kFrame)), kBorderWidthPx};
  SynthesisOptions options_;
};

TEST_F(Propagation, MovesANeighboursPlaceByTheStepTurnedBack) {
  const NearestNeighborField nnf = sweptFrom(70, 70, 0);
  for (int step = 0; step < 8; ++step) {
    EXPECT_TRUE(isPerfect(nnf, 70 + step, 70)) << step;
    EXPECT_TRUE(isPerfect(nnf, 70, 70 + step)) << step;
    EXPECT_TRUE(isPerfect(nnf, 70 + step, 70 + step)) << step;
  }
}

TEST_F(Propagation, RunsRightAndDownOnEvenSweepsLeftAndUpOnOddOnes) {
  const NearestNeighborField even = sweptFrom(75, 75, 0);
  EXPECT_TRUE(isPerfect(even, 78, 75));
  EXPECT_TRUE(isPerfect(even, 75, 78));
  EXPECT_FALSE(isPerfect(even, 72, 75));
  EXPECT_FALSE(isPerfect(even, 75, 72));
  const NearestNeighborField odd = sweptFrom(75, 75, 1);
  EXPECT_TRUE(isPerfect(odd, 72, 75));
  EXPECT_TRUE(isPerfect(odd, 75, 72));
  EXPECT_FALSE(isPerfect(odd, 78, 75));
  EXPECT_FALSE(isPerfect(odd, 75, 78));
}

TEST_F(Propagation, CrossesTheEdgesOfTilesWithinOneSweep) {
  const NearestNeighborField right = sweptFrom(kMiddle - 1, 70, 0);
  EXPECT_TRUE(isPerfect(right, kMiddle, 70));
  EXPECT_TRUE(isPerfect(right, kMiddle + 5, 70));
  const NearestNeighborField down = sweptFrom(70, kMiddle - 1, 0);
  EXPECT_TRUE(isPerfect(down, 70, kMiddle));
  EXPECT_TRUE(isPerfect(down, 70, kMiddle + 5));
  const NearestNeighborField left = sweptFrom(kMiddle, 70, 1);
  EXPECT_TRUE(isPerfect(left, kMiddle - 1, 70));
  const NearestNeighborField up = sweptFrom(70, kMiddle, 1);
  EXPECT_TRUE(isPerfect(up, 70, kMiddle - 1));
}

}  // namespace
}  // namespace fluidymation
