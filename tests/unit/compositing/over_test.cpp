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

}  // namespace
}  // namespace fluidymation
