#include "compositing/over.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

TEST(Over, MixesEncodedValuesByStraightAlpha) {
  const Rgb mixed = composited(Rgba{0.8F, 0.4F, 0.0F, 0.25F}, Rgb{0.0F, 0.4F, 1.0F});
  EXPECT_FLOAT_EQ(mixed.r, 0.2F);
  EXPECT_FLOAT_EQ(mixed.g, 0.4F);
  EXPECT_FLOAT_EQ(mixed.b, 0.75F);
}

TEST(Over, NothingShowsTheBackgroundAndAllHidesIt) {
  Image<Rgba> picture({2, 1});
  picture(0, 0) = {0.3F, 0.5F, 0.7F, 0.0F};
  picture(1, 0) = {0.3F, 0.5F, 0.7F, 1.0F};
  const Image<Rgb> result = composited(picture, Image<Rgb>({2, 1}, Rgb{0.9F, 0.1F, 0.2F}));
  EXPECT_EQ(result(0, 0).r, 0.9F);
  EXPECT_EQ(result(0, 0).b, 0.2F);
  EXPECT_EQ(result(1, 0).r, 0.3F);
  EXPECT_EQ(result(1, 0).b, 0.7F);
}

constexpr Rgba kRed{0.9F, 0.1F, 0.2F, 0.5F};
constexpr Rgba kBlue{0.1F, 0.3F, 0.8F, 0.5F};

void expectSame(Rgba found, Rgba expected) {
  EXPECT_FLOAT_EQ(found.r, expected.r);
  EXPECT_FLOAT_EQ(found.g, expected.g);
  EXPECT_FLOAT_EQ(found.b, expected.b);
  EXPECT_FLOAT_EQ(found.a, expected.a);
}

TEST(Over, MixesTwoThatAreTransparent) {
  // Of what shows, two thirds are the upper one's: 1/2 against 1/2 of 1/2.
  expectSame(composited(kRed, kBlue), {(2.0F * 0.9F + 0.1F) / 3.0F, (2.0F * 0.1F + 0.3F) / 3.0F,
                                       (2.0F * 0.2F + 0.8F) / 3.0F, 0.75F});
  EXPECT_GT(composited(kRed, kBlue).r, composited(kBlue, kRed).r) << "the order matters";
}

TEST(Over, KeepsWhatLiesAloneToTheBit) {
  const Rgba nothing{0.7F, 0.7F, 0.7F, 0.0F};
  for (int level = 1; level <= 255; ++level) {
    const Rgba alone{0.9F, 0.1F, 0.2F, static_cast<float>(level) / 255.0F};
    for (const Rgba found : {composited(alone, nothing), composited(nothing, alone)}) {
      EXPECT_EQ(found.r, alone.r);
      EXPECT_EQ(found.g, alone.g);
      EXPECT_EQ(found.b, alone.b);
      EXPECT_EQ(found.a, alone.a);
    }
  }
  expectSame(composited(nothing, nothing), {0.0F, 0.0F, 0.0F, 0.0F});
}

TEST(Over, AgreesWithTheOpaqueKindAndIsAssociative) {
  const Rgba paper{0.95F, 0.94F, 0.9F, 1.0F};
  const Rgb under = composited(kBlue, Rgb{paper.r, paper.g, paper.b});
  const Rgb both = composited(kRed, under);
  expectSame(composited(kRed, composited(kBlue, paper)), {both.r, both.g, both.b, 1.0F});
  expectSame(composited(composited(kRed, kBlue), paper), {both.r, both.g, both.b, 1.0F});
}

TEST(LayOver, GoesOverAllPixels) {
  Image<Rgba> canvas({3, 2}, kBlue);
  Image<Rgba> picture({3, 2}, Rgba{0.0F, 0.0F, 0.0F, 0.0F});
  picture(2, 1) = kRed;
  layOver(picture, canvas);
  expectSame(canvas(0, 0), kBlue);
  expectSame(canvas(2, 1), composited(kRed, kBlue));
}

}  // namespace
}  // namespace fluidymation
