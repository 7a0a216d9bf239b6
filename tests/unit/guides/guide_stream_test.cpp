#include "fluidymation/guides/guide_stream.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "fluidymation/guides/direction.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/guides/stored_shapes.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

const Size kSize{90, 80};
const Vec2 kCentre{44.3F, 40.2F};

std::vector<Mask> growingDisc(int frames, float firstRadius, float speed) {
  std::vector<Mask> masks;
  for (int i = 0; i < frames; ++i) {
    masks.push_back(test::disc(kSize, kCentre, firstRadius + speed * static_cast<float>(i)));
  }
  return masks;
}

float largestLength(const Image<Vec2>& field) {
  float largest = 0.0F;
  for (const Vec2 v : field) largest = std::max(largest, length(v));
  return largest;
}

bool finite(const Image<Vec2>& field) {
  return std::all_of(field.begin(), field.end(),
                     [](Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); });
}

/// What holds for every frame of every sequence.
void expectSound(const GuideFrame& frame, const Mask& mask) {
  EXPECT_TRUE(test::equalEverywhere(mask, frame.mask));
  EXPECT_TRUE(frame.diffusion.converged);
  for (const Image<Vec2>* field :
       {&frame.flow, &frame.direction, &frame.accForward, &frame.accBackward}) {
    ASSERT_EQ(field->size(), mask.size());
    EXPECT_TRUE(finite(*field));
  }
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) != 0) {
        ASSERT_NEAR(length(frame.direction(x, y)), 1.0F, 1e-5F);
        ASSERT_GT(frame.distance(x, y), 0.0F);
      } else {
        ASSERT_EQ(length(frame.flow(x, y)) + length(frame.direction(x, y)) +
                      length(frame.accForward(x, y)) + length(frame.accBackward(x, y)),
                  0.0F);
        ASSERT_LT(frame.distance(x, y), 0.0F);
      }
    }
  }
}

TEST(GuideStream, IsSoundForAnyLengthSizeAndKindOfMask) {
  for (int frames = 1; frames <= 8; ++frames) {
    for (const float sigma : {0.0F, 2.0F}) {
      for (const Size size : {Size{1, 1}, Size{3, 3}, Size{2, 9}, Size{31, 27}}) {
        std::vector<Mask> masks;
        for (int i = 0; i < frames; ++i) {
          const auto seed = static_cast<std::uint64_t>(10 * frames + i);
          // Blobs that touch the edges, dust, and now and then nothing or everything
          masks.push_back(i % 5 == 3   ? Mask(size, static_cast<std::uint8_t>(frames % 2))
                          : i % 2 == 0 ? test::randomBlobs(size, seed)
                                       : test::randomMask(size, seed, 50));
        }
        const std::vector<GuideFrame> guides = test::guidesOf(masks, sigma);
        ASSERT_EQ(guides.size(), masks.size());
        for (std::size_t i = 0; i < masks.size(); ++i) expectSound(guides[i], masks[i]);
      }
    }
  }
}

TEST(GuideStream, SmoothsTheMasksItReads) {
  const Mask mask = test::disc(kSize, kCentre, 20.0F);
  GuideOptions options;
  options.mask = {3.0F, 0.3F};
  std::vector<int> asked;
  GuideStream stream(
      3,
      [&](int i) {
        asked.push_back(i);
        return mask.clone();
      },
      options);
  for (int i = 0; i < 3; ++i) expectSound(stream.next(), smoothMask(mask, options.mask));
  EXPECT_EQ(asked, (std::vector<int>{0, 1, 2}));  // once each, in order
}

TEST(GuideStream, OneFrameDoesNotMove) {
  const std::vector<GuideFrame> frames = test::guidesOf(growingDisc(1, 20.0F, 0.0F), 2.0F);
  EXPECT_EQ(largestLength(frames[0].flow), 0.0F);
  EXPECT_EQ(largestLength(frames[0].accForward), 0.0F);
  EXPECT_EQ(largestLength(frames[0].accBackward), 0.0F);
}

TEST(GuideStream, ReportsTheWorseOfTheSolvesForFlowAndDirection) {
  // One frame has no flow to solve for, but its direction is that of the spread normals
  const std::vector<GuideFrame> still = test::guidesOf(growingDisc(1, 20.0F, 0.0F), 2.0F);
  EXPECT_GT(still[0].diffusion.cycles, 0);
}

TEST(GuideStream, ExtentsCountFromTheFirstFrameAndToTheLast) {
  const std::vector<GuideFrame> frames = test::guidesOf(growingDisc(12, 15.0F, 1.0F), 2.0F);
  EXPECT_EQ(largestLength(frames.front().accForward), 0.0F);
  EXPECT_EQ(largestLength(frames.back().accBackward), 0.0F);
  // The pixel at the first frame's edge sees the front pass: at the edge 1 px per frame, later a
  // part of it, as far as the pixel lies inside
  const float there = length(frames[11].accForward(44 + 13, 40));
  double expected = 0.0;
  for (int i = 1; i < 12; ++i) expected += 13.0 / (14.5 + i);
  EXPECT_NEAR(there, expected, 0.1 * expected);
  EXPECT_GT(frames[11].accForward(44 + 13, 40).x, 0.0F);
  EXPECT_LT(frames[11].accForward(44 - 13, 40).x, 0.0F);
  EXPECT_NEAR(length(frames[0].accBackward(44 + 13, 40)), there, 0.01F * there);
}

TEST(GuideStream, ThereAndBackAddsUpToAboutNothing) {
  std::vector<Mask> masks = growingDisc(10, 15.0F, 1.0F);
  for (int i = 8; i >= 0; --i) {
    masks.push_back(test::disc(kSize, kCentre, 15.0F + static_cast<float>(i)));
  }
  const std::vector<GuideFrame> frames = test::guidesOf(masks, 2.0F);
  const float halfWay = largestLength(frames[9].accForward);
  EXPECT_GT(halfWay, 4.0F);
  // Growing is seen on the larger disc, shrinking on the smaller: at one pixel the two differ a bit
  EXPECT_LT(largestLength(frames[18].accForward), 0.1F * halfWay);
}

TEST(GuideStream, AccumulationRestartsWhereTheMaskHadLeft) {
  std::vector<Mask> masks = growingDisc(8, 15.0F, 1.0F);
  masks.push_back(test::disc(kSize, {75.0F, 40.0F}, 5.0F));  // elsewhere for one frame
  const std::vector<Mask> again = growingDisc(4, 22.0F, 0.0F);
  for (const Mask& mask : again) masks.push_back(mask.clone());
  const std::vector<GuideFrame> frames = test::guidesOf(masks, 0.0F);
  const float before = length(frames[7].accForward(44 + 13, 40));
  EXPECT_GT(before, 3.0F);
  for (const std::size_t i : {9U, 10U, 11U, 12U}) {
    // Only what the frame of the return adds
    EXPECT_NEAR(length(frames[i].accForward(44 + 13, 40) - frames[9].flow(44 + 13, 40)), 0.0F,
                1e-4F);
  }
}

/// Root mean square over pixels inside both masks of a + sign * b, relative to that of a.
double relativeDifference(const Image<Vec2>& a, const Image<Vec2>& b, float sign, const Mask& maskA,
                          const Mask& maskB) {
  double difference = 0.0;
  double size = 0.0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (maskA(x, y) == 0 || maskB(x, y) == 0) continue;
      const Vec2 rest = a(x, y) + sign * b(x, y);
      difference += static_cast<double>(dot(rest, rest));
      size += static_cast<double>(dot(a(x, y), a(x, y)));
    }
  }
  return std::sqrt(difference / size);
}

TEST(GuideStream, ReversingTimeExchangesTheExtentsAndNegatesTheFlow) {
  // A disc that grows by 0.5 px per frame and drifts by 0.3. The flow from frame i-1 to i lives on
  // mask i, that of the reversed sequence on mask i-1: they are compared on the pixels both share,
  // by root mean squares. They cannot be equal: a pixel is nearer to the smaller disc's edge.
  constexpr std::size_t kFrames = 14;
  std::vector<Mask> masks;
  std::vector<Mask> reversed;
  for (std::size_t i = 0; i < kFrames; ++i) {
    const auto t = static_cast<float>(i);
    masks.push_back(test::disc(kSize, {42.0F + 0.3F * t, 40.0F}, 28.0F + 0.5F * t));
  }
  for (std::size_t i = kFrames; i-- > 0;) reversed.push_back(masks[i].clone());
  const std::vector<GuideFrame> there = test::guidesOf(masks, 2.0F);
  const std::vector<GuideFrame> back = test::guidesOf(reversed, 2.0F);
  for (std::size_t i = 1; i < kFrames; ++i) {
    const GuideFrame& before = back[kFrames - i];  // frame i - 1 of the sequence
    const double flow =
        relativeDifference(there[i].flow, before.flow, 1.0F, there[i].mask, before.mask);
    EXPECT_LT(flow, 0.05) << i;
  }
  for (std::size_t i = 2; i + 2 < kFrames; ++i) {
    const GuideFrame& same = back[kFrames - 1 - i];
    const double forward =
        relativeDifference(there[i].accForward, same.accBackward, 1.0F, same.mask, same.mask);
    const double backward =
        relativeDifference(there[i].accBackward, same.accForward, 1.0F, same.mask, same.mask);
    EXPECT_LT(forward, 0.05) << i;
    EXPECT_LT(backward, 0.05) << i;
  }
}

TEST(GuideStream, WhatAppearsAtOnceMovesNoFurtherThanItIsThick) {
  for (const float sigma : {0.0F, 2.0F}) {
    std::vector<Mask> masks;
    for (int i = 0; i < 20; ++i) {
      masks.push_back(test::maskOf(kSize, [&](int x, int y) {
        const bool old = x < 12 && y < 12;
        const bool fresh = i >= 8 && x >= 60 && x < 69 && y >= 50 && y < 59;  // 4.5 px thick
        return old || fresh;
      }));
    }
    for (const GuideFrame& frame : test::guidesOf(masks, sigma)) {
      EXPECT_LE(largestLength(frame.flow), 4.6F);
      EXPECT_LE(largestLength(frame.accForward), 5.0F);
      EXPECT_LE(largestLength(frame.accBackward), 5.0F);
    }
  }
}

TEST(GuideStream, FramesWithoutAnEdgeDoNotLeakTheirStandInDistances) {
  for (const bool full : {false, true}) {
    std::vector<Mask> masks;
    for (int i = 0; i < 12; ++i) {
      if (i == 0 || i == 6 || i == 11) {
        masks.emplace_back(kSize, full ? 1 : 0);
      } else {
        masks.push_back(test::disc(kSize, kCentre, 9.0F + 0.2F * static_cast<float>(i)));
      }
    }
    const std::vector<GuideFrame> frames = test::guidesOf(masks, 2.0F);
    for (const GuideFrame& frame : frames) {
      EXPECT_LT(largestLength(frame.flow), 0.5F);
      EXPECT_LT(largestLength(frame.accForward), 3.0F);
      EXPECT_LT(largestLength(frame.accBackward), 3.0F);
    }
    EXPECT_GT(largestLength(frames[1].flow), 0.1F);  // the first of a run moves as to the second
    EXPECT_GT(largestLength(frames[7].flow), 0.1F);
    EXPECT_GT(largestLength(frames[10].flow), 0.1F);
  }
}

TEST(GuideStream, FlowIsAveragedOverTheFramesThatHoldThePixel) {
  std::vector<Mask> masks;
  for (int i = 0; i < 9; ++i) masks.push_back(test::randomBlobs({40, 30}, 7));
  for (int i = 0; i < 9; ++i) {
    const Mask moving = test::disc({40, 30}, {8.0F + 3.0F * static_cast<float>(i), 15.0F}, 6.0F);
    for (std::size_t p = 0; p < moving.pixelCount(); ++p) {
      masks[static_cast<std::size_t>(i)].data()[p] |= moving.data()[p];
    }
  }
  masks[7] = Mask(Size{40, 30});  // ends the window on both sides
  GuideOptions options;
  options.mask.blurSigmaPx = 0.0F;
  options.timeBlurSigmaFrames = 0.0F;
  const std::vector<GuideFrame> plain = test::guidesWith(masks, options);
  options.flowBlurSigmaFrames = 1.5F;
  const std::vector<GuideFrame> averaged = test::guidesWith(masks, options);
  bool differs = false;
  for (int i = 0; i < 7; ++i) {
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        double weights = 0.0;
        double sumX = 0.0;
        double sumY = 0.0;
        for (int j = std::max(i - 3, 0); j <= std::min(i + 3, 6); ++j) {
          const GuideFrame& frame = plain[static_cast<std::size_t>(j)];
          if (frame.mask(x, y) == 0) continue;
          const double weight = std::exp(-0.5 * (j - i) * (j - i) / (1.5 * 1.5));
          weights += weight;
          sumX += weight * static_cast<double>(frame.flow(x, y).x);
          sumY += weight * static_cast<double>(frame.flow(x, y).y);
        }
        const GuideFrame& frame = averaged[static_cast<std::size_t>(i)];
        const bool inside = frame.mask(x, y) != 0;
        ASSERT_NEAR(frame.flow(x, y).x, inside ? sumX / weights : 0.0, 1e-4) << i << x << ' ' << y;
        ASSERT_NEAR(frame.flow(x, y).y, inside ? sumY / weights : 0.0, 1e-4) << i << x << ' ' << y;
        const Vec2 change = frame.flow(x, y) - plain[static_cast<std::size_t>(i)].flow(x, y);
        differs = differs || length(change) > 0.1F;
      }
    }
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(largestLength(averaged[8].flow), 0.0F);  // alone: the empty frame is no neighbour
}

TEST(GuideStream, AGivenFlowIsTakenAsItIsInsideTheMasks) {
  const std::vector<Mask> masks = growingDisc(5, 15.0F, 1.0F);
  GuideOptions options;
  options.mask.blurSigmaPx = 0.0F;
  options.flowBlurSigmaFrames = 1.5F;
  std::vector<int> asked;
  GuideStream stream(
      5, [&](int i) { return masks[static_cast<std::size_t>(i)].clone(); }, options,
      [&](int i, const Mask& previousMask) {
        asked.push_back(i);
        EXPECT_TRUE(test::equalEverywhere(
            i == 0 ? Mask(kSize) : masks[static_cast<std::size_t>(i - 1)].clone(), previousMask));
        return Image<Vec2>(kSize, Vec2{static_cast<float>(i), -2.0F});
      });
  EXPECT_EQ(asked, (std::vector<int>{0, 1, 2, 3, 4}));
  for (int i = 0; i < 5; ++i) {
    const GuideFrame frame = stream.next();
    expectSound(frame, masks[static_cast<std::size_t>(i)]);
    EXPECT_EQ(frame.flow(44, 40).x, static_cast<float>(i));
    EXPECT_EQ(frame.flow(44, 40).y, -2.0F);
    // 1 + 2 + ... so far, and what is still to come
    EXPECT_FLOAT_EQ(frame.accForward(44, 40).x, static_cast<float>(i * (i + 1)) / 2.0F);
    EXPECT_FLOAT_EQ(frame.accBackward(44, 40).x, 10.0F - static_cast<float>(i * (i + 1)) / 2.0F);
  }
}

TEST(GuideStream, TheBlurredMaskComesWhereItIsAskedFor) {
  const std::vector<Mask> masks = growingDisc(2, 15.0F, 1.0F);
  GuideOptions options;
  options.mask.blurSigmaPx = 0.0F;
  for (const GuideFrame& frame : test::guidesWith(masks, options)) EXPECT_TRUE(frame.shape.empty());
  options.shapeBlurRadiusPx = 9.0F;
  const std::vector<GuideFrame> frames = test::guidesWith(masks, options);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(test::nearEverywhere(blurredMask(masks[i], 9.0F), frames[i].shape, 0.0F));
  }
}

/// A disc that moves, rests, moves again and rests: coverage of each frame.
std::vector<Image<float>> restingDisc(bool soft) {
  std::vector<Image<float>> frames;
  float x = 20.0F;
  for (int i = 0; i < 24; ++i) {
    const bool moves = i < 4 || (i >= 12 && i < 15);
    if (moves) x += 1.3F;
    const Image<float> disc = test::softDisc({60, 44}, {x, 21.0F}, 12.4F);
    frames.push_back(soft ? test::eightBit(disc)
                          : InputMask(InputMask(disc.clone(), true).cut()).coverage);
  }
  return frames;
}

TEST(GuideStream, AHoldHasTheGuidesThatComputingThemAnewGives) {
  for (const bool soft : {false, true}) {
    SCOPED_TRACE(soft ? "soft" : "hard");
    const std::vector<Image<float>> frames = restingDisc(soft);
    const auto frameCount = static_cast<int>(frames.size());
    GuideOptions options;
    options.mask.blurSigmaPx = 1.0F;
    options.timeBlurSigmaFrames = 0.5F;
    options.shapeBlurRadiusPx = 6.0F;
    const auto input = [&](int i) {
      return InputMask(frames[static_cast<std::size_t>(i)].clone(), soft);
    };
    GuideStream stream(frameCount, input, options);
    GuideFrame before;
    int still = 0;
    for (int i = 0; i < frameCount; ++i) {
      SCOPED_TRACE(i);
      GuideFrame frame = stream.next();
      GuideFrame anew;
      RecordStore store({});
      const StoredShapes alone(
          1, [&](int) { return input(i); }, options.mask, store);
      alone.shape(0).addTo(anew);
      EXPECT_TRUE(test::equalEverywhere(anew.mask, frame.mask));
      EXPECT_TRUE(test::nearEverywhere(anew.distance, frame.distance, 0.0F));
      EXPECT_TRUE(test::nearEverywhere(anew.coverage, frame.coverage, 0.0F));
      EXPECT_TRUE(test::nearEverywhere(blurredMask(anew.mask, *options.shapeBlurRadiusPx),
                                       frame.shape, 0.0F));
      const DirectionField direction =
          flowDirection(anew.mask, frame.flow, anew.distance, before.direction.clone());
      EXPECT_TRUE(test::nearEverywhere(direction.direction, frame.direction, 0.0F));
      if (largestLength(frame.flow) == 0.0F) {
        ++still;
        EXPECT_TRUE(test::nearEverywhere(before.accForward, frame.accForward, 0.0F));
        EXPECT_TRUE(test::nearEverywhere(before.accBackward, frame.accBackward, 0.0F));
      }
      before = std::move(frame);
    }
    EXPECT_GE(still, 8);
  }
}

TEST(GuideStream, TheNumberOfThreadsDoesNotShow) {
  std::vector<Mask> masks;
  for (int i = 0; i < 3; ++i) {
    masks.push_back(test::disc({240, 230}, {120.0F, 110.0F + static_cast<float>(i)}, 95.0F));
  }
  GuideOptions options;
  options.mask.blurSigmaPx = 3.0F;
  options.flowBlurSigmaFrames = 1.0F;
  options.shapeBlurRadiusPx = 20.0F;
  const int threadsBefore = omp_get_max_threads();
  std::vector<std::vector<GuideFrame>> results;
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    results.push_back(test::guidesWith(masks, options));
  }
  omp_set_num_threads(threadsBefore);
  const auto sameBytes = [](const auto& a, const auto& b) {
    return std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(*a.data())) == 0;
  };
  for (const std::size_t other : {1U, 2U}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const GuideFrame& a = results[0][i];
      const GuideFrame& b = results[other][i];
      EXPECT_TRUE(sameBytes(a.mask, b.mask));
      EXPECT_TRUE(sameBytes(a.distance, b.distance));
      EXPECT_TRUE(sameBytes(a.shape, b.shape));
      EXPECT_TRUE(sameBytes(a.flow, b.flow));
      EXPECT_TRUE(sameBytes(a.direction, b.direction));
      EXPECT_TRUE(sameBytes(a.accForward, b.accForward));
      EXPECT_TRUE(sameBytes(a.accBackward, b.accBackward));
    }
  }
}

}  // namespace
}  // namespace fluidymation
