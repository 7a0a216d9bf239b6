#include "footage/mask_cleaning.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation::test {
namespace {

TEST(MaskCleaning, RemovesSpecksAndFillsHolesBySize) {
  const Mask whole = disc({60, 50}, {30.0F, 25.0F}, 15.0F);
  Mask dirty = whole.clone();
  dirty(2, 2) = dirty(3, 3) = dirty(3, 2) = 1;        // a speck of 3
  dirty(30, 25) = dirty(31, 25) = dirty(30, 26) = 0;  // a hole of 3
  EXPECT_TRUE(equalEverywhere(whole, cleanedMask(dirty, 4, 4)));
  EXPECT_TRUE(equalEverywhere(dirty, cleanedMask(dirty, 3, 3)));
  EXPECT_TRUE(equalEverywhere(dirty, cleanedMask(dirty, 0, 0)));
  Mask specks = cleanedMask(dirty, 0, 4);
  EXPECT_EQ(specks(2, 2), 1);
  EXPECT_EQ(specks(30, 25), 1);
}

TEST(MaskCleaning, DoesNotChangeWhatItHasCleaned) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Mask once = cleanedMask(randomBlobs({50, 40}, seed), 20, 20);
    EXPECT_TRUE(equalEverywhere(once, cleanedMask(once, 20, 20)));
  }
}

TEST(MaskCleaning, MayLeaveNothing) {
  EXPECT_EQ(countInside(cleanedMask(randomMask({40, 30}, 3, 2), 40, 40)), 0U);
}

/// 10 times how far a pixel lies within a disc.
[[nodiscard]] Image<float> rampOf(Size size, Vec2 centre, float radius) {
  Image<float> ramp(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      ramp(x, y) = 50.0F + 10.0F * (radius - length(place(x, y) - centre));
    }
  }
  return ramp;
}

TEST(SoftCoverage, IsTheShareOfThePixelThatLiesInside) {
  const Size size{60, 60};
  const Image<float> ramp = rampOf(size, {30.2F, 29.7F}, 17.3F);
  const Mask mask = disc(size, {30.2F, 29.7F}, 17.3F);
  EXPECT_TRUE(nearEverywhere(softDisc(size, {30.2F, 29.7F}, 17.3F), softCoverage(ramp, 50.0F, mask),
                             0.11F));
}

TEST(SoftCoverage, IsInsideWhereTheMaskIsAndHardWhereItWasCleaned) {
  const Size size{60, 60};
  const Image<float> ramp = rampOf(size, {30.0F, 30.0F}, 17.3F);
  const Mask mask = disc(size, {30.0F, 30.0F}, 17.3F);
  const Image<float> coverage = softCoverage(ramp, 50.0F, mask);
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    ASSERT_EQ(coverage.data()[i] >= 0.5F, mask.data()[i] != 0);
  }
  const Image<float> removed = softCoverage(ramp, 50.0F, Mask(size));
  EXPECT_LT(*std::max_element(removed.begin(), removed.end()), 0.5F);
  EXPECT_EQ(removed(30, 30), 0.0F);
  EXPECT_EQ(softCoverage(ramp, 500.0F, mask)(30, 30), 1.0F);
}

}  // namespace
}  // namespace fluidymation::test
