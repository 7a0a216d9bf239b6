#include "guides/shape_change.h"

#include <gtest/gtest.h>

#include <cstddef>
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

Image<float> fieldOf(int frame) { return motionDistance(signedDistance(growingDisc(frame))); }

TEST(ShapeChanges, AreTheSmoothedFieldAndTheStepsOfTheTemporalKernel) {
  for (const float sigma : {0.0F, 0.5F, 2.0F}) {
    ShapeChanges changes(kFrames, sigma, growingDisc);
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
      EXPECT_TRUE(test::nearEverywhere(smooth, change.smooth, 1e-4F));

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

TEST(ShapeChanges, AskForEveryMaskInOrderAndNotBeforeTheKernelReachesIt) {
  std::vector<int> asked;
  ShapeChanges changes(kFrames, 1.0F, [&](int frame) {
    asked.push_back(frame);
    return growingDisc(frame);
  });
  (void)changes.at(0);
  EXPECT_LT(asked.size(), static_cast<std::size_t>(kFrames));
  for (int frame = 1; frame < kFrames; ++frame) (void)changes.at(frame);
  EXPECT_EQ(asked, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace fluidymation
