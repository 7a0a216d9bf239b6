#include "pipeline/sampled_frames.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace fluidymation {
namespace {

TEST(SampledFrames, AreAllOfAShortSequence) {
  EXPECT_TRUE(sampledFrames(0).empty());
  EXPECT_EQ(sampledFrames(3), (std::vector<int>{0, 1, 2}));
  const std::vector<int> all = sampledFrames(kMostSampledFrames);
  EXPECT_EQ(all.front(), 0);
  EXPECT_EQ(all.back(), kMostSampledFrames - 1);
}

TEST(SampledFrames, AreSpreadEvenlyOverALongOne) {
  for (const int count : {25, 48, 1001, std::numeric_limits<int>::max()}) {
    SCOPED_TRACE(count);
    const std::vector<int> frames = sampledFrames(count);
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(kMostSampledFrames));
    EXPECT_EQ(frames.front(), 0);
    for (std::size_t i = 1; i < frames.size(); ++i) {
      EXPECT_GE(frames[i] - frames[i - 1], count / kMostSampledFrames);
      EXPECT_LE(frames[i] - frames[i - 1], count / kMostSampledFrames + 1);
    }
    EXPECT_GE(count - frames.back(), count / kMostSampledFrames);
    EXPECT_LE(count - frames.back(), count / kMostSampledFrames + 1);
  }
}

}  // namespace
}  // namespace fluidymation
