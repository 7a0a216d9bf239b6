#include "compositing/quilt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fluidymation {
namespace {

constexpr Size kSize{90, 60};
constexpr int kPeriodPx = 7;

/// Stripes; what is not usable is red.
Rgb stripe(int x) {
  const float value = static_cast<float>(x % kPeriodPx) / static_cast<float>(kPeriodPx);
  return {value, value, value};
}

TEST(Quilt, ContinuesAPatternThatFits) {
  Image<Rgb> texture(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) texture(x, y) = stripe(x);
  }
  const auto result = quilted(texture, Mask(kSize, 1), {200, 130});
  ASSERT_TRUE(result);
  ASSERT_EQ(result->size(), (Size{200, 130}));
  // Each seventh place fits exactly, and 60 are tried for a block.
  for (int y = 0; y < 130; ++y) {
    for (int x = kPeriodPx; x < 200; ++x) {
      ASSERT_EQ((*result)(x, y).g, (*result)(x - kPeriodPx, y).g) << x << ", " << y;
    }
  }
}

TEST(Quilt, TakesUsablePixelsOnly) {
  Image<Rgb> texture(kSize);
  Mask usable(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      usable(x, y) = x < 50 && y > 5 ? 1 : 0;
      texture(x, y) = usable(x, y) != 0 ? stripe(x + y) : Rgb{2.0F, 0.0F, 0.0F};
    }
  }
  const auto result = quilted(texture, usable, {120, 90});
  ASSERT_TRUE(result);
  EXPECT_TRUE(std::all_of(result->begin(), result->end(), [](Rgb c) { return c.r < 1.0F; }));
}

TEST(Quilt, TwoAreAlike) {
  Image<Rgb> texture(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) texture(x, y) = stripe(x * x + 3 * y);
  }
  const auto one = quilted(texture, Mask(kSize, 1), {95, 61});
  const auto other = quilted(texture, Mask(kSize, 1), {95, 61});
  ASSERT_TRUE(one && other);
  for (std::size_t i = 0; i < one->pixelCount(); ++i) {
    ASSERT_EQ(one->data()[i].g, other->data()[i].g);
  }
}

TEST(Quilt, SaysWhereThereIsTooLittle) {
  EXPECT_FALSE(quilted(Image<Rgb>(kSize), Mask(kSize), {10, 10}));
  EXPECT_FALSE(quilted(Image<Rgb>({20, 10}), Mask({20, 10}, 1), {40, 40}));
}

}  // namespace
}  // namespace fluidymation
