#include "fluidymation/guides/local_thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "fluidymation/guides/distance_field.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

/// The definition, pixel pair by pixel pair.
Image<float> bruteForceThickness(const Image<float>& distance, float limitPx) {
  Image<float> thickness(distance.size());
  for (int y = 0; y < distance.height(); ++y) {
    for (int x = 0; x < distance.width(); ++x) {
      if (distance(x, y) <= 0.0F) continue;
      for (int py = 0; py < distance.height(); ++py) {
        for (int px = 0; px < distance.width(); ++px) {
          const float radius = distance(px, py);
          const auto square = static_cast<float>((px - x) * (px - x) + (py - y) * (py - y));
          if (radius <= 0.0F || square >= radius * radius) continue;
          thickness(x, y) = std::max(thickness(x, y), std::min(radius, limitPx));
        }
      }
    }
  }
  return thickness;
}

TEST(LocalThickness, IsTheRadiusOfTheLargestDiscThatCoversThePixel) {
  constexpr float kUnlimited = 1000.0F;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const Image<float> distance = signedDistance(test::randomBlobs({47, 38}, seed));
    EXPECT_TRUE(test::nearEverywhere(bruteForceThickness(distance, kUnlimited),
                                     localThickness(distance, kUnlimited), 2e-3F));
  }
}

/// Whether a pixel of depth `limitPx` or more is nearer to (x, y) than that.
bool isNearDeepPixel(const Image<float>& distance, int x, int y, float limitPx) {
  for (int py = 0; py < distance.height(); ++py) {
    for (int px = 0; px < distance.width(); ++px) {
      const auto square = static_cast<float>((px - x) * (px - x) + (py - y) * (py - y));
      if (distance(px, py) >= limitPx && square < limitPx * limitPx) return true;
    }
  }
  return false;
}

TEST(LocalThickness, StopsAtItsLimit) {
  constexpr float kMostMissedPx = 1.2F;
  int exceptions = 0;
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Image<float> distance = signedDistance(test::randomBlobs({47, 38}, seed));
    for (const float limitPx : {2.0F, 4.5F, 7.0F}) {
      SCOPED_TRACE(limitPx);
      const Image<float> expected = bruteForceThickness(distance, limitPx);
      const Image<float> found = localThickness(distance, limitPx);
      for (int y = 0; y < distance.height(); ++y) {
        for (int x = 0; x < distance.width(); ++x) {
          inside += distance(x, y) > 0.0F ? 1 : 0;
          // Past the limit only discs as large as it are looked for, on the pixel grid: at the rim
          // of a larger one there may be none. Smaller ones are found there.
          const bool isException =
              expected(x, y) == limitPx && !isNearDeepPixel(distance, x, y, limitPx);
          ASSERT_LE(found(x, y), expected(x, y) + 2e-3F) << x << ' ' << y;
          ASSERT_GE(found(x, y), expected(x, y) - (isException ? kMostMissedPx : 2e-3F))
              << x << ' ' << y;
          exceptions += isException && found(x, y) < limitPx - 2e-3F ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(exceptions, 0);
  EXPECT_LT(exceptions, 0.005 * inside);
}

TEST(LocalThickness, OfThickPartsWithThinOnesIsThatOfAllDiscs) {
  // A thick disc with a bar that tapers to its right; discs of the one reach into the other
  const Mask shape = test::maskOf({120, 70}, [](int x, int y) {
    const bool inDisc = (x - 36) * (x - 36) + (y - 34) * (y - 34) < 30 * 30;
    return inDisc || (x > 36 && x < 114 && 8 * std::abs(y - 34) < 114 - x + 16);
  });
  const Image<float> distance = signedDistance(shape);
  for (const float limitPx : {5.5F, 12.0F, 25.0F}) {
    SCOPED_TRACE(limitPx);
    const Image<float> thickness = localThickness(distance, limitPx);
    const Image<float> slow = bruteForceThickness(distance, limitPx);
    EXPECT_TRUE(test::nearEverywhere(slow, thickness, 1.0F));
    // Where all discs are smaller than the limit there is no error
    for (int x = 100; x < 116; ++x) EXPECT_NEAR(thickness(x, 34), slow(x, 34), 2e-3F) << x;
  }
}

TEST(LocalThickness, OfAnEmptyMaskIsZero) {
  const Image<float> distance = signedDistance(Mask(Size{9, 7}));
  EXPECT_TRUE(test::nearEverywhere(Image<float>({9, 7}), localThickness(distance, 5.0F), 0.0F));
}

TEST(StretchedDistance, TheMiddleOfAThinBarIsAsDeepAsTheRimIsWide) {
  const Mask bar = test::maskOf({80, 40}, [](int, int y) { return y >= 16 && y < 23; });
  const Image<float> stretched = stretchedDistance(signedDistance(bar), 10.0F);
  EXPECT_FLOAT_EQ(stretched(40, 19), 10.0F);  // 4 px from the outside
  EXPECT_FLOAT_EQ(stretched(40, 17), 5.0F);
  EXPECT_FLOAT_EQ(stretched(40, 16), 2.5F);
  EXPECT_FLOAT_EQ(stretched(40, 15), -1.0F);  // outside nothing changes
}

TEST(StretchedDistance, ThickPartsKeepTheirDistances) {
  const Image<float> distance = signedDistance(test::disc({80, 80}, {40.0F, 40.0F}, 30.0F));
  EXPECT_TRUE(test::nearEverywhere(distance, stretchedDistance(distance, 10.0F), 0.0F));
}

}  // namespace
}  // namespace fluidymation
