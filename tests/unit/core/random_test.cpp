#include "fluidymation/core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace fluidymation {
namespace {

TEST(Random, EqualKeysGiveEqualNumbers) {
  Random a({7, 1, 2, 3, 4, 5});
  Random b({7, 1, 2, 3, 4, 5});
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next(), b.next());
}

TEST(Random, EveryPartOfTheKeyMatters) {
  std::set<std::uint32_t> first;
  for (const RandomKey& key :
       {RandomKey{}, RandomKey{1, 0, 0, 0, 0, 0}, RandomKey{0, 1, 0, 0, 0, 0},
        RandomKey{0, 0, 1, 0, 0, 0}, RandomKey{0, 0, 0, 1, 0, 0}, RandomKey{0, 0, 0, 0, 1, 0},
        RandomKey{0, 0, 0, 0, 0, 1}}) {
    first.insert(Random(key).next());
  }
  EXPECT_EQ(first.size(), 7U);
}

TEST(Random, ThePixelsOfASourceHaveTheNumbersOfTheirKeys) {
  for (const RandomKey& key :
       {RandomKey{}, RandomKey{7, 1, 2, 3, 4, 5}, RandomKey{0xFEDCBA9876543210U, 49, 3, -2, -1, 0},
        RandomKey{1, 0, 0, 0, 4095, 2159}}) {
    const Random source = Random::ofPass(key.seed, key.frame, key.level, key.pass);
    Random other = source.at(key.x + 1, key.y);  // takes nothing from the source
    (void)other.next64();
    Random ofPixel = source.at(key.x, key.y);
    Random ofKey(key);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(ofPixel.next64(), ofKey.next64());
  }
}

TEST(Random, NeighbouringPixelsAreUniformAndUncorrelated) {
  // Chi-square over 16 bins for the first number of 64 x 64 neighbouring pixels: 15 degrees of
  // freedom, 37.7 is the 0.1 % point.
  std::array<int, 16> bins{};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      Random random({0, 0, 0, 0, x, y});
      ++bins[static_cast<std::size_t>(random.uniform(0, 15))];
    }
  }
  double chiSquare = 0.0;
  for (const int n : bins) chiSquare += std::pow(n - 256.0, 2.0) / 256.0;
  EXPECT_LT(chiSquare, 37.7);
}

TEST(Random, UniformReachesBothEndsAndNeverLeaves) {
  Random random(RandomKey{});
  bool low = false;
  bool high = false;
  for (int i = 0; i < 1000; ++i) {
    const int n = random.uniform(-3, 4);
    ASSERT_GE(n, -3);
    ASSERT_LE(n, 4);
    low |= n == -3;
    high |= n == 4;
  }
  EXPECT_TRUE(low && high);
  EXPECT_EQ(random.uniform(5, 5), 5);
}

}  // namespace
}  // namespace fluidymation
