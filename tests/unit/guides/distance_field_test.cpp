#include "fluidymation/guides/distance_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

/// Looks at every other pixel.
Image<float> bruteForce(const Mask& mask) {
  Image<float> distance(mask.size());
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      int nearest = -1;
      for (int v = 0; v < mask.height(); ++v) {
        for (int u = 0; u < mask.width(); ++u) {
          if (mask(u, v) == mask(x, y)) continue;
          const int squared = (u - x) * (u - x) + (v - y) * (v - y);
          if (nearest < 0 || squared < nearest) nearest = squared;
        }
      }
      const auto magnitude = nearest < 0 ? static_cast<float>(mask.width() + mask.height())
                                         : std::sqrt(static_cast<float>(nearest));
      distance(x, y) = mask(x, y) != 0 ? magnitude : -magnitude;
    }
  }
  return distance;
}

TEST(DistanceField, AgreesWithBruteForceOnRandomMasks) {
  for (const int width : {1, 2, 7, 8, 9, 33}) {
    for (const int height : {1, 2, 7, 8, 9, 33}) {
      for (const int percent : {3, 50, 97}) {
        const Mask mask = test::randomMask({width, height}, 11, percent);
        EXPECT_TRUE(test::nearEverywhere(bruteForce(mask), signedDistance(mask), 1e-6F))
            << width << "x" << height << ", " << percent << " %";
      }
    }
  }
}

TEST(DistanceField, AgreesWithBruteForceOnBlobs) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const Mask mask = test::randomBlobs({41, 29}, seed);
    EXPECT_TRUE(test::nearEverywhere(bruteForce(mask), signedDistance(mask), 1e-5F)) << seed;
  }
}

TEST(DistanceField, AgreesWithBruteForceWhenASinglePixelDiffers) {
  const Size size{23, 31};
  const Mask dot = test::maskOf(size, [](int x, int y) { return x == 5 && y == 28; });
  const Mask hole = test::maskOf(size, [](int x, int y) { return x != 5 || y != 28; });
  EXPECT_TRUE(test::nearEverywhere(bruteForce(dot), signedDistance(dot), 1e-5F));
  EXPECT_TRUE(test::nearEverywhere(bruteForce(hole), signedDistance(hole), 1e-5F));
}

TEST(DistanceField, IsExactFarAboveAndBelowAShape) {
  const Size size{70, 260};
  const Mask blobs = test::randomBlobs({30, 20}, 5);
  for (const int top : {0, 100, 240}) {
    const Mask mask = test::maskOf(size, [&](int x, int y) {
      return blobs.contains(x - 20, y - top) && blobs(x - 20, y - top) != 0;
    });
    EXPECT_TRUE(test::nearEverywhere(bruteForce(mask), signedDistance(mask), 1e-5F)) << top;
  }
}

TEST(DistanceField, IsExactBeyondWhatAFloatCounts) {
  const Mask mask = test::maskOf({6000, 4}, [](int x, int y) { return x == 3 && y == 1; });
  const Image<float> distance = signedDistance(mask);
  for (int x = 5; x < 6000; ++x) {
    const double square = (x - 3.0) * (x - 3.0) + 4.0;
    ASSERT_EQ(distance(x, 3), -static_cast<float>(std::sqrt(square))) << x;
  }
}

TEST(DistanceWithin, IsTheDistanceAsFarAsItReaches) {
  for (const int reachPx : {0, 1, 7, 20, 60}) {
    for (const Mask& mask : {test::randomBlobs({70, 50}, 4), test::randomMask({70, 50}, 8, 1),
                             Mask(Size{9, 5}, 1), Mask(Size{9, 5})}) {
      const Image<float> exact = signedDistance(mask);
      const Image<float> distance = distanceWithin(mask, reachPx);
      for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
        const float expected = std::max(-exact.data()[i], 0.0F);
        if (countInside(mask) != 0 && expected <= static_cast<float>(reachPx)) {
          ASSERT_EQ(distance.data()[i], expected);
        } else {
          ASSERT_GT(distance.data()[i], static_cast<float>(reachPx));
        }
      }
    }
  }
}

TEST(DistanceField, CommutesWithFlipsAndTransposition) {
  const Mask mask = test::randomBlobs({40, 23}, 3);
  const Image<float> distance = signedDistance(mask);
  EXPECT_TRUE(
      test::nearEverywhere(test::flippedX(distance), signedDistance(test::flippedX(mask)), 0.0F));
  EXPECT_TRUE(test::nearEverywhere(test::transposed(distance),
                                   signedDistance(test::transposed(mask)), 0.0F));
}

TEST(DistanceField, EmptyAndFullMasksGetFiniteStandIns) {
  for (const Size size : {Size{1, 1}, Size{3, 3}, Size{5, 2}}) {
    const auto far = static_cast<float>(size.width + size.height);
    EXPECT_TRUE(test::nearEverywhere(Image<float>(size, -far), signedDistance(Mask(size)), 0.0F));
    EXPECT_TRUE(test::nearEverywhere(Image<float>(size, far), signedDistance(Mask(size, 1)), 0.0F));
  }
}

TEST(DistanceField, AMaskCutByTheFrameHasNoBorderThere) {
  const Mask half = test::maskOf({20, 10}, [](int x, int) { return x >= 8; });
  const Image<float> distance = signedDistance(half);
  for (int y = 0; y < 10; ++y) {
    EXPECT_EQ(distance(19, y), 12.0F);
    EXPECT_EQ(distance(0, y), -8.0F);
  }
}

TEST(DistanceField, ChangesByAtMostOnePerPixelOnOneSide) {
  const Mask mask = test::randomBlobs({60, 50}, 9);
  const Image<float> distance = signedDistance(mask);
  int compared = 0;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 1; x < mask.width(); ++x) {
      if (mask(x, y) != mask(x - 1, y)) continue;
      ++compared;
      ASSERT_LE(std::abs(distance(x, y) - distance(x - 1, y)), 1.0F + 1e-5F) << x << ", " << y;
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace fluidymation
