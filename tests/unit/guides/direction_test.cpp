#include "fluidymation/guides/direction.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/core/index.h"
#include "fluidymation/guides/distance_field.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

const Size kSize{50, 44};
const Vec2 kCentre{24.6F, 21.3F};

TEST(Direction, MovingPixelsPointAlongTheirFlow) {
  const Mask mask = test::disc(kSize, kCentre, 15.0F);
  const Image<Vec2> direction =
      flowDirection(mask, Image<Vec2>(kSize, {0.3F, -0.4F}), signedDistance(mask),
                    Image<Vec2>(kSize, {1.0F, 0.0F}))
          .direction;
  EXPECT_NEAR(direction(20, 20).x, 0.6F, 1e-6F);
  EXPECT_NEAR(direction(20, 20).y, -0.8F, 1e-6F);
  EXPECT_EQ(length(direction(0, 0)), 0.0F);
}

TEST(Direction, StillPixelsKeepTheirLastOne) {
  const Mask mask = test::disc(kSize, kCentre, 15.0F);
  const Vec2 slow{0.0F, 0.9F * kStillPxPerFrame};
  const Image<Vec2> direction = flowDirection(mask, Image<Vec2>(kSize, slow), signedDistance(mask),
                                              Image<Vec2>(kSize, {-0.6F, 0.8F}))
                                    .direction;
  EXPECT_EQ(direction(24, 21).x, -0.6F);
  EXPECT_EQ(direction(24, 21).y, 0.8F);
}

TEST(Direction, AStillMaskWithoutAPastPointsOutwards) {
  const Mask mask = test::disc(kSize, kCentre, 15.0F);
  const Image<Vec2> direction =
      flowDirection(mask, Image<Vec2>(kSize), signedDistance(mask), Image<Vec2>()).direction;
  float meanCosine = 0.0F;
  float count = 0.0F;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (mask(x, y) == 0) continue;
      EXPECT_NEAR(length(direction(x, y)), 1.0F, 1e-5F);
      const Vec2 arm = Vec2{static_cast<float>(x), static_cast<float>(y)} - kCentre;
      if (length(arm) < 3.0F) continue;  // in the middle all directions meet
      EXPECT_GT(dot(direction(x, y), arm), 0.97F * length(arm)) << x << ", " << y;
      meanCosine += dot(direction(x, y), arm) / length(arm);
      count += 1.0F;
    }
  }
  EXPECT_GT(meanCosine / count, 0.99F);
}

TEST(Direction, ReportsHowTheNormalsWereSpread) {
  const Mask mask = test::disc(kSize, kCentre, 15.0F);
  const Image<float> distance = signedDistance(mask);
  const Image<Vec2> moving(kSize, {1.0F, 0.0F});
  EXPECT_EQ(flowDirection(mask, moving, distance, Image<Vec2>()).report.cycles, 0);
  EXPECT_GT(flowDirection(mask, Image<Vec2>(kSize), distance, Image<Vec2>()).report.cycles, 0);
}

TEST(Direction, HasUnitLengthEverywhereInsideWhateverTheMask) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    for (const Mask& mask : {test::randomBlobs(kSize, seed), test::randomMask(kSize, seed, 60),
                             Mask(kSize, 1), Mask(Size{1, 1}, 1), Mask(Size{3, 3})}) {
      // A past that knows half of the pixels, and a flow that a tenth of them have
      Image<Vec2> previous(mask.size());
      Image<Vec2> flow(mask.size());
      const Mask moving = test::randomMask(mask.size(), 50 + seed, 10);
      for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
          if (x % 2 == 0) previous(x, y) = {0.0F, 1.0F};
          if (moving(x, y) != 0) flow(x, y) = {30.0F, 0.02F};
        }
      }
      const Image<Vec2> direction =
          flowDirection(mask, flow, signedDistance(mask), previous.clone()).direction;
      for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
          ASSERT_NEAR(length(direction(x, y)), mask(x, y) != 0 ? 1.0F : 0.0F, 1e-5F);
        }
      }
    }
  }
}

/// Masks that come and go, where some pixels move in a frame and most do not.
std::vector<MovingShape> hesitatingSequence(int frames) {
  std::vector<MovingShape> sequence;
  for (int i = 0; i < frames; ++i) {
    const auto seed = static_cast<std::uint64_t>(200 + i);
    MovingShape frame{i % 9 == 7 ? Mask(kSize) : test::randomBlobs(kSize, seed / 3), {}};
    frame.flow = Image<Vec2>(kSize);
    const Mask moving = test::randomMask(kSize, seed, 20);
    for (std::size_t p = 0; p < frame.mask.pixelCount(); ++p) {
      if (frame.mask.data()[p] == 0 || moving.data()[p] == 0) continue;
      frame.flow.data()[p] = {0.1F * static_cast<float>(i + 1), -0.3F};
    }
    sequence.push_back(std::move(frame));
  }
  return sequence;
}

TEST(Direction, OfTheLastFrameOfManyIsThatOfGoingThroughThemAll) {
  constexpr int kFrames = 24;
  const std::vector<MovingShape> frames = hesitatingSequence(kFrames);
  std::vector<Image<Vec2>> oneByOne;
  for (const MovingShape& frame : frames) {
    const Image<Vec2> before = oneByOne.empty() ? Image<Vec2>() : oneByOne.back().clone();
    oneByOne.push_back(
        flowDirection(frame.mask, frame.flow, signedDistance(frame.mask), before.clone())
            .direction);
  }
  for (int begin = 0; begin < kFrames; ++begin) {
    for (int end = begin + 1; end <= kFrames; ++end) {
      SCOPED_TRACE(std::to_string(begin) + " to " + std::to_string(end));
      int lastAsked = end;
      const Image<Vec2> last = directionOfLast(
          begin, end,
          [&](int i) {
            EXPECT_EQ(i, --lastAsked);
            return MovingShape{frames[at(i)].mask.clone(), frames[at(i)].flow.clone()};
          },
          [&](int i) { return signedDistance(frames[at(i)].mask); },
          begin == 0 ? Image<Vec2>() : oneByOne[at(begin - 1)].clone());
      EXPECT_GE(lastAsked, begin);
      ASSERT_TRUE(test::nearEverywhere(oneByOne[at(end - 1)], last, 0.0F));
    }
  }
}

TEST(Direction, OfTheLastFrameOfManySpreadsNormalsOnlyWherePixelsStillHaveThem) {
  const Mask mask = test::disc(kSize, kCentre, 15.0F);
  std::vector<int> spread;
  const auto directionWith = [&](int movingFrame) {
    spread.clear();
    return directionOfLast(
        0, 6,
        [&](int i) {
          const Vec2 flow = i == movingFrame ? Vec2{0.0F, 1.0F} : Vec2{};
          return MovingShape{mask.clone(), Image<Vec2>(kSize, flow)};
        },
        [&](int i) {
          spread.push_back(i);
          return signedDistance(mask);
        },
        Image<Vec2>());
  };
  EXPECT_EQ(directionWith(2)(20, 20).y, 1.0F);
  EXPECT_TRUE(spread.empty());
  (void)directionWith(-1);
  EXPECT_EQ(spread, std::vector<int>{0});
}

}  // namespace
}  // namespace fluidymation
