#include "fluidymation/synthesis/pyramid.h"

#include "support/comparison.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

TEST(Pyramid, CoarsestLevelIsTheLastOneNotSmallerThanAPatch) {
  EXPECT_EQ(coarsestLevel({400, 222}, {1000, 800}), 5);  // 222 / 5 = 44.4, log2 = 5.47
  EXPECT_EQ(coarsestLevel({160, 160}, {160, 160}), 5);   // 160 / 5 = 2^5 exactly
  EXPECT_EQ(coarsestLevel({159, 160}, {160, 160}), 4);
  EXPECT_EQ(coarsestLevel({9, 500}, {500, 500}), 0);
  EXPECT_EQ(coarsestLevel({1, 1}, {1000, 800}), 0);
}

TEST(Pyramid, OddSidesRoundUp) {
  EXPECT_EQ(halvedSize({7, 8}), (Size{4, 4}));
  EXPECT_EQ(halvedSize({1, 1}), (Size{1, 1}));
}

TEST(Pyramid, EveryInsidePixelHasAnInsideParent) {
  GuideLevel level = finestLevel(test::GrowingDisc{}.guides(3));
  for (int l = 0; l < 3; ++l) {
    const GuideLevel coarse = halve(level);
    for (int y = 0; y < level.mask.height(); ++y) {
      for (int x = 0; x < level.mask.width(); ++x) {
        if (level.mask(x, y) == 0) continue;
        ASSERT_EQ(coarse.mask(x / 2, y / 2), 1) << x << ' ' << y;
      }
    }
    level = halve(level);
  }
}

TEST(Pyramid, DistanceIsTheBlockMeanAndMotionTheMeanOfInsidePixels) {
  GuideFrame frame = test::GrowingDisc{Size{3, 2}, {0, 0}, 1, 1, 1}.guides(0);
  frame.mask = Mask(Size{3, 2});
  frame.mask(0, 0) = frame.mask(1, 1) = 1;
  float value = 1.0F;
  for (float& d : frame.distance) d = value++;  // 1 2 3 / 4 5 6
  frame.flow(0, 0) = {2.0F, 0.0F};
  frame.flow(1, 1) = {0.0F, 4.0F};
  frame.flow(1, 0) = {100.0F, 100.0F};  // outside: must not count
  frame.accForward(0, 0) = {3.0F, 4.0F};
  frame.accForward(1, 1) = {0.0F, 1.0F};
  const GuideLevel coarse = halve(finestLevel(frame));
  ASSERT_EQ(coarse.mask.size(), (Size{2, 1}));
  EXPECT_FLOAT_EQ(coarse.distance(0, 0), 3.0F);
  EXPECT_FLOAT_EQ(coarse.distance(1, 0), 4.5F);  // only two pixels covered
  EXPECT_FLOAT_EQ(coarse.flow(0, 0).x, 1.0F);
  EXPECT_FLOAT_EQ(coarse.flow(0, 0).y, 2.0F);
  EXPECT_FLOAT_EQ(coarse.extForward(0, 0), 3.0F);
  EXPECT_EQ(coarse.mask(1, 0), 0);
}

TEST(Pyramid, ShapeIsTheBlockMeanAlsoOutsideTheMask) {
  GuideFrame frame = test::GrowingDisc{Size{3, 2}, {0, 0}, 1, 1, 1}.guides(0);
  EXPECT_TRUE(halve(finestLevel(frame)).shape.empty());
  frame.mask = Mask(Size{3, 2});
  frame.shape = Image<float>(Size{3, 2});
  float value = 1.0F;
  for (float& s : frame.shape) s = value++;  // 1 2 3 / 4 5 6
  const GuideLevel coarse = halve(finestLevel(frame));
  EXPECT_FLOAT_EQ(coarse.shape(0, 0), 3.0F);
  EXPECT_FLOAT_EQ(coarse.shape(1, 0), 4.5F);
}

TEST(Pyramid, LevelsKnowWhereDistancesAreStandIns) {
  GuideLevel level = finestLevel(test::GrowingDisc{}.guides(3));
  EXPECT_FALSE(level.edgeless());
  EXPECT_FALSE(halve(level).edgeless());
  level.distance = Image<float>(level.distance.size(), 88.0F);
  EXPECT_TRUE(level.edgeless());
  EXPECT_TRUE(halve(level).edgeless());
}

TEST(Pyramid, DirectionsHaveUnitLengthInsideOnEveryLevel) {
  GuideLevel level = finestLevel(test::GrowingDisc{}.guides(3));
  for (int l = 0; l < 3; ++l) {
    level = halve(level);
    for (int y = 0; y < level.mask.height(); ++y) {
      for (int x = 0; x < level.mask.width(); ++x) {
        EXPECT_NEAR(length(level.direction(x, y)), level.mask(x, y) != 0 ? 1.0F : 0.0F, 1e-5F);
      }
    }
  }
}

TEST(Pyramid, ConstantColourStaysConstant) {
  const Image<Lab> image(Size{9, 6}, Lab{50.0F, -10.0F, 20.0F});
  for (const Lab& lab : halve(image)) {
    EXPECT_NEAR(lab.l, 50.0F, 1e-4F);
    EXPECT_NEAR(lab.a, -10.0F, 1e-4F);
    EXPECT_NEAR(lab.b, 20.0F, 1e-4F);
  }
}

TEST(Pyramid, LinearRampIsSampledAtBlockCentres) {
  Image<Lab> image(Size{16, 16});
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) image(x, y).l = static_cast<float>(x + 2 * y);
  }
  const Image<Lab> coarse = halve(image);
  for (int y = 1; y < 7; ++y) {
    for (int x = 1; x < 7; ++x) {
      EXPECT_NEAR(coarse(x, y).l, 2.0 * x + 0.5 + 2.0 * (2.0 * y + 0.5), 1e-4);
    }
  }
}

TEST(Pyramid, SegmentsSplitAtTheBorderWidth) {
  const GuideLevel level = finestLevel(test::GrowingDisc{}.guides(0));  // radius 8 round (24, 20)
  EXPECT_EQ(level.segment(24, 20, 5.0F), Segment::kInterior);
  EXPECT_EQ(level.segment(30, 20, 5.0F), Segment::kBorder);
  EXPECT_EQ(level.segment(40, 20, 5.0F), Segment::kOutside);
}

}  // namespace
}  // namespace fluidymation
