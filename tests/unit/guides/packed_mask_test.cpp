#include "fluidymation/guides/packed_mask.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fluidymation/core/box.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

/// Sizes with rows shorter and longer than a word, and of words.
const std::vector<Size> kSizes = {{1, 1}, {8, 8}, {63, 1}, {13, 5}, {65, 3}, {64, 4}, {150, 7}};

/// All, none, noise, and a shape.
std::vector<Mask> masksOf(Size size) {
  std::vector<Mask> masks;
  masks.emplace_back(size, std::uint8_t{1});
  masks.emplace_back(size);
  masks.push_back(test::randomMask(size, 21, 50));
  masks.push_back(test::randomBlobs(size, 3));
  return masks;
}

Image<Vec2> numbered(Size size) {
  Image<Vec2> image(size);
  float number = 1.0F;
  for (Vec2& v : image) v = {number++, -number};
  return image;
}

TEST(PackedMask, UnpacksWhatWasPacked) {
  for (const Size size : kSizes) {
    for (const Mask& mask : masksOf(size)) {
      const PackedMask packed(mask);
      EXPECT_EQ(packed.size(), size);
      EXPECT_EQ(packed.count(), countInside(mask));
      EXPECT_TRUE(test::equalEverywhere(mask, packed.unpack()));
    }
  }
}

TEST(PackedMask, UnpacksBoxes) {
  for (const Size size : kSizes) {
    for (const Mask& mask : masksOf(size)) {
      const Box box{size.width / 3, size.height / 4, size.width, (size.height + 1) / 2};
      EXPECT_TRUE(test::equalEverywhere(cropped(mask, box), PackedMask(mask).unpack(box)));
    }
  }
}

TEST(PackedMask, KnowsItsBox) {
  for (const Size size : kSizes) {
    for (const Mask& mask : masksOf(size)) {
      const Box box = PackedMask(mask).box();
      const Box expected = boundingBox(mask);
      EXPECT_EQ(box.beginX, expected.beginX);
      EXPECT_EQ(box.beginY, expected.beginY);
      EXPECT_EQ(box.endX, expected.endX);
      EXPECT_EQ(box.endY, expected.endY);
    }
  }
}

TEST(PackedMask, AnyNonzeroByteIsInside) {
  EXPECT_TRUE(
      test::equalEverywhere(Mask(Size{70, 2}, 1), PackedMask(Mask(Size{70, 2}, 255)).unpack()));
}

TEST(PackedMask, GathersAndScattersItsPixels) {
  for (const Size size : kSizes) {
    const Image<Vec2> image = numbered(size);
    for (const Mask& mask : masksOf(size)) {
      const PackedMask packed(mask);
      std::vector<Vec2> expected;
      Image<Vec2> inside(size);
      for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
        if (mask.data()[i] == 0) continue;
        expected.push_back(image.data()[i]);
        inside.data()[i] = image.data()[i];
      }
      const std::vector<Vec2> values = gather(packed, image);
      ASSERT_EQ(values.size(), expected.size());
      for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i].x, expected[i].x);
      EXPECT_TRUE(test::nearEverywhere(inside, scatter(packed, values), 0.0F));

      const Box box = boundingBox(mask);
      const std::vector<Vec2> fromBox = gather(packed, cropped(image, box), box);
      ASSERT_EQ(fromBox.size(), expected.size());
      for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(fromBox[i].x, expected[i].x);
      const Box middle{size.width / 4, size.height / 4, 3 * size.width / 4 + 1,
                       3 * size.height / 4 + 1};
      for (const Box& part : {box, middle}) {
        EXPECT_TRUE(
            test::nearEverywhere(cropped(inside, part), scatter(packed, values, part), 0.0F));
      }
    }
  }
}

TEST(PackedMask, StretchesTellWhatTwoMasksShare) {
  for (const Size size : kSizes) {
    for (const Mask& mask : masksOf(size)) {
      for (const Mask& other : masksOf(size)) {
        std::vector<int> ranks;       // of the other mask, -1 where it is not shared
        std::vector<int> otherRanks;  // of every pixel
        int rank = 0;
        for (const std::uint8_t m : other) otherRanks.push_back(m != 0 ? rank++ : -1);
        forEachStretch(PackedMask(mask), PackedMask(other),
                       [&](std::size_t begin, std::size_t end, std::size_t own, bool isShared,
                           std::size_t otherRank) {
                         EXPECT_EQ(own, ranks.size());
                         for (std::size_t i = begin; i < end; ++i) {
                           ranks.push_back(isShared ? static_cast<int>(otherRank + i - begin) : -1);
                         }
                       });
        std::vector<int> expected;
        for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
          if (mask.data()[i] != 0) expected.push_back(otherRanks[i]);
        }
        EXPECT_EQ(ranks, expected);
        const auto unshared = std::count(expected.begin(), expected.end(), -1);
        EXPECT_EQ(PackedMask(mask).countShared(PackedMask(other)),
                  expected.size() - static_cast<std::size_t>(unshared));
      }
    }
  }
}

}  // namespace
}  // namespace fluidymation
