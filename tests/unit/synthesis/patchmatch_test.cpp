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
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderWidthPx = 5.0F;

/// A small search: the target is one frame of another disc with a texture of its own.
class PatchMatchTest : public ::testing::Test {
 protected:
  PatchMatchTest() { target_.picture = pictureFor(target_, 21); }

  [[nodiscard]] static Image<FixedLab> pictureFor(const TargetLevel& target, std::uint64_t seed) {
    return test::fixedPicture(test::randomTexture(target.size(), seed), target.segment);
  }

  [[nodiscard]] SearchProblem problem() const {
    return {exemplar_.level(0), expectedUse_, target_, options_, Place{3, 1, {}}};
  }

  [[nodiscard]] NearestNeighborField randomField() const {
    NearestNeighborField nnf(target_.size());
    repair(problem(), -1, nnf);
    return nnf;
  }

  [[nodiscard]] double energy(const NearestNeighborField& nnf) const {
    const Image<float> errors = matchErrors(problem(), weights_, nnf);
    double sum = 0.0;
    for (int y = 0; y < errors.height(); ++y) {
      for (int x = 0; x < errors.width(); ++x) {
        if (target_.inside(x, y)) sum += errors(x, y);
      }
    }
    return sum;
  }

  test::GrowingDisc sourceDisc_{Size{40, 36}, {20.0F, 18.0F}, 9.0F, 1.0F, 6};
  test::GrowingDisc targetDisc_{Size{90, 80}, {45.0F, 40.0F}, 30.0F, 1.0F, 3};
  Exemplar exemplar_ = test::discExemplar(sourceDisc_, 0, kBorderWidthPx, 20);
  ExpectedUse expectedUse_{exemplar_.level(0), 10};
  TargetLevel target_{finestLevel(targetDisc_.guides(1)), kBorderWidthPx};
  SynthesisOptions options_;
  DistanceWeights weights_{1.0F, 5.0F, 0.1F, 1.0F};
};

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
  ASSERT_GT(targetDisc_.size.width, kTileSidePx);
  ASSERT_GT(targetDisc_.size.height, kTileSidePx);
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

TEST_F(PatchMatchTest, LeavingSearchEffortAloneCostsLessAndLosesLittle) {
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
      target_.picture = vote(exemplar_.level(0), target_.segment, nnf);
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
