#include "inspect/guide_pictures.h"

#include <gtest/gtest.h>

#include "fluidymation/io/png.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

TEST(GuidePictures, ShowFirstAndLastAndSomeBetween) {
  for (const int count : {1, 2, 5, 6, 7, 100}) {
    const GuidePictures pictures(count);
    int shown = 0;
    for (int i = 0; i < count; ++i) shown += pictures.shows(i) ? 1 : 0;
    EXPECT_EQ(shown, std::min(count, GuidePictures::kMostFrames)) << count;
    EXPECT_TRUE(pictures.shows(0));
    EXPECT_TRUE(pictures.shows(count - 1));
  }
}

TEST(GuidePictures, AreThoseOfTheGuides) {
  const Size size{80, 60};
  std::vector<Mask> masks;
  masks.push_back(test::disc(size, {30.0F, 30.0F}, 20.0F));
  GuideFrame frame = std::move(test::guidesOf(masks, 0.0F).front());
  for (Vec2& flow : frame.flow) flow = {2.0F, 0.0F};  // to the right: red
  GuidePictures pictures(1);
  pictures.keep(7, frame);
  const test::TemporaryFolder folder;
  const std::string scale = pictures.write(folder.file(""), 8.0F);
  EXPECT_NE(scale.find("1.0 px a frame"), std::string::npos) << scale;
  const std::vector<std::string> paths = pictures.paths(folder.file(""));
  ASSERT_EQ(paths.size(), 5U);
  for (const std::string& path : paths) EXPECT_EQ(readPng(path).size(), size) << path;

  const auto pixel = [&](std::size_t path, int x, int y) { return readPng(paths[path])(x, y); };
  const Rgba flow = pixel(0, 30, 30);
  EXPECT_EQ(flow.r, 1.0F);
  EXPECT_EQ(flow.g, 0.0F);
  EXPECT_EQ(flow.b, 0.0F);
  EXPECT_EQ(pixel(3, 30, 30).r, 1.0F);                // the deepest
  EXPECT_GT(pixel(4, 30, 12).r, pixel(4, 30, 12).b);  // border
  EXPECT_LT(pixel(4, 30, 30).r, pixel(4, 30, 30).b);  // interior
  EXPECT_EQ(pixel(1, 79, 0).r, pixel(4, 79, 0).r);    // outside alike
}

TEST(GuidePictures, AreReducedToABoundedSize) {
  const Size size{1300, 20};
  std::vector<Mask> masks;
  masks.push_back(test::disc(size, {30.0F, 10.0F}, 8.0F));
  GuidePictures pictures(1);
  pictures.keep(1, test::guidesOf(masks, 0.0F).front());
  const test::TemporaryFolder folder;
  (void)pictures.write(folder.file(""), 8.0F);
  EXPECT_EQ(readPngSize(pictures.paths(folder.file("")).front()),
            (Size{GuidePictures::kLongestSidePx, 10}));
}

}  // namespace
}  // namespace fluidymation
