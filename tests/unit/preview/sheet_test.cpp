#include "preview/sheet.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

TEST(Sheet, ChoosesFirstAndLastAndEvenlyBetween) {
  EXPECT_EQ(evenly(3, 12), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(evenly(9, 3), (std::vector<int>{0, 4, 8}));
  EXPECT_EQ(evenly(1'000'000, 2), (std::vector<int>{0, 999'999}));
  EXPECT_EQ(evenly(1, 2), (std::vector<int>{0}));
}

TEST(Sheet, FitsWithEvenSides) {
  EXPECT_EQ(fitted({1000, 800}, 320), (Size{320, 256}));
  EXPECT_EQ(fitted({301, 201}, 320), (Size{302, 202}));
  EXPECT_EQ(fitted({5000, 1}, 320), (Size{320, 2}));
}

TEST(Sheet, LaysPicturesInRowsOfFour) {
  std::vector<Image<Rgb>> pictures;
  for (int i = 0; i < 6; ++i) {
    pictures.emplace_back(Size{10, 8}, Rgb{static_cast<float>(i) / 10.0F, 0.0F, 0.0F});
  }
  const Image<Rgb> sheet = inRows(pictures);
  EXPECT_EQ(sheet.size(), (Size{4 * 14 - 4, 2 * 12 - 4}));
  EXPECT_EQ(sheet(0, 0).r, 0.0F);
  EXPECT_EQ(sheet(14, 0).r, 0.1F);
  EXPECT_EQ(sheet(14 + 9, 12 + 7).r, 0.5F);
  EXPECT_EQ(sheet(12, 0).r, 1.0F);           // the gap
  EXPECT_EQ(sheet(3 * 14 + 5, 15).r, 1.0F);  // no picture
}

TEST(Sheet, LaysPicturesBesideEachOther) {
  std::vector<Image<Rgb>> pictures;
  pictures.emplace_back(Size{3, 5}, Rgb{0.25F, 0.0F, 0.0F});
  pictures.emplace_back(Size{10, 5}, Rgb{0.5F, 0.0F, 0.0F});
  const Image<Rgb> row = besideEachOther(pictures);
  EXPECT_EQ(row.size(), (Size{17, 5}));
  EXPECT_EQ(row(2, 4).r, 0.25F);
  EXPECT_EQ(row(7, 4).r, 0.5F);
}

}  // namespace
}  // namespace fluidymation
