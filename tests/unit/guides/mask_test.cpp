#include "fluidymation/guides/mask.h"

#include <cmath>

#include "fluidymation/guides/gaussian.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

/// The definition, on the whole frame.
Mask smoothedSlowly(const Mask& mask, const MaskOptions& options) {
  Image<float> coverage(mask.size());
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    coverage.data()[i] = mask.data()[i] != 0 ? 1.0F : 0.0F;
  }
  const Image<float> blurred = gaussianBlur(coverage, options.blurSigmaPx);
  return test::maskOf(mask.size(),
                      [&](int x, int y) { return blurred(x, y) >= options.threshold; });
}

TEST(SmoothMask, SigmaZeroCopies) {
  const Mask mask = test::randomMask({17, 9}, 5, 40);
  EXPECT_TRUE(test::equalEverywhere(mask, smoothMask(mask, {0.0F, 0.3F})));
}

TEST(SmoothMask, WorkingInTheBoundingBoxChangesNothing) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const Mask mask = test::randomBlobs({90, 70}, seed);
    const MaskOptions options{3.0F, 0.3F};
    EXPECT_TRUE(test::equalEverywhere(smoothedSlowly(mask, options), smoothMask(mask, options)));
  }
  const Mask corner = test::maskOf({60, 50}, [](int x, int y) { return x < 9 && y < 12; });
  const MaskOptions options{4.0F, 0.3F};
  EXPECT_TRUE(test::equalEverywhere(smoothedSlowly(corner, options), smoothMask(corner, options)));
}

TEST(SmoothMask, ThresholdBelowHalfGrowsADisc) {
  const Mask mask = test::disc({120, 120}, {60.0F, 60.0F}, 35.0F);
  const auto radius = [](const Mask& m) {
    return std::sqrt(static_cast<double>(countInside(m)) / 3.14159265);
  };
  // At a straight edge the 0.3 level of a Gaussian step lies 0.524 sigma outside; a curved edge
  // loses about sigma^2 / 2r of that
  const double expected = 35.0 + 0.524 * 4.0 - 16.0 / 70.0;
  EXPECT_NEAR(radius(smoothMask(mask, {4.0F, 0.3F})), expected, 0.3);
  EXPECT_LT(radius(smoothMask(mask, {4.0F, 0.5F})), 35.1);
}

TEST(SmoothMask, AThinLineVanishesAndAThickOneStays) {
  const auto line = [](int width) {
    return test::maskOf({80, 80}, [width](int x, int) { return x >= 40 && x < 40 + width; });
  };
  EXPECT_EQ(countInside(smoothMask(line(4), {8.0F, 0.3F})), 0U);
  EXPECT_GT(countInside(smoothMask(line(8), {8.0F, 0.3F})), 0U);
}

TEST(SmoothMask, EmptyStaysEmptyAndFullStaysFull) {
  for (const Size size : {Size{1, 1}, Size{3, 3}, Size{40, 7}}) {
    EXPECT_EQ(countInside(smoothMask(Mask(size), {8.0F, 0.3F})), 0U);
    const Mask full(size, 1);
    EXPECT_TRUE(test::equalEverywhere(full, smoothMask(full, {8.0F, 0.5F})));
  }
}

TEST(BlurredMask, IsAGaussianOfAThirdOfTheRadius) {
  Mask half(Size{61, 5});
  for (int y = 0; y < 5; ++y) {
    for (int x = 30; x < 61; ++x) half(x, y) = 255;  // any nonzero byte is inside
  }
  const Image<float> blurred = blurredMask(half, 12.0F);
  for (int x = 0; x < 61; ++x) {
    const double expected = 0.5 * std::erfc((29.5 - x) / (std::sqrt(2.0) * 4.0));
    EXPECT_NEAR(blurred(x, 2), expected, 0.005) << x;
  }
  EXPECT_EQ(blurred(29 - 12, 2), 0.0F);      // the kernel ends
  EXPECT_NEAR(blurred(60, 2), 1.0F, 1e-6F);  // no border where the frame cuts
}

}  // namespace
}  // namespace fluidymation
