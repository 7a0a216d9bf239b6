#include "inspect/time_estimate.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

TEST(TimeEstimate, IsProportionalToPixelsAndSharedByThreads) {
  const SynthesisOptions standard;
  const TimeEstimate one = estimateTime(1'000'000, 20, standard, 1);
  EXPECT_DOUBLE_EQ(one.leastSeconds, kLeastMicroseconds);
  EXPECT_DOUBLE_EQ(one.mostSeconds, kMostMicroseconds);
  EXPECT_DOUBLE_EQ(estimateTime(3'000'000, 20, standard, 1).mostSeconds, 3.0 * one.mostSeconds);
  EXPECT_DOUBLE_EQ(estimateTime(1'000'000, 20, standard, 2).mostSeconds, one.mostSeconds / 1.7);
}

TEST(TimeEstimate, GrowsWithTheExemplarAsMeasured) {
  const SynthesisOptions standard;
  const auto grown = [&](int frames) {
    return estimateTime(1'000'000, frames, standard, 1).mostSeconds /
           estimateTime(1'000'000, 20, standard, 1).mostSeconds;
  };
  EXPECT_NEAR(grown(50), 0.98 / 0.84, 0.1);  // docs/performance.md
  EXPECT_NEAR(grown(100), 1.16 / 0.84, 0.1);
  EXPECT_NEAR(grown(200), 1.46 / 0.84, 0.1);
}

TEST(TimeEstimate, SlowLooksTakeTwiceTheTime) {
  SynthesisOptions slow;
  slow.temporalCoherence = TemporalCoherence::kBidirectional;
  EXPECT_DOUBLE_EQ(estimateTime(1'000'000, 20, slow, 1).leastSeconds, 2.0 * kLeastMicroseconds);
  slow.finestLevel = FinestLevel::kSearched;
  EXPECT_DOUBLE_EQ(estimateTime(1'000'000, 20, slow, 1).leastSeconds, 4.0 * kLeastMicroseconds);
}

}  // namespace
}  // namespace fluidymation
