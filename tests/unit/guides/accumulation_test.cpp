#include "fluidymation/guides/accumulation.h"

#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

const Size kSize{3, 1};

TEST(Accumulation, ForwardAddsInsideAndRestartsOutside) {
  const Mask mask = test::maskOf(kSize, [](int x, int) { return x < 2; });
  Image<Vec2> expected(kSize, Vec2{5.0F, 1.0F});
  expected(2, 0) = Vec2{};
  EXPECT_TRUE(test::nearEverywhere(
      expected,
      accumulateForward(Image<Vec2>(kSize, {2.0F, -1.0F}), Image<Vec2>(kSize, {3.0F, 2.0F}), mask),
      0.0F));
}

TEST(Accumulation, BackwardTakesTheNextFlowOrTheLastOneOfWhatLeaves) {
  const Mask mask = test::maskOf(kSize, [](int x, int) { return x < 2; });
  const Mask nextMask = test::maskOf(kSize, [](int x, int) { return x != 1; });
  Image<Vec2> next(kSize, Vec2{10.0F, 0.0F});
  next(1, 0) = Vec2{};  // outside the next mask nothing has accumulated
  Image<Vec2> expected(kSize);
  expected(0, 0) = {13.0F, 2.0F};
  expected(1, 0) = {7.0F, 7.0F};
  EXPECT_TRUE(
      test::nearEverywhere(expected,
                           accumulateBackward(next, Image<Vec2>(kSize, {3.0F, 2.0F}), nextMask,
                                              Image<Vec2>(kSize, {7.0F, 7.0F}), mask),
                           0.0F));
}

}  // namespace
}  // namespace fluidymation
