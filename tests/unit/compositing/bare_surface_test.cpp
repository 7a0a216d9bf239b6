#include "compositing/bare_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr Size kSize{80, 60};

/// Paper that is brighter to the right, with grain.
Rgb paper(int x, int y) {
  const float grain = (x * 7 + y * 3) % 5 == 0 ? 0.05F : 0.0F;
  const float value = 0.5F + 0.004F * static_cast<float>(x) + grain;
  return {value, value, value};
}

Image<Rgb> paperPicture() {
  Image<Rgb> picture(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) picture(x, y) = paper(x, y);
  }
  return picture;
}

/// That paper with a black blot that its mask covers.
void addBlot(BareSurface& surface, Vec2 centre, float radius) {
  const Mask blot = test::disc(kSize, centre, radius);
  Image<Rgb> picture(kSize);
  Image<float> coverage(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      coverage(x, y) = blot(x, y) != 0 ? 1.0F : 0.0F;
      picture(x, y) = blot(x, y) != 0 ? Rgb{} : paper(x, y);
    }
  }
  surface.add(picture, coverage);
}

TEST(BareSurface, IsExactWhereverItWasSeen) {
  BareSurface surface(kSize);
  addBlot(surface, {20.0F, 30.0F}, 10.0F);
  addBlot(surface, {60.0F, 30.0F}, 10.0F);  // uncovers the first
  const Image<Rgb> filled = surface.filled();
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) EXPECT_NEAR(filled(x, y).g, paper(x, y).g, 1e-5F);
  }
}

TEST(BareSurface, FillsInWhatWasNeverBare) {
  BareSurface surface(kSize);
  addBlot(surface, {40.0F, 30.0F}, 15.0F);
  const Image<Rgb> filled = surface.filled();
  double worst = 0.0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      worst = std::max(worst, static_cast<double>(std::abs(filled(x, y).g - paper(x, y).g)));
    }
  }
  EXPECT_LT(worst, 0.15);  // shading within 0.1, and the grain elsewhere; a blot is off by 0.6
}

TEST(BareSurface, KeepsItsBrightnessHoweverLargeItIs) {
  constexpr Size kLarge{2048, 1536};  // 3 million pixels
  constexpr float kValue = 0.895F;
  BareSurface surface(kLarge);
  surface.add(Image<Rgb>(kLarge, {kValue, kValue, kValue}), Image<float>(kLarge));
  const Image<Rgb> larger = surface.spread({kLarge.width + 8, kLarge.height + 8});
  for (const Rgb color : larger) ASSERT_NEAR(color.g, kValue, 1e-4F);
}

TEST(BareSurface, KnowsNothingUnderMasksThatCoverAll) {
  BareSurface surface(kSize);
  surface.add(Image<Rgb>(kSize), Image<float>(kSize, 1.0F));
  EXPECT_FALSE(surface.known());
}

TEST(BareSurface, IsCutToASmallerSize) {
  BareSurface surface(kSize);
  surface.add(paperPicture(), Image<float>(kSize));
  const Image<Rgb> middle = surface.spread({40, 20});
  EXPECT_EQ(middle.size(), (Size{40, 20}));
  EXPECT_FLOAT_EQ(middle(0, 0).r, paper(20, 20).r);
}

TEST(BareSurface, IsQuiltedToALargerSizeFromWhatStaysBare) {
  BareSurface surface(kSize);
  surface.add(paperPicture(), Image<float>(kSize));
  for (int frame = 0; frame < 3; ++frame) {
    Image<Rgb> picture = paperPicture();
    Image<float> coverage(kSize);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 40; x < kSize.width; ++x) coverage(x, y) = 1.0F;
    }
    surface.add(picture, coverage);
  }
  const Image<Rgb> large = surface.spread({150, 130});
  EXPECT_EQ(large.size(), (Size{150, 130}));
  float brightest = 0.0F;
  float darkest = 1.0F;
  for (const Rgb color : large) {
    brightest = std::max(brightest, color.g);
    darkest = std::min(darkest, color.g);
  }
  EXPECT_GT(brightest - darkest, 0.04F) << "the grain is there";
  EXPECT_LT(brightest - darkest, 0.12F) << "and the shading, 0.32 from side to side, is not";
}

TEST(BareSurface, IsMirroredWhereThereIsTooLittleToQuilt) {
  BareSurface surface({20, 10});
  Image<Rgb> small({20, 10});
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) small(x, y) = paper(x, y);
  }
  surface.add(small, Image<float>({20, 10}));
  const Image<Rgb> large = surface.spread({64, 33});
  EXPECT_EQ(large.size(), (Size{64, 33}));
  for (int x = 0; x < 20; ++x) EXPECT_EQ(large(39 - x, 0).r, large(x, 0).r);
}

}  // namespace
}  // namespace fluidymation
