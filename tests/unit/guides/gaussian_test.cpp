#include "fluidymation/guides/gaussian.h"

#include <numeric>

#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

Image<float> impulse(Size size, int x, int y) {
  Image<float> image(size);
  image(x, y) = 1.0F;
  return image;
}

TEST(Gaussian, KernelSumsToOneAndReachesThreeSigma) {
  for (const float sigma : {0.3F, 1.0F, 2.0F, 8.0F}) {
    const std::vector<float> kernel = gaussianKernel(sigma);
    EXPECT_EQ(kernel.size(), static_cast<std::size_t>(gaussianReach(sigma)) + 1) << sigma;
    const double sides = std::accumulate(kernel.begin() + 1, kernel.end(), 0.0);
    EXPECT_NEAR(static_cast<double>(kernel[0]) + 2.0 * sides, 1.0, 1e-6) << sigma;
    for (std::size_t i = 1; i < kernel.size(); ++i) EXPECT_LT(kernel[i], kernel[i - 1]);
  }
  EXPECT_EQ(gaussianKernel(0.0F), std::vector<float>{1.0F});
}

TEST(Gaussian, BlurKeepsTheSumAndIsSymmetric) {
  const Image<float> blurred = gaussianBlur(impulse({41, 41}, 20, 20), 3.0F);
  EXPECT_NEAR(std::accumulate(blurred.begin(), blurred.end(), 0.0), 1.0, 1e-5);
  EXPECT_TRUE(test::nearEverywhere(blurred, test::flippedX(blurred), 0.0F));
  EXPECT_TRUE(test::nearEverywhere(blurred, test::transposed(blurred), 1e-7F));
}

TEST(Gaussian, VariancesAdd) {
  const Image<float> image = impulse({61, 61}, 30, 30);
  const Image<float> twice = gaussianBlur(gaussianBlur(image, 3.0F), 4.0F);
  const Image<float> once = gaussianBlur(image, 5.0F);
  // Cutting at 3 sigma takes 1 to 3 % of the variance away, not the same share in both
  EXPECT_TRUE(test::nearEverywhere(once, twice, 0.03F * once(30, 30)));
  EXPECT_FALSE(test::nearEverywhere(gaussianBlur(image, 4.5F), twice, 0.03F * once(30, 30)));
}

TEST(Gaussian, ConstantStaysConstantUpToTheEdge) {
  const Image<float> image(Size{9, 5}, 0.75F);
  EXPECT_TRUE(test::nearEverywhere(image, gaussianBlur(image, 8.0F), 1e-6F));
}

TEST(Gaussian, TheEdgeRepeats) {
  // A step at the middle of 2 pixels is, with repeated edges, a step between two half-planes
  Image<float> image(Size{2, 1});
  image(1, 0) = 1.0F;
  const Image<float> blurred = gaussianBlur(image, 2.0F);
  const float centre = gaussianKernel(2.0F)[0];
  EXPECT_NEAR(blurred(0, 0), 0.5F - 0.5F * centre, 1e-6F);
  EXPECT_NEAR(blurred(1, 0), 0.5F + 0.5F * centre, 1e-6F);
}

TEST(Gaussian, SigmaZeroCopies) {
  const Image<float> image = impulse({5, 4}, 2, 1);
  EXPECT_TRUE(test::nearEverywhere(image, gaussianBlur(image, 0.0F), 0.0F));
}

TEST(GaussianReach, IsThreeSigmaRoundedUp) {
  EXPECT_EQ(gaussianReach(0.0F), 0);
  EXPECT_EQ(gaussianReach(0.3F), 1);
  EXPECT_EQ(gaussianReach(2.0F), 6);
  EXPECT_EQ(gaussianReach(2.1F), 7);
}

}  // namespace
}  // namespace fluidymation
