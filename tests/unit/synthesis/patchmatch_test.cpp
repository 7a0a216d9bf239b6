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
#include "synthesis/tile_sweep.h"

namespace fluidymation {
namespace {

TEST_F(PatchMatchTest, EveryMatchIsLegal) {
  NearestNeighborField nnf = randomField();
  findNearestNeighbors(problem(), weights_, 4, 0, nnf);
  for (int y = 0; y < nnf.height(); ++y) {
    for (int x = 0; x < nnf.width(); ++x) {
      ASSERT_EQ(nnf(x, y).exists(), target_.inside(x, y));
      if (!target_.inside(x, y)) continue;
      ASSERT_TRUE(exemplar_.level(0).isLegal(nnf(x, y), target_.segment(x, y))) << x << ' ' << y;
      ASSERT_NEAR(std::hypot(nnf(x, y).rotation.cosine, nnf(x, y).rotation.sine), 1.0F, 1e-4F);
    }
  }
}

TEST_F(PatchMatchTest, NoPixelGetsWorseWithoutUniformityWhileThePictureStays) {
  options_.coherenceWeight = 0.0F;  // for it a pixel may take what looks worse
  options_.lambda = 0.0F;
  Mask changing;
  NearestNeighborField nnf = randomField();
  Image<float> before = matchErrors(problem(), weights_, nnf);
  for (int pass = 0; pass < 5; ++pass) {
    findNearestNeighbors(problem(), weights_, 1, pass, nnf, Candidates::kAll, &changing);
    Image<float> after = matchErrors(problem(), weights_, nnf);
    int improved = 0;
    for (int y = 0; y < nnf.height(); ++y) {
      for (int x = 0; x < nnf.width(); ++x) {
        if (!target_.inside(x, y)) continue;
        ASSERT_LE(after(x, y), before(x, y)) << "pass " << pass << " at " << x << ", " << y;
        improved += after(x, y) < before(x, y) ? 1 : 0;
      }
    }
    EXPECT_GT(improved, 0) << "pass " << pass;
    before = std::move(after);
  }
}

TEST_F(PatchMatchTest, ComesCloseToBruteForceOnASmallCase) {
  options_.lambda = 0.0F;
  NearestNeighborField nnf = randomField();
  findNearestNeighbors(problem(), weights_, 8, 0, nnf);
  const Image<float> found = matchErrors(problem(), weights_, nnf);
  const PatchDistance distance(exemplar_.level(0), target_, weights_);
  double bruteSum = 0.0;
  double foundSum = 0.0;
  TargetWindow window;
  for (int y = 10; y < 70; y += 6) {
    for (int x = 15; x < 75; x += 6) {
      if (!target_.inside(x, y)) continue;
      distance.gather(x, y, window);
      float best = INFINITY;
      for (const std::uint32_t i : exemplar_.level(0).candidates(target_.segment(x, y))) {
        const ExemplarLevel::Position p = exemplar_.level(0).position(i);
        const Rotation aligned = alignedRotation(problem(), x, y, p.x, p.y, p.frame);
        for (const Rotation& rotation : {aligned, aligned.opposite()}) {
          const Match match{static_cast<float>(p.x), static_cast<float>(p.y), p.frame, rotation};
          best = std::min(best, distance(window, match, INFINITY));
        }
      }
      bruteSum += best;
      foundSum += found(x, y);
    }
  }
  // Propagated matches have rotations and sub-pixel positions that the brute force does not try,
  // so that the search may even win.
  EXPECT_LT(foundSum, 1.1 * bruteSum);
}

TEST_F(PatchMatchTest, WithoutColourWeightThePictureDoesNotMatter) {
  weights_ = {0.0F, 5.0F, 0.1F, 0.0F};
  NearestNeighborField first = randomField();
  findNearestNeighbors(problem(), weights_, 3, 0, first);
  target_.picture = pictureFor(target_, 99);
  NearestNeighborField second = randomField();
  findNearestNeighbors(problem(), weights_, 3, 0, second);
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.pixelCount() * sizeof(Match)), 0);

  // and the guides are followed: the guide terms alone have become much smaller
  const auto guideTerms = [&](const NearestNeighborField& nnf) {
    options_.lambda = 0.0F;
    return energy(nnf);
  };
  EXPECT_LT(guideTerms(second), 0.2 * guideTerms(randomField()));
}

TEST_F(PatchMatchTest, TheOppositeRotationIsTriedToo) {
  // The exemplar's own frame as target, but said to flow the other way: only a match turned by half
  // a turn against the aligned one reproduces it.
  options_.lambda = 0.0F;
  weights_ = {1.0F, 5.0F, 0.0F, 0.0F};  // no extents: they are exchanged for opposite directions
  target_ = TargetLevel(finestLevel(sourceDisc_.guides(3)), kBorderWidthPx);
  target_.picture = test::fixedPicture(test::paintedDisc(sourceDisc_, 3, 20), target_.segment);
  for (Vec2& direction : target_.direction) direction = -1.0F * direction;
  NearestNeighborField nnf = randomField();
  findNearestNeighbors(problem(), weights_, 12, 0, nnf);
  const Image<float> errors = matchErrors(problem(), weights_, nnf);
  int inside = 0;
  int reproduced = 0;
  for (int y = 0; y < errors.height(); ++y) {
    for (int x = 0; x < errors.width(); ++x) {
      if (!target_.inside(x, y)) continue;
      ++inside;
      reproduced += errors(x, y) < 0.1F ? 1 : 0;
    }
  }
  EXPECT_GT(reproduced, 0.7 * inside);
}

TEST_F(PatchMatchTest, TheUniformityTermIsLambdaTimesMeanUseOverExpectedUse) {
  const NearestNeighborField nnf = randomField();
  const Image<float> with = matchErrors(problem(), weights_, nnf);
  const float lambda = options_.lambda;
  options_.lambda = 0.0F;
  const Image<float> without = matchErrors(problem(), weights_, nnf);
  OccurrenceMap map(sourceDisc_.size, sourceDisc_.frameCount, options_.occRadiusFrames);
  map.rebuild(nnf);
  for (const auto& [x, y] : {std::pair{45, 40}, std::pair{30, 40}, std::pair{45, 68}}) {
    const float meanUse = static_cast<float>(map.windowSum(nnf(x, y))) / kPatchArea;
    const float expected = lambda * meanUse / expectedUse_.best(target_, target_.segment(x, y));
    EXPECT_NEAR(with(x, y) - without(x, y), expected, 1e-3F * (expected + without(x, y)));
  }
}

TEST_F(PatchMatchTest, ErrorsBelowTheirBoundsAreExactAndOthersInfinite) {
  const NearestNeighborField nnf = randomField();
  for (const DistanceWeights& weights : {weights_, DistanceWeights{1.0F, 5.0F, 0.1F, 1.0F, 2.0F}}) {
    const Image<float> errors = matchErrors(problem(), weights, nnf);
    Image<float> bounds(nnf.size());
    for (int y = 0; y < bounds.height(); ++y) {
      for (int x = 0; x < bounds.width(); ++x) {
        Random random({81, 0, 0, 0, x, y});
        const int percent = random.uniform(0, 200);  // 0: not wanted; 100: not below it
        bounds(x, y) = std::isinf(errors(x, y)) || percent == 200
                           ? INFINITY
                           : static_cast<float>(percent) / 100.0F * errors(x, y);
      }
    }
    const Image<float> bounded = matchErrors(problem(), weights, nnf, &bounds);
    int exact = 0;
    int beyond = 0;
    for (std::size_t i = 0; i < errors.pixelCount(); ++i) {
      const float error = errors.data()[i];
      if (error < bounds.data()[i]) {
        ASSERT_EQ(bounded.data()[i], error);
        ++exact;
      } else {
        ASSERT_EQ(bounded.data()[i], INFINITY);
        ++beyond;
      }
    }
    EXPECT_GT(exact, 1000);
    EXPECT_GT(beyond, 1000);
    std::fill(bounds.begin(), bounds.end(), INFINITY);
    const Image<float> unbounded = matchErrors(problem(), weights, nnf, &bounds);
    EXPECT_EQ(std::memcmp(unbounded.data(), errors.data(), errors.pixelCount() * sizeof(float)), 0);
  }
}

TEST_F(PatchMatchTest, UniformityLowersTheEnergyAndSpreadsTheUse) {
  const auto mostUsed = [&](float lambda) {
    options_.lambda = lambda;
    NearestNeighborField nnf = randomField();
    findNearestNeighbors(problem(), weights_, 6, 0, nnf);
    OccurrenceMap map(sourceDisc_.size, sourceDisc_.frameCount, options_.occRadiusFrames);
    map.rebuild(nnf);
    double sum = 0.0;
    for (const Match& match : nnf) sum += match.exists() ? map.windowSum(match) : 0.0;
    return sum;
  };
  EXPECT_LT(mostUsed(50.0F), 0.8 * mostUsed(0.0F));
}

TEST_F(PatchMatchTest, EnergyFallsWithTheDefaultUniformityToo) {
  NearestNeighborField nnf = randomField();
  const double before = energy(nnf);
  findNearestNeighbors(problem(), weights_, 4, 0, nnf);
  EXPECT_LT(energy(nnf), 0.6 * before);
}

TEST_F(PatchMatchTest, TheMatchesOfASmallTargetSettle) {
  // Few uses of a large exemplar: one use more or less is much
  const test::GrowingDisc large{Size{120, 110}, {60.0F, 55.0F}, 30.0F, 1.0F, 12};
  const Exemplar exemplar = test::discExemplar(large, 0, kBorderWidthPx, 20);
  const ExpectedUse expectedUse(exemplar.level(0), options_.occRadiusFrames);
  const test::GrowingDisc small{Size{36, 36}, {18.0F, 18.0F}, 8.0F, 1.0F, 3};
  TargetLevel target(finestLevel(small.guides(1)), kBorderWidthPx);
  target.picture = pictureFor(target, 21);
  const SearchProblem few{exemplar.level(0), expectedUse, target, options_, Place{}};
  NearestNeighborField nnf(target.size());
  repair(few, -1, nnf);
  findNearestNeighbors(few, weights_, 7, 0, nnf);
  const NearestNeighborField before = nnf.clone();
  findNearestNeighbors(few, weights_, 1, 7, nnf);
  int inside = 0;
  int changed = 0;
  for (int y = 0; y < nnf.height(); ++y) {
    for (int x = 0; x < nnf.width(); ++x) {
      if (!target.inside(x, y)) continue;
      const Match& a = before(x, y);
      const Match& b = nnf(x, y);
      ++inside;
      changed += a.x == b.x && a.y == b.y && a.frame == b.frame ? 0 : 1;
    }
  }
  EXPECT_LT(changed, 0.15 * inside);
}

TEST_F(PatchMatchTest, SameBytesForAnyNumberOfThreads) {
  ASSERT_GE(occupiedTiles(target_).size(), 4U);
  const int defaultThreads = omp_get_max_threads();
  NearestNeighborField reference;
  for (const int threads : {1, 2, 7}) {
    SCOPED_TRACE(threads);
    omp_set_num_threads(threads);
    NearestNeighborField nnf = randomField();
    findNearestNeighbors(problem(), weights_, 3, 0, nnf);
    if (reference.empty()) {
      reference = std::move(nnf);
    } else {
      EXPECT_EQ(std::memcmp(reference.data(), nnf.data(), nnf.pixelCount() * sizeof(Match)), 0);
    }
  }
  omp_set_num_threads(defaultThreads);
}

TEST_F(PatchMatchTest, NeighboursAloneKeepEveryMatchLegalAndMakeNoPixelWorse) {
  options_.coherenceWeight = 0.0F;  // for it a pixel may take what looks worse
  options_.lambda = 0.0F;
  NearestNeighborField nnf = randomField();
  Image<float> before = matchErrors(problem(), weights_, nnf);
  const double energyAtFirst = energy(nnf);
  for (int pass = 0; pass < 4; ++pass) {
    findNearestNeighbors(problem(), weights_, 1, pass, nnf, Candidates::kNeighbors);
    Image<float> after = matchErrors(problem(), weights_, nnf);
    for (int y = 0; y < nnf.height(); ++y) {
      for (int x = 0; x < nnf.width(); ++x) {
        ASSERT_EQ(nnf(x, y).exists(), target_.inside(x, y));
        if (!target_.inside(x, y)) continue;
        ASSERT_TRUE(exemplar_.level(0).isLegal(nnf(x, y), target_.segment(x, y))) << x << ' ' << y;
        ASSERT_LE(after(x, y), before(x, y)) << "pass " << pass << " at " << x << ", " << y;
      }
    }
    before = std::move(after);
  }
  EXPECT_LT(energy(nnf), 0.8 * energyAtFirst);
}

TEST_F(PatchMatchTest, NeighboursAloneGiveSameBytesForAnyNumberOfThreads) {
  ASSERT_GE(occupiedTiles(target_).size(), 4U);
  const int defaultThreads = omp_get_max_threads();
  std::vector<NearestNeighborField> fields;
  for (const int threads : {1, 4}) {
    omp_set_num_threads(threads);
    fields.push_back(randomField());
    findNearestNeighbors(problem(), weights_, 3, 0, fields.back(), Candidates::kNeighbors);
  }
  omp_set_num_threads(defaultThreads);
  EXPECT_EQ(std::memcmp(fields[0].data(), fields[1].data(), fields[0].pixelCount() * sizeof(Match)),
            0);
}

TEST_F(PatchMatchTest, StatisticsCountDistancesAndTheSamplesComparedInThem) {
  constexpr std::uint64_t kFewestSamples = 8;  // compared before the first look at the bound
  const int defaultThreads = omp_get_max_threads();
  std::vector<SearchStatistics> ofThreads;
  for (const int threads : {1, 3}) {
    omp_set_num_threads(threads);
    NearestNeighborField nnf = randomField();
    ofThreads.push_back(findNearestNeighbors(problem(), weights_, 2, 0, nnf));
  }
  omp_set_num_threads(defaultThreads);
  const SearchStatistics& done = ofThreads.front();
  EXPECT_GT(done.distances, target_.borderCount + target_.interiorCount);
  EXPECT_GE(done.samples, kFewestSamples * done.distances);
  EXPECT_LT(done.samples, std::uint64_t{kPatchArea} * done.distances) << "none stopped early";
  EXPECT_EQ(ofThreads[1].distances, done.distances);
  EXPECT_EQ(ofThreads[1].samples, done.samples);

  NearestNeighborField nnf = randomField();
  const SearchStatistics ofNeighbors =
      findNearestNeighbors(problem(), weights_, 2, 0, nnf, Candidates::kNeighbors);
  EXPECT_GT(ofNeighbors.distances, 0U);
  EXPECT_LT(ofNeighbors.distances, done.distances / 2);
  EXPECT_EQ(findNearestNeighbors(problem(), weights_, 0, 0, nnf).distances, 0U);
}

TEST_F(PatchMatchTest, AnotherSeedFindsAnotherField) {
  NearestNeighborField first = randomField();
  findNearestNeighbors(problem(), weights_, 1, 0, first);
  options_.seed = 1;
  NearestNeighborField second = randomField();
  findNearestNeighbors(problem(), weights_, 1, 0, second);
  EXPECT_NE(std::memcmp(first.data(), second.data(), first.pixelCount() * sizeof(Match)), 0);
}

TEST_F(PatchMatchTest, RepairMovesIllegalMatchesToTheNearestLegalPixel) {
  NearestNeighborField nnf = randomField();
  // Interior target pixel, match 2 px inside the exemplar's rim: border segment (radius 12 at
  // frame 3, interior up to 7 px from the centre).
  ASSERT_EQ(target_.segment(45, 40), Segment::kInterior);
  nnf(45, 40) = {30.0F, 18.0F, 3, {0.0F, 1.0F}};
  repair(problem(), -2, nnf);
  EXPECT_EQ(nnf(45, 40).frame, 3);
  EXPECT_NEAR(nnf(45, 40).x, 27.0F, 1.0F);
  EXPECT_NEAR(nnf(45, 40).y, 18.0F, 1.0F);
  EXPECT_EQ(nnf(45, 40).rotation.sine, 1.0F);  // kept
  EXPECT_TRUE(exemplar_.level(0).isLegal(nnf(45, 40), Segment::kInterior));
}

TEST_F(PatchMatchTest, RepairDrawsAnewWhatIsFarFromLegal) {
  NearestNeighborField nnf = randomField();
  nnf(45, 40) = {0.0F, 0.0F, 0, Rotation{}};
  nnf(0, 0) = {20.0F, 18.0F, 0, Rotation{}};  // outside the target's mask
  repair(problem(), -2, nnf);
  EXPECT_TRUE(exemplar_.level(0).isLegal(nnf(45, 40), Segment::kInterior));
  EXPECT_FALSE(nnf(0, 0).exists());
}

TEST_F(PatchMatchTest, WithoutInteriorInTheExemplarAnyMaskPixelServes) {
  const test::GrowingDisc thin{Size{40, 36}, {20.0F, 18.0F}, 4.0F, 0.0F, 2};
  const Exemplar exemplar = test::discExemplar(thin, 0, kBorderWidthPx, 20);
  const ExpectedUse expectedUse(exemplar.level(0), 10);
  ASSERT_FALSE(exemplar.level(0).segmented());
  const SearchProblem problem{exemplar.level(0), expectedUse, target_, options_, Place{}};
  NearestNeighborField nnf(target_.size());
  repair(problem, -1, nnf);
  findNearestNeighbors(problem, weights_, 2, 0, nnf);
  EXPECT_TRUE(nnf(45, 40).exists());
  EXPECT_TRUE(std::isfinite(matchErrors(problem, weights_, nnf)(45, 40)));
}

TEST_F(PatchMatchTest, MatchesCrossBetweenSegmentsThatAreNotHard) {
  const ShapeRules rules{ShapeGuide::kEdgeDistance, false, ModulationDistance::kClamped};
  const Exemplar exemplar = test::discExemplar(sourceDisc_, 0, kBorderWidthPx, 20, rules);
  const ExemplarLevel& level = exemplar.level(0);
  ASSERT_TRUE(level.segmented());
  EXPECT_EQ(level.candidates(Segment::kBorder).size(), level.candidates(Segment::kInterior).size());
  EXPECT_EQ(level.candidates(Segment::kBorder).size(),
            level.pixelsOf(Segment::kBorder).size() + level.pixelsOf(Segment::kInterior).size());
  // What uniform use means is still told for each segment by itself, as in P§3.5
  const ExpectedUse expectedUse(level, 10);
  for (const Segment segment : {Segment::kBorder, Segment::kInterior}) {
    EXPECT_EQ(expectedUse.best(target_, segment), expectedUse_.best(target_, segment));
  }
  const SearchProblem problem{level, expectedUse, target_, options_, Place{3, 1, {}}};
  NearestNeighborField nnf(target_.size());
  repair(problem, -1, nnf);
  findNearestNeighbors(problem, {1.0F, 0.0F, 0.1F, 1.0F}, 2, 0, nnf);
  int crossed = 0;
  for (int y = 0; y < nnf.height(); ++y) {
    for (int x = 0; x < nnf.width(); ++x) {
      if (!target_.inside(x, y)) continue;
      const Match& match = nnf(x, y);
      const Segment found = level.segment(match.nearestX(), match.nearestY(), match.frame);
      ASSERT_NE(found, Segment::kOutside);
      crossed += found != target_.segment(x, y) ? 1 : 0;
    }
  }
  EXPECT_GT(crossed, 100);
}

}  // namespace
}  // namespace fluidymation
