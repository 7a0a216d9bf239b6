#include "fluidymation/core/resize.h"

#include <numeric>

#include "support/comparison.h"

namespace fluidymation {
namespace {

Image<float> ramp(Size size) {
  Image<float> image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) image(x, y) = static_cast<float>(3 * x + 7 * y);
  }
  return image;
}

TEST(Resize, EqualSizeCopiesExactly) {
  const Image<float> image = ramp({7, 5});
  EXPECT_TRUE(test::nearEverywhere(image, resize(image, image.size()), 0.0F));
}

TEST(Resize, ConstantStaysConstantForAnySize) {
  const Image<float> image(Size{9, 4}, 0.625F);
  for (const Size size : {Size{1, 1}, Size{3, 3}, Size{4, 9}, Size{9, 8}, Size{31, 17}}) {
    EXPECT_TRUE(test::nearEverywhere(Image<float>(size, 0.625F), resize(image, size), 1e-6F));
  }
}

TEST(Resize, HalvingAveragesBlocks) {
  const Image<float> image = ramp({8, 6});
  const Image<float> half = resize(image, {4, 3});
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      const float mean = (image(2 * x, 2 * y) + image(2 * x + 1, 2 * y) + image(2 * x, 2 * y + 1) +
                          image(2 * x + 1, 2 * y + 1)) /
                         4.0F;
      EXPECT_NEAR(half(x, y), mean, 1e-4F);
    }
  }
}

TEST(Resize, ShrinkingKeepsTheMean) {
  const Image<float> image = ramp({10, 10});
  const Image<float> small = resize(image, {3, 7});
  const auto mean = [](const Image<float>& i) {
    return std::accumulate(i.begin(), i.end(), 0.0) / static_cast<double>(i.pixelCount());
  };
  EXPECT_NEAR(mean(image), mean(small), 1e-4);
}

TEST(Resize, GrowingInterpolatesBetweenCentres) {
  Image<float> image(Size{2, 1});
  image(1, 0) = 1.0F;
  const Image<float> grown = resize(image, {4, 1});
  EXPECT_NEAR(grown(0, 0), 0.0F, 1e-6F);
  EXPECT_NEAR(grown(1, 0), 0.25F, 1e-6F);
  EXPECT_NEAR(grown(2, 0), 0.75F, 1e-6F);
  EXPECT_NEAR(grown(3, 0), 1.0F, 1e-6F);
}

TEST(Resize, VectorsAreResampledByComponent) {
  const Image<float> x = ramp(Size{9, 7});
  Image<Vec2> vectors(x.size());
  for (std::size_t i = 0; i < x.pixelCount(); ++i) vectors.data()[i] = {x.data()[i], -2.0F};
  for (const Size size : {Size{4, 3}, Size{20, 11}, Size{9, 7}}) {
    const Image<float> wanted = resize(x, size);
    const Image<Vec2> resized = resize(vectors, size);
    ASSERT_EQ(resized.size(), size);
    for (std::size_t i = 0; i < wanted.pixelCount(); ++i) {
      EXPECT_EQ(resized.data()[i].x, wanted.data()[i]);
      EXPECT_NEAR(resized.data()[i].y, -2.0F, 1e-5F);
    }
  }
}

TEST(Resize, ScaledSizeIsNeverEmpty) {
  EXPECT_EQ(scaledSize({3, 400}, 0.01), (Size{1, 4}));
  EXPECT_EQ(scaledSize({1000, 800}, 0.5), (Size{500, 400}));
}

}  // namespace
}  // namespace fluidymation
