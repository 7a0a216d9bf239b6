// acc- given out in order is the one that runs through the whole sequence from its end.

#include "fluidymation/guides/backward_motion.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "fluidymation/core/index.h"
#include "fluidymation/core/random.h"
#include "fluidymation/guides/accumulation.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using MovingFrame = BackwardMotion::MovingFrame;

/// Masks that come and go, with an empty one now and then, and any flow.
std::vector<MovingFrame> anySequence(int frames) {
  std::vector<MovingFrame> sequence;
  for (int i = 0; i < frames; ++i) {
    const auto seed = static_cast<std::uint64_t>(1000 + i);
    const Mask mask = i % 7 == 5 ? Mask(Size{23, 17}) : test::randomMask({23, 17}, seed, 60);
    MovingFrame frame{PackedMask(mask), {}};
    for (std::size_t p = 0; p < frame.mask.count(); ++p) {
      const auto x = static_cast<float>((static_cast<int>(p) * 31 + i * 17) % 13);
      frame.flow.push_back({0.1F * x - 0.5F, 0.3F - 0.07F * x});
    }
    sequence.push_back(std::move(frame));
  }
  return sequence;
}

/// The recursion of §3.5 with everything kept.
std::vector<std::vector<Vec2>> allAtOnce(const std::vector<MovingFrame>& frames) {
  std::vector<std::vector<Vec2>> motion(frames.size());
  motion.back().resize(frames.back().flow.size());
  for (std::size_t i = frames.size() - 1; i-- > 0;) {
    motion[i] = accumulateBackward(frames[i + 1].mask, motion[i + 1], frames[i + 1].flow,
                                   frames[i].mask, frames[i].flow);
  }
  return motion;
}

TEST(BackwardMotion, IsThatOfTheWholeSequenceAtAnyLength) {
  const test::TemporaryFolder folder;
  constexpr int kBlock = BackwardMotion::kStoredEvery;
  for (const int length : {1, 2, kBlock - 1, kBlock, kBlock + 1, 2 * kBlock, 2 * kBlock + 1, 53}) {
    const std::vector<MovingFrame> frames = anySequence(length);
    const std::vector<std::vector<Vec2>> expected = allAtOnce(frames);
    for (const std::size_t memoryBytes :
         {std::size_t{0}, std::numeric_limits<std::size_t>::max()}) {
      SCOPED_TRACE(std::to_string(length) + " frames, " + std::to_string(memoryBytes) + " bytes");
      RecordStore store({memoryBytes, folder.path()});
      const auto frameOf = [&](int i) { return frames[at(i)]; };
      BackwardMotion motion(length, frameOf, store);
      for (int i = 0; i < length; ++i) {
        const std::vector<Vec2> given = motion.next(frameOf);
        ASSERT_EQ(given.size(), expected[at(i)].size());
        for (std::size_t p = 0; p < given.size(); ++p) {
          ASSERT_EQ(given[p].x, expected[at(i)][p].x) << "frame " << i;
          ASSERT_EQ(given[p].y, expected[at(i)][p].y) << "frame " << i;
        }
      }
    }
  }
}

TEST(BackwardMotion, FramesArePassedOverWithoutAskingForAny) {
  constexpr int kLength = 53;
  const std::vector<MovingFrame> frames = anySequence(kLength);
  const std::vector<std::vector<Vec2>> expected = allAtOnce(frames);
  for (const int first : {0, 1, 5}) {                 // frames that are wanted before
    for (int from = first; from < kLength; ++from) {  // those up to here are passed over
      SCOPED_TRACE(std::to_string(first) + " to " + std::to_string(from));
      RecordStore store({});
      int earliest = 0;
      const auto frameOf = [&](int i) {
        EXPECT_GE(i, earliest);
        return frames[at(i)];
      };
      BackwardMotion motion(kLength, frameOf, store);
      for (int i = 0; i < first; ++i) (void)motion.next(frameOf);
      for (int i = first; i < from; ++i) motion.skip();
      for (int i = from; i < kLength; ++i) {
        earliest = i;
        const std::vector<Vec2> given = motion.next(frameOf);
        ASSERT_EQ(given.size(), expected[at(i)].size());
        for (std::size_t p = 0; p < given.size(); ++p) {
          ASSERT_EQ(given[p].x, expected[at(i)][p].x) << "frame " << i;
          ASSERT_EQ(given[p].y, expected[at(i)][p].y) << "frame " << i;
        }
      }
    }
  }
}

TEST(BackwardMotion, AsksForNoFrameThatIsGone) {
  const std::vector<MovingFrame> frames = anySequence(30);
  int next = 0;
  int lastAsked = 0;
  const auto frameOf = [&](int i) {
    EXPECT_GE(i, next);
    lastAsked = std::max(lastAsked, i);
    return frames[at(i)];
  };
  RecordStore store({});
  BackwardMotion motion(30, frameOf, store);
  for (; next < 30; ++next) {
    lastAsked = next;
    (void)motion.next(frameOf);
    EXPECT_LE(lastAsked, next + BackwardMotion::kStoredEvery);
  }
}

}  // namespace
}  // namespace fluidymation
