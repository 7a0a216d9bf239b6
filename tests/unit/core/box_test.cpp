#include "fluidymation/core/box.h"

#include <gtest/gtest.h>

#include <vector>

namespace fluidymation {
namespace {

constexpr Size kSize{11, 9};

bool holds(const Box& outer, const Box& inner) {
  return outer.beginX <= inner.beginX && outer.beginY <= inner.beginY && outer.endX >= inner.endX &&
         outer.endY >= inner.endY;
}

/// Every box that is not empty in an image of `size`.
std::vector<Box> everyBox(Size size) {
  std::vector<Box> boxes;
  for (int beginY = 0; beginY < size.height; ++beginY) {
    for (int beginX = 0; beginX < size.width; ++beginX) {
      for (int endY = beginY + 1; endY <= size.height; ++endY) {
        for (int endX = beginX + 1; endX <= size.width; ++endX) {
          boxes.push_back({beginX, beginY, endX, endY});
        }
      }
    }
  }
  return boxes;
}

TEST(Box, AlignedIsTheSmallestOfWholeBlocksThatHoldsIt) {
  for (const int step : {1, 2, 4, 8, 16}) {
    for (const Box& box : everyBox(kSize)) {
      const Box aligned = alignedTo(box, step, kSize);
      ASSERT_TRUE(holds(aligned, box));
      ASSERT_TRUE(holds({0, 0, kSize.width, kSize.height}, aligned));
      ASSERT_EQ(aligned.beginX % step, 0);
      ASSERT_EQ(aligned.beginY % step, 0);
      ASSERT_LT(box.beginX - aligned.beginX, step);
      ASSERT_LT(box.beginY - aligned.beginY, step);
      // The last block may be cut by the image
      ASSERT_TRUE(aligned.endX % step == 0 || aligned.endX == kSize.width);
      ASSERT_TRUE(aligned.endY % step == 0 || aligned.endY == kSize.height);
      ASSERT_LT(aligned.endX - box.endX, step);
      ASSERT_LT(aligned.endY - box.endY, step);
      ASSERT_EQ(alignedTo(aligned, step, kSize), aligned);
    }
  }
}

TEST(Box, AlignedOrGrownAnEmptyOneStaysEmpty) {
  EXPECT_EQ(alignedTo(Box{}, 8, kSize), Box{});
  EXPECT_EQ(grown(Box{}, 4, kSize), Box{});
  EXPECT_EQ(grown(Box{5, 5, 5, 8}, 4, kSize), Box{});
}

/// An image whose values tell where in the whole image they come from; none is 0.
Image<int> numbered(const Box& box) {
  Image<int> image(box.size());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image(x, y) = 1 + (box.beginY + y) * kSize.width + box.beginX + x;
    }
  }
  return image;
}

TEST(Box, RecroppedShowsWhatBothBoxesShareAndNothingElse) {
  const std::vector<Box> boxes = everyBox({6, 4});
  for (const Box& from : boxes) {
    const Image<int> image = numbered(from);
    for (const Box& to : boxes) {
      const Image<int> part = recropped(image, from, to);
      ASSERT_EQ(part.size(), to.size());
      const Image<int> wanted = numbered(to);
      for (int y = 0; y < part.height(); ++y) {
        for (int x = 0; x < part.width(); ++x) {
          const bool shared =
              holds(from, {to.beginX + x, to.beginY + y, to.beginX + x + 1, to.beginY + y + 1});
          ASSERT_EQ(part(x, y), shared ? wanted(x, y) : 0);
        }
      }
    }
  }
}

TEST(Box, RecroppedFromNothingOrToNothing) {
  const Box some{2, 1, 7, 5};
  for (const int value : recropped(Image<int>(), Box{}, some)) ASSERT_EQ(value, 0);
  EXPECT_EQ(recropped(Image<int>(), Box{}, some).size(), some.size());
  EXPECT_TRUE(recropped(numbered(some), some, Box{}).empty());
  EXPECT_TRUE(recropped(Image<int>(), Box{}, Box{}).empty());
}

}  // namespace
}  // namespace fluidymation
