#include "fluidymation/synthesis/nnf_scaling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fluidymation/core/random.h"

namespace fluidymation {
namespace {

Rotation turn(float radians) { return {std::cos(radians), std::sin(radians)}; }

NearestNeighborField randomField(Size size, std::uint64_t seed) {
  NearestNeighborField nnf(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Random random({seed, 0, 0, 0, x, y});
      nnf(x, y) = {static_cast<float>(random.uniform(0, 99)) + 0.25F,
                   static_cast<float>(random.uniform(0, 99)) + 0.25F, random.uniform(0, 19),
                   turn(0.1F + static_cast<float>(random.uniform(0, 31)))};
    }
  }
  return nnf;
}

void expectNear(const Match& expected, const Match& actual, const char* what, int x, int y) {
  EXPECT_NEAR(expected.x, actual.x, 1e-4F) << what << " at " << x << ", " << y;
  EXPECT_NEAR(expected.y, actual.y, 1e-4F) << what << " at " << x << ", " << y;
  EXPECT_EQ(expected.frame, actual.frame) << what << " at " << x << ", " << y;
  EXPECT_EQ(expected.rotation.cosine, actual.rotation.cosine) << what;
  EXPECT_EQ(expected.rotation.sine, actual.rotation.sine) << what;
}

TEST(NnfScaling, DownAfterUpIsTheIdentity) {
  const NearestNeighborField field = randomField({6, 5}, 1);
  const Image<Segment> inside(Size{12, 10}, Segment::kBorder);
  const NearestNeighborField back = downscale(upscale(field, inside), 1);
  ASSERT_EQ(back.size(), field.size());
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 6; ++x) expectNear(field(x, y), back(x, y), "down(up)", x, y);
  }
}

TEST(NnfScaling, DownThreeLevelsAfterThreeUpIsTheIdentity) {
  const NearestNeighborField field = randomField({3, 2}, 2);
  const NearestNeighborField twice =
      upscale(upscale(upscale(field, Image<Segment>(Size{6, 4}, Segment::kBorder)),
                      Image<Segment>(Size{12, 8}, Segment::kBorder)),
              Image<Segment>(Size{24, 16}, Segment::kBorder));
  const NearestNeighborField back = downscale(twice, 3);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) expectNear(field(x, y), back(x, y), "down3(up3)", x, y);
  }
}

TEST(NnfScaling, WithoutRotationUpscalingIsTheFormulaOfSection24) {
  NearestNeighborField coarse(Size{2, 2});
  coarse(1, 0) = {7.0F, 9.0F, 3, Rotation{}};
  const NearestNeighborField fine = upscale(coarse, Image<Segment>(Size{4, 4}, Segment::kBorder));
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      EXPECT_FLOAT_EQ(fine(2 + dx, dy).x, 14.0F + static_cast<float>(dx));
      EXPECT_FLOAT_EQ(fine(2 + dx, dy).y, 18.0F + static_cast<float>(dy));
      EXPECT_EQ(fine(2 + dx, dy).frame, 3);
    }
  }
  EXPECT_FALSE(fine(0, 0).exists());
}

TEST(NnfScaling, UpscalingLeavesPixelsOutsideTheMaskWithoutMatch) {
  NearestNeighborField coarse(Size{1, 1}, Match{5.0F, 5.0F, 0, Rotation{}});
  Image<Segment> fine(Size{2, 2}, Segment::kOutside);
  fine(1, 1) = Segment::kInterior;
  const NearestNeighborField nnf = upscale(coarse, fine);
  EXPECT_FALSE(nnf(0, 0).exists());
  EXPECT_TRUE(nnf(1, 1).exists());
}

TEST(NnfScaling, TheMostFrequentMatchOfABlockWins) {
  NearestNeighborField fine(Size{2, 2});
  const Match often{10.0F, 10.0F, 4, Rotation{}};  // belongs to (0, 0): block centre at 10.5
  fine(0, 0) = {50.0F, 50.0F, 1, Rotation{}};
  fine(1, 0) = often.moved({1.0F, 0.0F});
  fine(0, 1) = often.moved({0.0F, 1.0F});
  const NearestNeighborField coarse = downscale(fine, 1);
  EXPECT_EQ(coarse(0, 0).frame, 4);
  EXPECT_NEAR(coarse(0, 0).x, 5.0F, 1e-5F);  // (x - c - (q - c)) / 2 with c = 1/2, q = 0
}

TEST(NnfScaling, TiesGoToTheFirstInRowOrder) {
  NearestNeighborField fine(Size{2, 2});
  fine(1, 0) = {30.0F, 30.0F, 7, Rotation{}};
  fine(0, 1) = {3.0F, 3.0F, 2, Rotation{}};
  EXPECT_EQ(downscale(fine, 1)(0, 0).frame, 7);
}

TEST(NnfScaling, BlocksWithoutMatchGetNone) {
  EXPECT_FALSE(downscale(NearestNeighborField(Size{4, 4}), 1)(1, 1).exists());
}

TEST(NnfScaling, NearlyEqualAnglesAreOneChoiceAcrossTheSeamOfTheCircle) {
  // pi - 0.01 and -pi + 0.01 are 0.02 rad apart.
  NearestNeighborField fine(Size{2, 2});
  const Match a{10.0F, 10.0F, 4, turn(3.13159F)};
  const Match b{10.0F, 10.0F, 4, turn(-3.13159F)};
  fine(0, 0) = {50.0F, 50.0F, 1, Rotation{}};
  fine(1, 0) = a.moved({0.5F, -0.5F});
  fine(0, 1) = b.moved({-0.5F, 0.5F});
  EXPECT_EQ(downscale(fine, 1)(0, 0).frame, 4);
}

}  // namespace
}  // namespace fluidymation
