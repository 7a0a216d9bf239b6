#include "fluidymation/synthesis/occurrence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "fluidymation/core/random.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr Size kSize{11, 9};
constexpr int kFrames = 7;
constexpr int kRadius = 2;

NearestNeighborField randomMatches(int count, std::uint64_t seed) {
  NearestNeighborField nnf(Size{count, 1});
  for (int i = 0; i < count; ++i) {
    Random random({seed, 0, 0, 0, i, 0});
    nnf(i, 0) = {static_cast<float>(random.uniform(-1, kSize.width)) + 0.3F,
                 static_cast<float>(random.uniform(-1, kSize.height)) - 0.3F,
                 random.uniform(0, kFrames - 1), Rotation{}};
  }
  return nnf;
}

/// Omega by its definition, then the sum over the window: quadratic, obvious.
int slowWindowSum(const NearestNeighborField& nnf, int x, int y, int k) {
  int sum = 0;
  for (int wy = y - 2; wy <= y + 2; ++wy) {
    for (int wx = x - 2; wx <= x + 2; ++wx) {
      if (wx < 0 || wy < 0 || wx >= kSize.width || wy >= kSize.height) continue;
      for (const Match& m : nnf) {
        const int mx = std::clamp(m.nearestX(), 0, kSize.width - 1);
        const int my = std::clamp(m.nearestY(), 0, kSize.height - 1);
        sum += std::abs(mx - wx) <= 2 && std::abs(my - wy) <= 2 && std::abs(m.frame - k) <= kRadius
                   ? 1
                   : 0;
      }
    }
  }
  return sum;
}

TEST(Occurrence, WindowSumsFollowTheDefinition) {
  const NearestNeighborField nnf = randomMatches(40, 5);
  OccurrenceMap map(kSize, kFrames, kRadius);
  map.rebuild(nnf);
  for (int k = 0; k < kFrames; ++k) {
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        ASSERT_EQ(map.windowSum(x, y, k), slowWindowSum(nnf, x, y, k)) << x << ' ' << y << ' ' << k;
      }
    }
  }
}

TEST(Occurrence, MapKeptUpToDateEqualsARebuiltOne) {
  NearestNeighborField nnf = randomMatches(40, 6);
  OccurrenceMap kept(kSize, kFrames, kRadius);
  kept.rebuild(nnf);
  const NearestNeighborField replacement = randomMatches(40, 7);
  for (int i = 0; i < 40; i += 3) {
    kept.add(nnf(i, 0), -1);
    nnf(i, 0) = replacement(i, 0);
    kept.add(nnf(i, 0), +1);
  }
  OccurrenceMap rebuilt(kSize, kFrames, kRadius);
  rebuilt.rebuild(nnf);
  for (int k = 0; k < kFrames; ++k) {
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        ASSERT_EQ(kept.windowSum(x, y, k), rebuilt.windowSum(x, y, k));
      }
    }
  }
}

TEST(Occurrence, TheContributionOfAMatchIsWhatTheMapLosesWithIt) {
  NearestNeighborField nnf = randomMatches(40, 8);
  OccurrenceMap with(kSize, kFrames, kRadius);
  with.rebuild(nnf);
  for (int i = 0; i < 40; ++i) {
    const Match own = nnf(i, 0);
    nnf(i, 0) = Match{};
    OccurrenceMap without(kSize, kFrames, kRadius);
    without.rebuild(nnf);
    nnf(i, 0) = own;
    for (int k = 0; k < kFrames; ++k) {
      for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
          const Match there{static_cast<float>(x), static_cast<float>(y), k, Rotation{}};
          ASSERT_EQ(with.contribution(own, there),
                    with.windowSum(x, y, k) - without.windowSum(x, y, k))
              << i << " at " << x << ' ' << y << ' ' << k;
        }
      }
    }
  }
  const Match middle{5.0F, 4.0F, 3, Rotation{}};
  EXPECT_EQ(with.contribution(middle, middle), kPatchArea);
  const Match corner{0.0F, 0.0F, 3, Rotation{}};
  EXPECT_EQ(with.contribution(corner, corner), (kPatchRadius + 1) * (kPatchRadius + 1));
}

TEST(Occurrence, RadiusBeyondTheSequenceCoversAllFrames) {
  OccurrenceMap map(kSize, kFrames, 1000);
  map.add(Match{5.0F, 4.0F, 3, Rotation{}}, +1);
  for (int k = 0; k < kFrames; ++k) EXPECT_EQ(map.windowSum(5, 4, k), kPatchArea);
}

/// `sum(x, y, k)` and `expected(x, y, k)` are at most `tolerance(x, y, k)` apart.
template <typename Sum, typename Expected, typename Tolerance>
void expectSumsNear(Size size, int frames, const Sum& sum, const Expected& expected,
                    const Tolerance& tolerance) {
  for (int k = 0; k < frames; ++k) {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        ASSERT_NEAR(sum(x, y, k), expected(x, y, k), tolerance(x, y, k))
            << x << ' ' << y << ' ' << k;
      }
    }
  }
}

TEST(UseChanges, AreThoseOfTheMapWhereGroupsAreFramesAndWhereTheBoxCoversAllFrames) {
  // Three groups a box: up to radius 2 of one frame each
  for (const int radius : {0, 1, 2, kFrames - 1, kFrames, 1000}) {
    SCOPED_TRACE(radius);
    NearestNeighborField nnf = randomMatches(40, 9);
    const NearestNeighborField replacement = randomMatches(40, 10);
    OccurrenceMap before(kSize, kFrames, radius);
    before.rebuild(nnf);
    UseChanges changes(kSize, kFrames, radius);
    for (int i = 0; i < 40; i += 3) {
      changes.add(nnf(i, 0), -1);
      nnf(i, 0) = replacement(i, 0);
      changes.add(nnf(i, 0), +1);
    }
    OccurrenceMap after(kSize, kFrames, radius);
    after.rebuild(nnf);
    expectSumsNear(
        kSize, kFrames, [&](int x, int y, int k) { return changes.windowSum(x, y, k); },
        [&](int x, int y, int k) { return after.windowSum(x, y, k) - before.windowSum(x, y, k); },
        [](int, int, int) { return 0.0; });
  }
}

/// A longer exemplar, in which boxes are cut into groups of several frames.
constexpr int kManyFrames = 31;
/// Frames of a group, a third of the box.
constexpr int groupFrames(int radius) { return (2 * radius + 1) / 3; }

TEST(UseChanges, AMatchIsCountedExactlyButNearTheEndsOfTheBox) {
  for (const int radius : {3, 5, 10}) {
    // Groups that lie within the box as a whole, and those beyond it, are exact. Of others a share
    // is taken, at least one frame and at most all but one: that is off by less than one use.
    const int group = groupFrames(radius);
    ASSERT_GT(group, 1);
    const double worst = 1.0 - 1.0 / group;
    for (int frame = 0; frame < kManyFrames; ++frame) {
      const Match used{9.2F, 3.7F, frame, Rotation{}};
      UseChanges changes(kSize, kManyFrames, radius);
      changes.add(used, +1);
      OccurrenceMap map(kSize, kManyFrames, radius);
      map.add(used, +1);
      const OccurrenceMap everywhere = [&] {  // as if each box covered all frames
        OccurrenceMap all(kSize, kManyFrames, kManyFrames);
        all.add(used, +1);
        return all;
      }();
      expectSumsNear(
          kSize, kManyFrames, [&](int x, int y, int k) { return changes.windowSum(x, y, k); },
          [&](int x, int y, int k) { return map.windowSum(x, y, k); },
          [&](int x, int y, int k) {
            const int apart = std::abs(k - frame);
            const bool nearTheEnd = apart > radius - group && apart < radius + group;
            // Shares are rounded to single precision, and so are their products
            return nearTheEnd ? (worst + 0x1p-22) * everywhere.windowSum(x, y, k) : 0.0;
          });
    }
  }
}

TEST(UseChanges, UsesInAllFramesAddUpToThoseOfTheMap) {
  // What a share of a group leaves out of one frame it gives to the others
  for (const int radius : {3, 5, 10, 14}) {
    SCOPED_TRACE(radius);
    UseChanges changes(kSize, kManyFrames, radius);
    OccurrenceMap map(kSize, kManyFrames, radius);
    for (int frame = 0; frame < kManyFrames; ++frame) {
      const Match used{4.0F, 5.0F, frame, Rotation{}};
      changes.add(used, +1);
      map.add(used, +1);
    }
    expectSumsNear(
        kSize, kManyFrames, [&](int x, int y, int k) { return changes.windowSum(x, y, k); },
        [&](int x, int y, int k) { return map.windowSum(x, y, k); },
        // At most five groups, each with a rounded share, product and sum
        [&](int x, int y, int k) { return 3 * 5 * 0x1p-24 * map.windowSum(x, y, k); });
  }
}

TEST(UseChanges, TakenBackOrClearedTheyAreZero) {
  const NearestNeighborField nnf = randomMatches(40, 11);
  const auto zero = [](int, int, int) { return 0.0; };
  for (const int radius : {0, 2, 5, 1000}) {
    SCOPED_TRACE(radius);
    UseChanges changes(kSize, kManyFrames, radius);
    const auto sum = [&](int x, int y, int k) { return changes.windowSum(x, y, k); };
    for (const Match& match : nnf) changes.add(match, +1);
    for (const Match& match : nnf) changes.add(match, -1);
    expectSumsNear(kSize, kManyFrames, sum, zero, zero);
    for (const Match& match : nnf) changes.add(match, +1);
    changes.clear();
    expectSumsNear(kSize, kManyFrames, sum, zero, zero);
  }
}

TEST(UseChanges, ClearingIsCheaperFromSomeNumberOfChangesOn) {
  const UseChanges changes(kSize, kFrames, kRadius);
  EXPECT_FALSE(changes.isCheaperToClear(0));
  bool before = false;
  for (std::size_t adds = 0; adds < 1000; ++adds) {
    const bool cheaper = changes.isCheaperToClear(adds);
    ASSERT_TRUE(cheaper || !before) << adds;
    before = cheaper;
  }
  EXPECT_TRUE(before);
}

TEST(Occurrence, ExpectedUseIsTheMeanUnderUniformUse) {
  const test::GrowingDisc disc;
  const Exemplar exemplar = test::discExemplar(disc, 0, 5.0F, 1);
  const ExemplarLevel& level = exemplar.level(0);
  const TargetLevel target(finestLevel(disc.guides(2)), 5.0F);
  for (const Segment segment : {Segment::kBorder, Segment::kInterior}) {
    // Use every pixel of the segment once, and take the mean of what each of them then sees.
    OccurrenceMap map(disc.size, disc.frameCount, 1);
    std::vector<Match> all;
    for (int k = 0; k < disc.frameCount; ++k) {
      for (int y = 0; y < disc.size.height; ++y) {
        for (int x = 0; x < disc.size.width; ++x) {
          if (level.segment(x, y, k) == segment) {
            all.push_back({static_cast<float>(x), static_cast<float>(y), k, Rotation{}});
          }
        }
      }
    }
    for (const Match& match : all) map.add(match, +1);
    double mean = 0.0;
    for (const Match& match : all) mean += map.windowSum(match);
    mean /= static_cast<double>(all.size()) * kPatchArea;
    const double uses =
        static_cast<double>(target.count(segment)) / static_cast<double>(all.size());
    EXPECT_NEAR(ExpectedUse(level, 1).best(target, segment), mean * uses, 1e-4 * mean * uses);
  }
}

}  // namespace
}  // namespace fluidymation
