#include "fluidymation/guides/temporal_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

template <typename Value>
double average(const TemporalWeights& window, const Value& value) {
  double sum = 0.0;
  for (std::size_t i = 0; i < window.weights.size(); ++i) {
    sum += static_cast<double>(window.weights[i]) * value(window.firstFrame + static_cast<int>(i));
  }
  return sum;
}

TEST(TemporalWeights, AreTheGaussianFarFromTheEnds) {
  const std::vector<float> kernel = gaussianKernel(2.0F);
  const TemporalWeights window = temporalWeights(20, 50, 2.0F);
  ASSERT_EQ(window.firstFrame, 14);
  ASSERT_EQ(window.weights.size(), 13U);
  for (int i = 0; i < 13; ++i) {
    EXPECT_FLOAT_EQ(window.weights[static_cast<std::size_t>(i)],
                    kernel[static_cast<std::size_t>(std::abs(i - 6))]);
  }
}

TEST(TemporalWeights, KeepEvenChangeExactlyInSequencesOfAnyLength) {
  for (int count = 1; count <= 15; ++count) {
    for (int frame = 0; frame < count; ++frame) {
      const TemporalWeights window = temporalWeights(frame, count, 2.0F);
      EXPECT_NEAR(average(window, [](int i) { return 5.0 - 3.0 * i; }), 5.0 - 3.0 * frame, 1e-4)
          << frame << " of " << count;
    }
  }
}

TEST(TemporalWeights, LeaveTheEndsAsTheyAre) {
  const auto bumpy = [](int i) { return static_cast<double>((i * i * 7 + 3 * i) % 11); };
  for (const int count : {2, 3, 5, 8, 30}) {
    EXPECT_NEAR(average(temporalWeights(0, count, 2.0F), bumpy), bumpy(0), 1e-4);
    EXPECT_NEAR(average(temporalWeights(count - 1, count, 2.0F), bumpy), bumpy(count - 1), 1e-4);
  }
}

TEST(TemporalWeights, AreMirroredWhenTimeIs) {
  for (const int count : {2, 3, 4, 7, 12, 20}) {
    for (int frame = 0; frame < count; ++frame) {
      const TemporalWeights there = temporalWeights(frame, count, 2.0F);
      TemporalWeights back = temporalWeights(count - 1 - frame, count, 2.0F);
      ASSERT_EQ(there.weights.size(), back.weights.size());
      EXPECT_EQ(there.firstFrame + static_cast<int>(there.weights.size()), count - back.firstFrame);
      for (std::size_t i = 0; i < there.weights.size(); ++i) {
        EXPECT_NEAR(there.weights[i], back.weights[there.weights.size() - 1 - i], 1e-6F);
      }
    }
  }
}

TEST(StepWeights, AddUpToTheStepOfTheSmoothedSequence) {
  for (const int frameCount : {2, 3, 7, 30}) {
    for (const float sigma : {0.0F, 0.6F, 2.0F}) {
      std::vector<double> values;
      for (int i = 0; i < frameCount; ++i) values.push_back(std::sin(1.7 * i) + 0.1 * i * i);
      const auto smooth = [&](int frame) {
        const TemporalWeights window = temporalWeights(frame, frameCount, sigma);
        double sum = 0.0;
        for (std::size_t i = 0; i < window.weights.size(); ++i) {
          sum += window.weights[i] * values[static_cast<std::size_t>(window.firstFrame) + i];
        }
        return sum;
      };
      for (int frame = 1; frame < frameCount; ++frame) {
        const TemporalWeights steps = stepWeights(frame, frameCount, sigma);
        double sum = 0.0;
        double total = 0.0;
        for (std::size_t s = 0; s < steps.weights.size(); ++s) {
          const std::size_t from = static_cast<std::size_t>(steps.firstFrame) + s;
          sum += steps.weights[s] * (values[from + 1] - values[from]);
          total += steps.weights[s];
        }
        EXPECT_NEAR(sum, smooth(frame) - smooth(frame - 1), 1e-4);
        EXPECT_NEAR(total, 1.0, 1e-5);
      }
    }
  }
}

TEST(TemporalWeights, SigmaZeroIsTheFrameItself) {
  const TemporalWeights window = temporalWeights(3, 9, 0.0F);
  EXPECT_EQ(window.firstFrame, 3);
  EXPECT_EQ(window.weights, std::vector<float>{1.0F});
}

}  // namespace
}  // namespace fluidymation
