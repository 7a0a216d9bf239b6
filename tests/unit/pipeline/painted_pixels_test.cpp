#include "pipeline/painted_pixels.h"
#include "compositing/color_margin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compositing/over.h"
#include "support/half_covered.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr Size kSize{31, 23};
const FramePart kWhole = FramePart::whole(kSize);
constexpr int kEdge = kSize.width / 2;  ///< column that is covered by a quarter

int wide(float value) { return static_cast<int>(std::lround(65535.0F * value)); }

TEST(StraightPixels, PaintWhatIsCovered) {
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  const GuideFrame guides = test::halfCovered(kSize);
  const Image<Rgba8> narrow = straightPixels8({kWhole, picture, guides}, SrgbByteEncoder());
  const Image<Rgba16> exact = straightPixels16({kWhole, picture, guides});
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x <= kEdge; ++x) {
      const Rgb color = toRgb(picture(x, y));
      const Rgba8 p = narrow(x, y);
      ASSERT_EQ(p.a, x == kEdge ? 64 : 255);
      ASSERT_TRUE(p.r == toByte(color.r) && p.g == toByte(color.g) && p.b == toByte(color.b));
      const Rgba16 q = exact(x, y);
      ASSERT_EQ(q.a, x == kEdge ? 16384 : 65535);
      ASSERT_TRUE(q.r == wide(color.r) && q.g == wide(color.g) && q.b == wide(color.b));
    }
  }
}

TEST(StraightPixels, SixteenBitsAreMoreThanEightOfThem) {
  const Image<Rgba16> exact =
      straightPixels16({kWhole, test::randomTexture(kSize, 3), test::halfCovered(kSize)});
  int between = 0;
  for (const Rgba16 p : exact) between += p.a == 65535 && p.r % 257 != 0 ? 1 : 0;
  EXPECT_GT(between, kSize.height * kEdge / 2);
}

TEST(StraightPixels, ColorsGoOnPastThePaintAndEndThere) {
  Image<Lab> picture(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) picture(x, y) = toLab(Rgb{0.8F, 0.4F, 0.2F});
  }
  const GuideFrame guides = test::halfCovered(kSize);
  const Image<Rgba8> output = straightPixels8({kWhole, picture, guides}, SrgbByteEncoder());
  const Image<Rgba16> exact = straightPixels16({kWhole, picture, guides});
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = kEdge + 1; x < kSize.width; ++x) {
      const Rgba8 p = output(x, y);
      ASSERT_EQ(p.a, 0);
      ASSERT_EQ(exact(x, y).a, 0);
      if (x <= kEdge + kColorMarginPx) {
        ASSERT_EQ(p.r, output(0, 0).r) << x;
        ASSERT_EQ(p.b, output(0, 0).b) << x;
        ASSERT_EQ(exact(x, y).g, exact(0, 0).g) << x;
      } else {
        ASSERT_TRUE(p.r == 0 && p.g == 0 && p.b == 0) << x;
      }
    }
  }
}

TEST(StraightPixels, AFrameWithoutPaintIsEmpty) {
  GuideFrame guides;
  guides.mask = Mask(kSize);
  for (const Rgba8 p :
       straightPixels8({kWhole, test::randomTexture(kSize, 1), guides}, SrgbByteEncoder())) {
    ASSERT_TRUE(p.r == 0 && p.g == 0 && p.b == 0 && p.a == 0);
  }
}

/// Over any background they are what a compositor makes of the straight ones.
TEST(OpaquePixels, AreTheStraightOnesLaidOver) {
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  const GuideFrame guides = test::halfCovered(kSize);
  Image<Rgb> background(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) background(x, y) = toRgb(picture(y, x % kSize.height));
  }
  const SrgbByteEncoder encoder;
  const Image<Rgba16> straight = straightPixels16({kWhole, picture, guides});
  const Image<Rgba16> exact =
      opaquePixels16({kWhole, picture, guides}, background, barePixels16(background));
  const Image<Rgba8> narrow =
      opaquePixels8({kWhole, picture, guides}, background, barePixels8(background), encoder);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const auto share = [](std::uint16_t v) { return static_cast<float>(v) / 65535.0F; };
      const Rgba16 s = straight(x, y);
      const Rgb wanted =
          composited(Rgba{share(s.r), share(s.g), share(s.b), share(s.a)}, background(x, y));
      ASSERT_NEAR(exact(x, y).r, wide(wanted.r), 2);
      ASSERT_NEAR(exact(x, y).b, wide(wanted.b), 2);
      ASSERT_EQ(exact(x, y).a, 65535);
      ASSERT_NEAR(narrow(x, y).g, 255.0F * wanted.g, 0.51F);
      ASSERT_EQ(narrow(x, y).a, 255);
    }
  }
}

}  // namespace
}  // namespace fluidymation
