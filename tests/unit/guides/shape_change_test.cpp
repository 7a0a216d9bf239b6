#include "guides/shape_change.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "fluidymation/guides/distance_field.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr int kFrames = 9;
const Size kSize{40, 34};

Mask growingDisc(int frame) {
  return test::disc(kSize, {19.3F, 16.8F}, 5.0F + static_cast<float>(frame));
}

ShapeChanges::Shape shapeOf(int frame) {
  return {growingDisc(frame), continuousDistance(signedDistance(growingDisc(frame)))};
}

Image<float> fieldOf(int frame) { return motionDistance(signedDistance(growingDisc(frame))); }

TEST(ShapeChanges, AreTheSmoothedFieldAndTheStepsOfTheTemporalKernel) {
  for (const float sigma : {0.0F, 0.5F, 2.0F}) {
    ShapeChanges changes(kFrames, sigma, shapeOf);
    for (int frame = 0; frame < kFrames; ++frame) {
      SCOPED_TRACE(frame);
      const ShapeChange change = changes.at(frame);

      const TemporalWeights window = temporalWeights(frame, kFrames, sigma);
      Image<float> smooth(kSize);
      for (std::size_t i = 0; i < window.weights.size(); ++i) {
        const Image<float> field = fieldOf(window.firstFrame + static_cast<int>(i));
        for (std::size_t p = 0; p < smooth.pixelCount(); ++p) {
          smooth.data()[p] += window.weights[i] * field.data()[p];
        }
      }
      Image<float> ownSmooth(kSize);
      for (const WeightedField& share : change.smooth) {
        for (std::size_t p = 0; p < ownSmooth.pixelCount(); ++p) {
          ownSmooth.data()[p] += share.weight * share.field->data()[p];
        }
      }
      EXPECT_TRUE(test::nearEverywhere(smooth, ownSmooth, 1e-4F));

      const TemporalWeights steps = stepWeights(frame == 0 ? 1 : frame, kFrames, sigma);
      EXPECT_EQ(change.stepWeights, steps.weights);
      ASSERT_EQ(change.fields.size(), steps.weights.size() + 1);
      for (std::size_t s = 0; s < change.fields.size(); ++s) {
        const Image<float> field = fieldOf(steps.firstFrame + static_cast<int>(s));
        EXPECT_TRUE(test::nearEverywhere(field, *change.fields[s], 0.0F)) << s;
      }
    }
  }
}

TEST(ShapeChanges, MeasureTheDepthBeforeAnyBlur) {
  ShapeChanges changes(kFrames, 2.0F, shapeOf);
  for (int frame = 0; frame < kFrames; ++frame) {
    const Image<float> distance = shapeOf(frame).distance;
    const std::vector<float> deepest = {*std::max_element(distance.begin(), distance.end())};
    EXPECT_EQ(changes.at(frame).thicknesses, deepest) << frame;
  }
}

TEST(ShapeChanges, AskForNoShapeBeforeTheKernelReachesItAndForEachOnce) {
  std::vector<int> asked;
  ShapeChanges changes(kFrames, 1.0F, [&](int frame) {
    asked.push_back(frame);
    return shapeOf(frame);
  });
  (void)changes.at(0);
  EXPECT_LT(asked.back(), kFrames - 1);
  for (int frame = 1; frame < kFrames; ++frame) (void)changes.at(frame);
  std::vector<int> all(kFrames);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(asked, all);
}

TEST(ShapeChanges, AreTheSameWhereARepeatedShapeIsNotAskedForAgain) {
  const auto disc = [](int frame) { return frame < 3 ? frame : frame < 7 ? 3 : frame; };
  const auto held = [&](int frame) { return shapeOf(disc(frame)); };
  ShapeChanges asking(kFrames, 0.5F, held);
  std::vector<int> asked;
  ShapeChanges keeping(
      kFrames, 0.5F,
      [&](int frame) {
        asked.push_back(frame);
        return held(frame);
      },
      [&](int frame) { return disc(frame) == disc(frame - 1); });
  for (int frame = 0; frame < kFrames; ++frame) {
    SCOPED_TRACE(frame);
    const ShapeChange expected = asking.at(frame);
    const ShapeChange kept = keeping.at(frame);
    EXPECT_EQ(kept.thicknesses, expected.thicknesses);
    ASSERT_EQ(kept.fields.size(), expected.fields.size());
    for (std::size_t s = 0; s < kept.fields.size(); ++s) {
      EXPECT_TRUE(test::nearEverywhere(*expected.fields[s], *kept.fields[s], 0.0F)) << s;
    }
  }
  EXPECT_EQ(asked, (std::vector<int>{0, 1, 2, 3, 7, 8}));
}

}  // namespace
}  // namespace fluidymation
