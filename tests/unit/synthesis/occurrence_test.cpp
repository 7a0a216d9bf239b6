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

/// Where no match lies beyond the rows that are told of, they may as well be left out; what does
/// lie beyond is not counted.
TEST(Occurrence, CountsTheRowsThatAreToldOf) {
  const NearestNeighborField row = randomMatches(40, 5);
  NearestNeighborField nnf(Size{60, 3});
  NearestNeighborField cut(nnf.size());
  std::copy(row.begin(), row.end(), nnf.row(0) + 11);
  std::copy(row.begin(), row.begin() + 20, nnf.row(2));
  std::copy(row.begin(), row.end(), cut.row(0) + 11);
  std::copy(row.begin(), row.begin() + 15, cut.row(2));
  OccurrenceMap told(kSize, kFrames, kRadius);
  OccurrenceMap whole(kSize, kFrames, kRadius);
  told.rebuild(nnf, {{11, 51}, {60, 60}, {0, 15}});
  whole.rebuild(cut);
  for (int k = 0; k < kFrames; ++k) {
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        ASSERT_EQ(told.windowSum(x, y, k), whole.windowSum(x, y, k));
      }
    }
  }
}

/// A map of the whole volume by the definition, with nothing left out.
class WholeVolume {
 public:
  WholeVolume(Size size, int frames, int radius, const NearestNeighborField& nnf)
      : size_(size), uses_(static_cast<std::size_t>(size.width * size.height * frames)) {
    for (const Match& m : nnf) {
      if (!m.exists()) continue;
      const int mx = std::clamp(m.nearestX(), 0, size.width - 1);
      const int my = std::clamp(m.nearestY(), 0, size.height - 1);
      for (int k = std::max(m.frame - radius, 0); k <= std::min(m.frame + radius, frames - 1);
           ++k) {
        forWindow(mx, my, [&](int x, int y) { ++uses_[at(x, y, k)]; });
      }
    }
  }

  [[nodiscard]] std::int32_t windowSum(int x, int y, int k) const {
    std::int32_t sum = 0;
    forWindow(x, y, [&](int wx, int wy) { sum += uses_[at(wx, wy, k)]; });
    return sum;
  }

 private:
  [[nodiscard]] std::size_t at(int x, int y, int k) const {
    return static_cast<std::size_t>((k * size_.height + y) * size_.width + x);
  }
  template <typename Body>
  void forWindow(int x, int y, const Body& body) const {
    for (int wy = std::max(y - 2, 0); wy <= std::min(y + 2, size_.height - 1); ++wy) {
      for (int wx = std::max(x - 2, 0); wx <= std::min(x + 2, size_.width - 1); ++wx) body(wx, wy);
    }
  }

  Size size_;
  std::vector<std::int32_t> uses_;
};

/// Matches in some clusters, and some pixels without any.
NearestNeighborField clusteredMatches(Size size, int frames, int count, std::uint64_t seed) {
  NearestNeighborField nnf(Size{count, 1});
  Random random({seed, 0, 0, 0, 0, 0});
  Match match;
  for (int i = 0; i < count; ++i) {
    if (i % 7 == 0) {
      match = {static_cast<float>(random.uniform(-1, size.width)),
               static_cast<float>(random.uniform(-1, size.height)), random.uniform(0, frames - 1),
               Rotation{}};
    }
    match.x += 1.0F;
    if (random.uniform(0, 5) != 0) nnf(i, 0) = match;
  }
  return nnf;
}

TEST(Occurrence, AMapThatCountsOneFieldAfterTheOtherIsThatOfTheWholeVolume) {
  struct Volume {
    Size size;
    int frames;
  };
  // Sizes that blocks of columns and frames divide, and others; also ones that they exceed
  for (const Volume& volume : {Volume{{64, 40}, 64}, Volume{{61, 23}, 75}, Volume{{9, 50}, 33},
                               Volume{{3, 2}, 2}, Volume{{1, 1}, 1}}) {
    for (const int radius : {0, 1, 10, 1000}) {
      OccurrenceMap map(volume.size, volume.frames, radius);
      std::uint64_t seed = 20;
      for (const int count : {30, 0, 7, 400, 1}) {
        const NearestNeighborField nnf =
            clusteredMatches(volume.size, volume.frames, count, ++seed);
        map.rebuild(nnf);
        const WholeVolume whole(volume.size, volume.frames, radius, nnf);
        for (int k = 0; k < volume.frames; ++k) {
          for (int y = 0; y < volume.size.height; ++y) {
            for (int x = 0; x < volume.size.width; ++x) {
              ASSERT_EQ(map.windowSum(x, y, k), whole.windowSum(x, y, k))
                  << x << ' ' << y << ' ' << k << " of " << count << ", radius " << radius;
            }
          }
        }
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
          ASSERT_EQ(with.contribution(std::clamp(own.nearestX(), 0, kSize.width - 1),
                                      std::clamp(own.nearestY(), 0, kSize.height - 1), own.frame, x,
                                      y, k),
                    with.windowSum(x, y, k) - without.windowSum(x, y, k))
              << i << " at " << x << ' ' << y << ' ' << k;
        }
      }
    }
  }
  EXPECT_EQ(with.contribution(5, 4, 3, 5, 4, 3), kPatchArea);
  EXPECT_EQ(with.contribution(0, 0, 3, 0, 0, 3), (kPatchRadius + 1) * (kPatchRadius + 1));
}

/// The map of some matches.
OccurrenceMap mapOf(Size size, int frames, int radius, const std::vector<Match>& matches) {
  NearestNeighborField nnf(Size{static_cast<int>(matches.size()), 1});
  std::copy(matches.begin(), matches.end(), nnf.begin());
  OccurrenceMap map(size, frames, radius);
  map.rebuild(nnf);
  return map;
}

TEST(Occurrence, RadiusBeyondTheSequenceCoversAllFrames) {
  const OccurrenceMap map = mapOf(kSize, kFrames, 1000, {Match{5.0F, 4.0F, 3, Rotation{}}});
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
      const OccurrenceMap map = mapOf(kSize, kManyFrames, radius, {used});
      // As if each box covered all frames
      const OccurrenceMap everywhere = mapOf(kSize, kManyFrames, kManyFrames, {used});
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
    std::vector<Match> uses;
    for (int frame = 0; frame < kManyFrames; ++frame) {
      uses.push_back({4.0F, 5.0F, frame, Rotation{}});
      changes.add(uses.back(), +1);
    }
    const OccurrenceMap map = mapOf(kSize, kManyFrames, radius, uses);
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
    const OccurrenceMap map = mapOf(disc.size, disc.frameCount, 1, all);
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
