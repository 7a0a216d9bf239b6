#include "footage/matte.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/synthetic_film.h"

namespace fluidymation::test {
namespace {

/// `surface` with the matte multiplied over it.
[[nodiscard]] float multiplied(float surface, std::uint8_t color, std::uint8_t alpha) {
  const float a = static_cast<float>(alpha) / 255.0F;
  return surface * (1.0F - a + a * static_cast<float>(color) / 255.0F);
}

TEST(Matte, MultipliedOverTheSurfaceGivesTheFrameBack) {
  const Image<Rgb> bare = filmed(paper());
  const Image<Rgb> frame = filmed(Shot());
  for (const float alpha : {1.0F, 0.8F}) {
    const Matte matte = multiplyMatte(frame, bare, Image<float>(frame.size(), alpha));
    EXPECT_EQ(matte.lighter, 0);
    for (std::size_t i = 0; i < frame.pixelCount(); ++i) {
      const Rgba8 over = matte.picture.data()[i];
      const Rgb under = bare.data()[i];
      ASSERT_NEAR(multiplied(under.r, over.r, over.a), frame.data()[i].r, 1.0F / 255.0F);
      ASSERT_NEAR(multiplied(under.g, over.g, over.a), frame.data()[i].g, 1.0F / 255.0F);
      ASSERT_NEAR(multiplied(under.b, over.b, over.a), frame.data()[i].b, 1.0F / 255.0F);
    }
  }
}

TEST(Matte, OverWhiteThePaperIsGone) {
  Shot shot;
  const Matte matte = multiplyMatte(filmed(shot), filmed(paper()), Image<float>(shot.size, 1.0F));
  for (int x = 60; x < 100; ++x) {
    EXPECT_NEAR(matte.picture(x, 60).r, 255.0F * shot.paint.r, 1.0F);
    EXPECT_NEAR(matte.picture(x, 60).b, 255.0F * shot.paint.b, 1.0F);
  }
}

TEST(Matte, IsTransparentBlackOutside) {
  const Image<Rgb> frame = filmed(Shot());
  Image<float> coverage(frame.size(), 0.0F);
  coverage(80, 60) = 1.0F;
  const Matte matte = multiplyMatte(frame, frame, coverage);
  const Rgba8 outside = matte.picture(10, 10);
  EXPECT_EQ(outside.r + outside.g + outside.b + outside.a, 0);
  EXPECT_EQ(matte.picture(80, 60).a, 255);
  EXPECT_EQ(matte.picture(80, 60).g, 255);
}

TEST(Matte, CountsWhatIsLighterThanTheSurface) {
  const Image<Rgb> bare(Size{4, 3}, Rgb{0.5F, 0.5F, 0.0F});
  Image<Rgb> frame = bare.clone();
  frame(1, 1) = {0.5F, 0.6F, 0.0F};
  frame(2, 1) = {0.0F, 0.0F, 0.5F};  // on a surface without any blue
  const Matte matte = multiplyMatte(frame, bare, Image<float>(bare.size(), 1.0F));
  EXPECT_EQ(matte.lighter, 2);
  EXPECT_EQ(matte.picture(1, 1).g, 255);
  EXPECT_EQ(matte.picture(2, 1).b, 255);
}

}  // namespace
}  // namespace fluidymation::test
