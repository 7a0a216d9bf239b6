#include "fluidymation/synthesis/occurrence.h"

#include <gtest/gtest.h>

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
