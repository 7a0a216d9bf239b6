#include "inspect/shape_figures.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr Size kSize{40, 30};

/// Guides of a rectangle of which all known: no smoothing, no motion but what is set here.
GuideFrame rectangle(int left, int top, int width, int height) {
  const Mask mask = test::maskOf(kSize, [&](int x, int y) {
    return x >= left && x < left + width && y >= top && y < top + height;
  });
  std::vector<Mask> masks;
  masks.push_back(mask.clone());
  return std::move(test::guidesOf(masks, 0.0F).front());
}

TEST(ShapeFigures, CountTheRegionsOfARectangle) {
  const GuideFrame frame = rectangle(5, 5, 20, 10);
  const ShapeFigures figures = measureShape(frame, nullptr, 3.0F);
  EXPECT_EQ(figures.framePx, 1200);
  EXPECT_EQ(figures.insidePx, 200);
  EXPECT_EQ(figures.sharedPx, 0);
  EXPECT_EQ(figures.borderPx, 2 * 20 + 2 * 8);
  EXPECT_EQ(figures.cutPx, 0);
  EXPECT_EQ(figures.interiorPx, 16 * 6);  // distances are 1, 2, 3, ... from the edge inwards
  EXPECT_EQ(figures.depthPx, 5.0F);
  EXPECT_EQ(figures.borderSpeedPx, 0.0);
}

TEST(ShapeFigures, TellPartsThinnerThanAPatch) {
  EXPECT_EQ(measureShape(rectangle(5, 5, 20, 3), nullptr, 3.0F).thinPx, 60);
  const ShapeFigures thick = measureShape(rectangle(5, 5, 20, 12), nullptr, 3.0F);
  EXPECT_LT(thick.thinPx, 10);  // the corners
}

TEST(ShapeFigures, ShareWithTheFrameBeforeAndTheSpeedOfTheBorder) {
  GuideFrame frame = rectangle(5, 5, 10, 10);
  for (Vec2& flow : frame.flow) flow = {3.0F, 4.0F};
  const GuideFrame before = rectangle(0, 5, 10, 10);
  const ShapeFigures figures = measureShape(frame, &before.mask, 3.0F);
  EXPECT_EQ(figures.sharedPx, 50);
  EXPECT_DOUBLE_EQ(figures.borderSpeedPx, 5.0);
}

TEST(ShapeFigures, CountWhatThePictureCutsOff) {
  EXPECT_EQ(measureShape(rectangle(0, 5, 10, 10), nullptr, 3.0F).cutPx, 10);
}

TEST(ShapeFigures, EmptyAndFullMasksHaveNoEdge) {
  const ShapeFigures empty = measureShape(rectangle(0, 0, 0, 0), nullptr, 3.0F);
  EXPECT_TRUE(empty.empty());
  EXPECT_FALSE(empty.full());
  const ShapeFigures full = measureShape(rectangle(0, 0, 40, 30), nullptr, 3.0F);
  EXPECT_TRUE(full.full());
  EXPECT_EQ(full.interiorPx, 1200);
  EXPECT_EQ(full.depthPx, 0.0F);
  EXPECT_EQ(full.borderPx, 0);
}

TEST(ShapeFigures, SpreadAndMedianAreThoseOfTheNumbers) {
  const Spread spread = spreadOf({3.0, 1.0, 8.0});
  EXPECT_EQ(spread.least, 1.0);
  EXPECT_EQ(spread.mean, 4.0);
  EXPECT_EQ(spread.largest, 8.0);
  EXPECT_EQ(spreadOf({}).largest, 0.0);
  EXPECT_EQ(medianOf({9.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(medianOf({9.0, 1.0, 2.0, 4.0}), 3.0);
  EXPECT_EQ(medianOf({}), 0.0);
}

TEST(ShapeFigures, TheTypicalSpeedLeavesOutTheFirstFrameAndThoseWithoutBorder) {
  SequenceFigures sequence;
  for (const double speed : {100.0, 2.0, 0.0, 4.0, 3.0}) {
    ShapeFigures frame;
    frame.borderPx = speed > 0.0 ? 10 : 0;
    frame.borderSpeedPx = speed;
    sequence.frames.push_back(frame);
  }
  EXPECT_EQ(typicalBorderSpeed(sequence), 3.0);
}

}  // namespace
}  // namespace fluidymation
