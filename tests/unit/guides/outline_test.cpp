#include "fluidymation/guides/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "fluidymation/core/random.h"
#include "fluidymation/guides/mask.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

TEST(Outline, HasItsCrossingsInRowOrderTheRightOneFirst) {
  for (const Size size : {Size{1, 1}, Size{1, 9}, Size{9, 1}, Size{23, 17}}) {
    const Mask mask = test::randomMask(size, 4, 50);
    Crossings expected{Image<float>(size), Image<float>(size)};
    std::vector<std::uint16_t> shares;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        Random random({7, 0, 0, 0, x, y});
        const auto addedShare = [&] {
          shares.push_back(static_cast<std::uint16_t>(random.uniform(0, 65535)));
          return (static_cast<float>(shares.back()) + 0.5F) / 65536.0F;
        };
        if (x + 1 < size.width && mask(x, y) != mask(x + 1, y)) {
          expected.right(x, y) = addedShare();
        }
        if (y + 1 < size.height && mask(x, y) != mask(x, y + 1)) {
          expected.down(x, y) = addedShare();
        }
      }
    }
    const std::size_t count = shares.size();
    const Outline outline(std::move(shares));
    EXPECT_EQ(outline.crossingCount(), count);
    EXPECT_EQ(countCrossings(mask), count);
    const Crossings found = outline.crossings(mask);
    EXPECT_TRUE(test::nearEverywhere(expected.right, found.right, 1e-7F));
    EXPECT_TRUE(test::nearEverywhere(expected.down, found.down, 1e-7F));
  }
}

TEST(Outline, LiesBetweenTheCentresHoweverNearToOne) {
  const Outline outline({0, 65535});
  Mask mask(Size{3, 1});
  mask(1, 0) = 1;
  const Crossings crossings = outline.crossings(mask);
  EXPECT_GT(crossings.right(0, 0), 0.0F);
  EXPECT_LT(crossings.right(1, 0), 1.0F);
}

TEST(OutlinedMask, OfAHardMaskIsTheSmoothedMask) {
  for (const float sigmaPx : {0.0F, 0.5F, 1.0F, 3.0F}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Mask mask = test::randomBlobs({50, 40}, seed);
      Image<float> coverage(mask.size());
      for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
        coverage.data()[i] = static_cast<float>(mask.data()[i]);
      }
      const MaskOptions options{sigmaPx, 0.3F};
      EXPECT_TRUE(
          test::equalEverywhere(smoothMask(mask, options), outlinedMask(coverage, options).mask));
    }
  }
}

TEST(OutlinedMask, OfAHardMaskHasItsOutlineHalfWay) {
  const Mask mask = test::disc({30, 30}, {14.2F, 15.1F}, 8.0F);
  Image<float> coverage(mask.size());
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    coverage.data()[i] = static_cast<float>(mask.data()[i]);
  }
  const OutlinedMask shape = outlinedMask(coverage, {0.0F, 0.3F});
  ASSERT_GT(shape.outline.crossingCount(), 0U);
  const Crossings crossings = shape.outline.crossings(shape.mask);
  for (const Image<float>* shares : {&crossings.right, &crossings.down}) {
    for (const float share : *shares) {
      ASSERT_TRUE(share == 0.0F || std::abs(share - 0.5F) < 1e-4F) << share;
    }
  }
}

TEST(OutlinedMask, OfNothingAndOfEverythingHasNoOutline) {
  for (const Size size : {Size{1, 1}, Size{3, 3}, Size{20, 10}}) {
    for (const float sigmaPx : {0.0F, 2.0F}) {
      for (const float coverage : {0.0F, 0.1F, 0.9F, 1.0F}) {
        const OutlinedMask shape = outlinedMask(Image<float>(size, coverage), {sigmaPx, 0.3F});
        EXPECT_EQ(shape.outline.crossingCount(), 0U);
        EXPECT_EQ(countInside(shape.mask), coverage > 0.5F ? shape.mask.pixelCount() : 0U);
      }
    }
  }
}

TEST(OutlinedMask, GrowsWithTheCoverageOfThinLines) {
  // At any place on the grid. Nothing tells the two edges of a very thin line apart
  for (int phase = 0; phase < 10; ++phase) {
    for (const float width : {1.0F, 1.5F, 2.0F, 3.0F}) {
      const float left = 7.0F + 0.1F * static_cast<float>(phase);
      Image<float> coverage(Size{20, 9});
      for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 20; ++x) {
          const float begin = std::max(left, static_cast<float>(x) - 0.5F);
          const float end = std::min(left + width, static_cast<float>(x) + 0.5F);
          coverage(x, y) = std::max(end - begin, 0.0F);
        }
      }
      const OutlinedMask shape = outlinedMask(coverage, {0.0F, 0.3F});
      const Crossings crossings = shape.outline.crossings(shape.mask);
      float covered = 0.0F;
      for (int x = 0; x + 1 < 20; ++x) {
        const float share = crossings.right(x, 4);
        if (share == 0.0F) continue;
        const float edge = static_cast<float>(x) + share;
        covered += shape.mask(x, 4) != 0 ? edge : -edge;
      }
      EXPECT_NEAR(covered, width, width < 2.0F ? 0.4F : width < 3.0F ? 0.1F : 0.01F) << phase;
    }
  }
}

}  // namespace
}  // namespace fluidymation
