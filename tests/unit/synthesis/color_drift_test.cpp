#include "synthesis/color_drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation {
namespace {

constexpr int kDeepest = static_cast<int>(kEdgeScale * kEdgeSteps);

struct Sample {
  int edge;
  Lab difference;
  float speedPx;
};

/// From a little outside the edge to deep inside.
std::vector<Sample> samples(int count) {
  Random random({7});
  const auto hundredths = [&](int low, int high) {
    return 0.01F * static_cast<float>(random.uniform(low, high));
  };
  std::vector<Sample> all;
  for (int i = 0; i < count; ++i) {
    const int edge = random.uniform(-100, kDeepest + 200);
    const Lab difference{hundredths(-1000, 3000), hundredths(-500, 1500), hundredths(-3000, 0)};
    all.push_back({edge, difference, hundredths(0, 300)});
  }
  return all;
}

DriftSums sumsOf(const std::vector<Sample>& all) {
  DriftSums sums;
  for (const Sample& sample : all) sums.add(sample.edge, sample.difference, sample.speedPx);
  return sums;
}

TEST(ColorDrift, OfNoPixelsIsNone) {
  const ColorDrift none{DriftSums()};
  for (const int edge : {-500, 0, 700, kDeepest, 30000}) {
    EXPECT_EQ(none.at(edge).l, 0.0F);
    EXPECT_EQ(none.at(edge).a, 0.0F);
    EXPECT_EQ(none.at(edge).b, 0.0F);
  }
}

TEST(ColorDrift, IsTheMeanOfManyPixelsAndHardlyThatOfFewHoweverFast) {
  for (const float speedPx : {0.125F, 1.0F, 50.0F}) {
    for (const int count : {1, 25, 1000}) {
      DriftSums sums;
      for (int i = 0; i < count; ++i) sums.add(kDeepest, {8.0F, -4.0F, 2.0F}, speedPx);
      const ColorDrift drift(sums);
      const float trusted = static_cast<float>(count) / (static_cast<float>(count) + 25.0F);
      EXPECT_NEAR(drift.at(kDeepest).l, 8.0F * trusted, 1e-4F) << count;
      EXPECT_NEAR(drift.at(kDeepest).a, -4.0F * trusted, 1e-4F) << count;
      EXPECT_NEAR(drift.at(kDeepest).b, 2.0F * trusted, 1e-4F) << count;
      EXPECT_EQ(drift.at(30000).l, drift.at(kDeepest).l) << "deep inside all is alike";
      EXPECT_EQ(drift.at(0).l, 0.0F) << "no other depth is concerned";
    }
  }
}

TEST(ColorDrift, PixelsCountByWhatTheyMove) {
  DriftSums sums;
  for (int i = 0; i < 2000; ++i) sums.add(0, {8.0F, 0.0F, 0.0F}, 3.0F);
  for (int i = 0; i < 8000; ++i) sums.add(0, {-8.0F, 0.0F, 0.0F}, 0.125F);
  const float pixels = 7000.0F * 7000.0F / (2000.0F * 9.0F + 8000.0F / 64.0F);
  const float mean = 8.0F * (6000.0F - 1000.0F) / 7000.0F;
  EXPECT_NEAR(ColorDrift(sums).at(0).l, mean * pixels / (pixels + 25.0F), 1e-3F);
  DriftSums atRest;
  atRest.add(0, {8.0F, 0.0F, 0.0F}, 0.0F);
  EXPECT_EQ(ColorDrift(atRest).at(0).l, 0.0F);
}

TEST(ColorDrift, APixelThatJumpsDoesNotSpeakForTheOthers) {
  DriftSums sums;
  for (int i = 0; i < 100; ++i) sums.add(0, {0.0F, 0.0F, 0.0F}, 1.0F);
  sums.add(0, {50.0F, 0.0F, 0.0F}, 1e5F);
  EXPECT_LT(ColorDrift(sums).at(0).l, 5.0F);
}

TEST(ColorDrift, EveryPixelOfTheLargestFrameMayJump) {
  DriftSums row;
  for (int i = 0; i < 1024; ++i) row.add(kDeepest, {-1000.0F, 1000.0F, 0.0F}, 1e30F);
  DriftSums frame;
  for (int i = 0; i < 1024; ++i) frame.add(row);
  for (int i = 0; i < 8; ++i) frame.add(DriftSums(frame));  // 2^28 pixels
  const ColorDrift drift(frame);
  EXPECT_NEAR(drift.at(kDeepest).l, -1000.0F, 0.01F);
  EXPECT_NEAR(drift.at(kDeepest).a, 1000.0F, 0.01F);
}

/// Against sums in real numbers, where each pixel is shared by the two depths that it lies between.
TEST(ColorDrift, ChangesLinearlyFromDistanceToDistance) {
  constexpr int kLast = static_cast<int>(kDriftDistances) - 1;
  const std::vector<Sample> all = samples(5000);
  const ColorDrift drift(sumsOf(all));
  const auto inSteps = [&](int edge) {
    return kLast * std::min(std::max(static_cast<double>(edge) / kDeepest, 0.0), 1.0);
  };
  std::vector<double> means;
  for (int d = 0; d <= kLast; ++d) {
    double sum = 0.0;
    double weights = 0.0;
    double squares = 0.0;
    for (const Sample& sample : all) {
      const double near = std::max(1.0 - std::abs(inSteps(sample.edge) - d), 0.0);
      const double weight = near * static_cast<double>(sample.speedPx);
      sum += weight * static_cast<double>(sample.difference.l);
      weights += weight;
      squares += weight * weight;
    }
    const double pixels = weights * weights / squares;
    means.push_back(sum / weights * pixels / (pixels + 25.0));
  }
  for (int edge = -200; edge < kDeepest + 200; edge += 7) {
    const double at = inSteps(edge);
    const auto outer = static_cast<std::size_t>(std::min(at, kLast - 1.0));
    const double expected =
        means[outer] + (at - static_cast<double>(outer)) * (means[outer + 1] - means[outer]);
    ASSERT_NEAR(drift.at(edge).l, expected, 0.02) << edge;
  }
}

TEST(ColorDrift, DoesNotDependOnTheOrderOrOnWhoAddedWhat) {
  std::vector<Sample> all = samples(999);
  const ColorDrift drift(sumsOf(all));
  std::reverse(all.begin(), all.end());
  DriftSums sums = sumsOf({all.begin(), all.begin() + 300});
  sums.add(sumsOf({all.begin() + 300, all.end()}));
  const ColorDrift joined(sums);
  for (int edge = 0; edge <= kDeepest; edge += 31) {
    ASSERT_EQ(joined.at(edge).l, drift.at(edge).l);
    ASSERT_EQ(joined.at(edge).a, drift.at(edge).a);
    ASSERT_EQ(joined.at(edge).b, drift.at(edge).b);
  }
}

}  // namespace
}  // namespace fluidymation
