#include "fluidymation/guides/accumulation.h"

#include <gtest/gtest.h>

#include <vector>

#include "fluidymation/guides/packed_mask.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

const Size kSize{3, 1};

void expectEqual(const std::vector<Vec2>& expected, const std::vector<Vec2>& actual) {
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(expected[i].x, actual[i].x) << i;
    EXPECT_EQ(expected[i].y, actual[i].y) << i;
  }
}

TEST(Accumulation, ForwardAddsInsideAndRestartsOutside) {
  const PackedMask previousMask(test::maskOf(kSize, [](int x, int) { return x != 1; }));
  const PackedMask mask(test::maskOf(kSize, [](int x, int) { return x > 0; }));
  expectEqual({{3.0F, 2.0F}, {9.0F, -1.0F}},
              accumulateForward(previousMask, {{2.0F, -1.0F}, {5.0F, -5.0F}}, mask,
                                {{3.0F, 2.0F}, {4.0F, 4.0F}}));
}

TEST(Accumulation, BackwardTakesTheNextFlowOrTheLastOneOfWhatLeaves) {
  const PackedMask mask(test::maskOf(kSize, [](int x, int) { return x < 2; }));
  const PackedMask nextMask(test::maskOf(kSize, [](int x, int) { return x != 1; }));
  expectEqual({{13.0F, 2.0F}, {7.0F, 7.0F}},
              accumulateBackward(nextMask, {{10.0F, 0.0F}, {20.0F, 0.0F}},
                                 {{3.0F, 2.0F}, {1.0F, 1.0F}}, mask, {{7.0F, 7.0F}, {7.0F, 7.0F}}));
}

}  // namespace
}  // namespace fluidymation
