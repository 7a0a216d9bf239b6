#include "footage/bare_picture.h"

#include <gtest/gtest.h>

#include "support/synthetic_film.h"

namespace fluidymation::test {
namespace {

TEST(BarePicture, MedianIsThatOfEachChannel) {
  std::vector<Image<Rgb>> pictures;
  for (const Rgb color : {Rgb{0.1F, 0.9F, 0.5F}, Rgb{0.3F, 0.2F, 0.5F}, Rgb{0.2F, 0.4F, 0.9F}}) {
    pictures.emplace_back(Size{3, 2}, color);
  }
  const Image<Rgb> odd = medianPicture(pictures);
  EXPECT_EQ(odd(2, 1).r, 0.2F);
  EXPECT_EQ(odd(2, 1).g, 0.4F);
  EXPECT_EQ(odd(2, 1).b, 0.5F);
  pictures.emplace_back(Size{3, 2}, Rgb{0.6F, 0.0F, 0.1F});
  EXPECT_FLOAT_EQ(medianPicture(pictures)(0, 0).r, 0.25F);
  EXPECT_FLOAT_EQ(medianPicture(pictures)(0, 0).g, 0.3F);
}

TEST(BarePicture, PaintIsFilledInFromAround) {
  const Image<Rgb> bare = filmed(paper());
  const Image<Rgb> stained = filmed(Shot());
  Image<float> paint(stained.size(), 0.0F);
  for (int y = 0; y < paint.height(); ++y) {
    for (int x = 0; x < paint.width(); ++x) {
      const Vec2 place{static_cast<float>(x), static_cast<float>(y)};
      paint(x, y) = length(place - Vec2{80.0F, 60.0F}) < 31.0F ? 1.0F : 0.0F;
    }
  }
  const auto filled = withoutPaint(stained, paint);
  ASSERT_TRUE(filled.has_value());
  for (std::size_t i = 0; i < bare.pixelCount(); ++i) {
    ASSERT_NEAR(filled->data()[i].r, bare.data()[i].r, 0.15F);  // the paper's structure
  }
  EXPECT_FALSE(withoutPaint(stained, Image<float>(stained.size(), 1.0F)).has_value());
}

}  // namespace
}  // namespace fluidymation::test
