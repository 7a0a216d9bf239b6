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

bool sameBytes(const NearestNeighborField& a, const NearestNeighborField& b) {
  return std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Match)) == 0;
}

bool sameMatch(const Match& a, const Match& b) {
  return a.x == b.x && a.y == b.y && a.frame == b.frame && a.rotation.cosine == b.rotation.cosine &&
         a.rotation.sine == b.rotation.sine;
}

/// A target within one tile.
class OneTileTest : public PatchMatchTest {
 protected:
  OneTileTest() {
    targetDisc_ = {Size{60, 56}, {30.0F, 28.0F}, 20.0F, 1.0F, 3};
    target_ = TargetLevel(finestLevel(targetDisc_.guides(1)), kBorderWidthPx);
    target_.picture = pictureFor(target_, 21);
    options_.lambda = 0.0F;
    options_.searchEffort = SearchEffort::kEverywhere;
  }
};

TEST_F(OneTileTest, NotTryingAgainWhatHasLostChangesNothing) {
  // Within one search a sweep leaves out neighbours' matches that were tried before; the first
  // sweep of a search tries them all. The pictures being the same, so are the results, where
  // uniformity does not change what a match costs.
  ASSERT_LE(targetDisc_.size.width, kTileSidePx);
  ASSERT_LE(targetDisc_.size.height, kTileSidePx);
  constexpr int kSweeps = 8;
  for (const Candidates candidates : {Candidates::kAll, Candidates::kNeighbors}) {
    NearestNeighborField atOnce = randomField();
    const SearchStatistics done =
        findNearestNeighbors(problem(), weights_, kSweeps, 0, atOnce, candidates);
    NearestNeighborField oneByOne = randomField();
    SearchStatistics doneOneByOne;
    for (int pass = 0; pass < kSweeps; ++pass) {
      doneOneByOne += findNearestNeighbors(problem(), weights_, 1, pass, oneByOne, candidates);
    }
    EXPECT_TRUE(sameBytes(atOnce, oneByOne));
    EXPECT_LT(done.distances, doneOneByOne.distances);
  }
}

TEST_F(PatchMatchTest, NotTryingAgainWhatHasLostChangesNothingAcrossTiles) {
  ASSERT_GT(targetDisc_.size.width, kTileSidePx);
  ASSERT_GT(targetDisc_.size.height, kTileSidePx);
  options_.lambda = 0.0F;
  options_.searchEffort = SearchEffort::kEverywhere;
  constexpr int kSweeps = 8;
  NearestNeighborField atOnce = randomField();
  findNearestNeighbors(problem(), weights_, kSweeps, 0, atOnce);
  NearestNeighborField oneByOne = randomField();
  for (int pass = 0; pass < kSweeps; ++pass) {
    findNearestNeighbors(problem(), weights_, 1, pass, oneByOne);
  }
  EXPECT_TRUE(sameBytes(atOnce, oneByOne));
}

TEST_F(PatchMatchTest, LeavingAloneWhatIsSettledCostsLessAndLosesLittle) {
  // Search and vote in turn, as the synthesis does
  struct Outcome {
    double energy = 0.0;
    SearchStatistics statistics;
  };
  const auto optimized = [&](SearchEffort settled) {
    options_.searchEffort = settled;
    target_.picture = pictureFor(target_, 21);
    NearestNeighborField nnf = randomField();
    Outcome outcome;
    Mask changing;
    constexpr int kRounds = 3;
    constexpr int kSweeps = 4;
    for (int i = 0; i < kRounds; ++i) {
      outcome.statistics += findNearestNeighbors(problem(), weights_, kSweeps, kSweeps * i, nnf,
                                                 Candidates::kAll, &changing);
      target_.picture = vote(exemplar_.level(0), target_.segment, nnf, 0.0F);
    }
    outcome.energy = energy(nnf);
    return outcome;
  };
  const Outcome searched = optimized(SearchEffort::kEverywhere);
  const Outcome leftAlone = optimized(SearchEffort::kWhereItChanges);
  EXPECT_LT(leftAlone.energy, 1.05 * searched.energy);
  EXPECT_LT(static_cast<double>(leftAlone.statistics.distances),
            0.7 * static_cast<double>(searched.statistics.distances));
}

TEST_F(PatchMatchTest, ChangingIsWhereTheLastSweepChangedTheMatch) {
  for (const SearchEffort settled : {SearchEffort::kEverywhere, SearchEffort::kWhereItChanges}) {
    options_.searchEffort = settled;
    NearestNeighborField nnf = randomField();
    Mask changing;
    for (int pass = 0; pass < 3; ++pass) {
      const NearestNeighborField before = nnf.clone();
      findNearestNeighbors(problem(), weights_, 1, pass, nnf, Candidates::kAll, &changing);
      ASSERT_EQ(changing.size(), nnf.size());
      for (int y = 0; y < nnf.height(); ++y) {
        for (int x = 0; x < nnf.width(); ++x) {
          ASSERT_EQ(changing(x, y) != 0, !sameMatch(before(x, y), nnf(x, y))) << x << ", " << y;
        }
      }
    }
    // Of several sweeps it is the last one's
    NearestNeighborField again = randomField();
    Mask last;
    findNearestNeighbors(problem(), weights_, 2, 0, again, Candidates::kAll, &last);
    const NearestNeighborField beforeLast = again.clone();
    findNearestNeighbors(problem(), weights_, 1, 2, again, Candidates::kAll, &last);
    for (std::size_t i = 0; i < again.pixelCount(); ++i) {
      ASSERT_EQ(last.data()[i] != 0, !sameMatch(beforeLast.data()[i], again.data()[i]));
    }
  }
}

TEST_F(PatchMatchTest, NoMaskAndAnEmptyOneSayThatEverythingMayChange) {
  options_.searchEffort = SearchEffort::kWhereItChanges;
  NearestNeighborField without = randomField();
  findNearestNeighbors(problem(), weights_, 3, 0, without);
  NearestNeighborField with = randomField();
  Mask changing;
  findNearestNeighbors(problem(), weights_, 3, 0, with, Candidates::kAll, &changing);
  EXPECT_TRUE(sameBytes(without, with));
}

TEST_F(OneTileTest, OnlyWhatChangesIsSearchedAtRandomWhereTheRestIsLeftAlone) {
  // No neighbour has anything better to offer, in either direction, to a sweep of this kind
  options_.searchEffort = SearchEffort::kWhereItChanges;
  NearestNeighborField settled = randomField();
  findNearestNeighbors(problem(), weights_, 3, 0, settled);
  for (int pass = 4;; pass += 2) {
    ASSERT_LT(pass, 100) << "has to settle";
    const NearestNeighborField before = settled.clone();
    Mask nowhere(settled.size());
    findNearestNeighbors(problem(), weights_, 2, pass, settled, Candidates::kAll, &nowhere);
    if (sameBytes(before, settled)) break;
  }
  const auto searched = [&](SearchEffort which, Mask& mask) {
    options_.searchEffort = which;
    NearestNeighborField nnf = settled.clone();
    findNearestNeighbors(problem(), weights_, 1, 4, nnf, Candidates::kAll, &mask);
    return nnf;
  };
  Mask none(settled.size());
  EXPECT_TRUE(sameBytes(searched(SearchEffort::kWhereItChanges, none), settled));
  EXPECT_EQ(countInside(none), 0U);
  Mask noneOfAll(settled.size());
  EXPECT_FALSE(sameBytes(searched(SearchEffort::kEverywhere, noneOfAll), settled));

  // The sweep goes right and down: what lies above the only place that may change stays
  Mask lower(settled.size());
  constexpr int kFirstRow = 28;
  for (int y = kFirstRow; y < settled.height(); ++y) {
    for (int x = 0; x < settled.width(); ++x) lower(x, y) = 1;
  }
  const NearestNeighborField changed = searched(SearchEffort::kWhereItChanges, lower);
  EXPECT_FALSE(sameBytes(changed, settled));
  for (int y = 0; y < kFirstRow; ++y) {
    for (int x = 0; x < settled.width(); ++x) {
      ASSERT_TRUE(sameMatch(changed(x, y), settled(x, y))) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace fluidymation
