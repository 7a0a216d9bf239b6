#include "fluidymation/synthesis/nnf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/channels.h"

namespace fluidymation {
namespace {

Rotation turn(float radians) { return {std::cos(radians), std::sin(radians)}; }

Match randomMatch(Random& random) {
  return {static_cast<float>(random.uniform(0, 4000)) / 100.0F,
          static_cast<float>(random.uniform(0, 4000)) / 100.0F, random.uniform(0, 5),
          turn(static_cast<float>(random.uniform(0, 6283)) / 1000.0F)};
}

/// The farthest that a sample of the window lies apart along an axis, px.
float farthestApart(const Match& a, const Match& b) {
  float farthest = 0.0F;
  for (const float dy : {-2.0F, 2.0F}) {
    for (const float dx : {-2.0F, 2.0F}) {
      const Match atA = a.moved({dx, dy});
      const Match atB = b.moved({dx, dy});
      farthest = std::max({farthest, std::abs(atA.x - atB.x), std::abs(atA.y - atB.y)});
    }
  }
  return farthest;
}

TEST(AreAlike, MatchesWhoseWindowsAreHardlyApart) {
  static_assert(kPatchRadius == 2, "what a window's corner is moved by");
  // 1/256 px by the place and as much by the turn; single-precision places besides
  constexpr float kHardly = 2.0F / 256.0F + 1e-5F;
  // A turn by 1/1024, which moves some corner by twice that along some axis
  constexpr float kTellable = 2.0F / 1024.0F - 1e-5F;
  Random random(RandomKey{71, 0, 0, 0, 0, 0});
  int alike = 0;
  int apart = 0;
  for (int n = 0; n < 20000; ++n) {
    const Match a = randomMatch(random);
    const auto slip = [&random](float largest) {
      return largest * static_cast<float>(random.uniform(-1000, 1000)) / 1000.0F;
    };
    Match b = a;
    b.x += slip(0.006F);
    b.y += slip(0.006F);
    b.rotation = turn(a.rotation.angleRad() + slip(0.002F));
    ASSERT_EQ(areAlike(a, b), areAlike(b, a));
    if (areAlike(a, b)) {
      ASSERT_LT(farthestApart(a, b), kHardly);
      ++alike;
    } else {
      ASSERT_GT(farthestApart(a, b), kTellable);
      ++apart;
    }
  }
  EXPECT_GT(alike, 1000);
  EXPECT_GT(apart, 1000);
}

TEST(AreAlike, WhateverIsMovedThereAndBack) {
  Random random(RandomKey{72, 0, 0, 0, 0, 0});
  for (int n = 0; n < 1000; ++n) {
    const Match match = randomMatch(random);
    ASSERT_TRUE(areAlike(match, match));
    Match moved = match;
    for (int step = 0; step < 50; ++step) moved = moved.moved({1.0F, -1.0F});
    for (int step = 0; step < 50; ++step) moved = moved.moved({-1.0F, 1.0F});
    ASSERT_TRUE(areAlike(match, moved));
    ASSERT_FALSE(areAlike(match, match.moved({1.0F, 0.0F})));
  }
}

TEST(AreAlike, NoMatchesOfDifferentFramesOrOppositeTurns) {
  const Match match{3.0F, 4.0F, 2, turn(0.5F)};
  Match later = match;
  later.frame = 3;
  EXPECT_FALSE(areAlike(match, later));
  Match opposite = match;
  opposite.rotation = match.rotation.opposite();
  EXPECT_FALSE(areAlike(match, opposite));
  EXPECT_FALSE(areAlike(match, Match{}));
  EXPECT_TRUE(areAlike(Match{}, Match{})) << "none is like none";
  Match nowhere = match;
  nowhere.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(areAlike(match, nowhere));
}

}  // namespace
}  // namespace fluidymation
