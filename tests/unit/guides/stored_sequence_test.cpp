// Where the frames of a sequence wait changes no byte of their guides.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "fluidymation/core/index.h"
#include "fluidymation/guides/guide_stream.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

const Size kSize{60, 50};

template <typename Value>
bool sameBytes(const Image<Value>& a, const Image<Value>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Value)) == 0);
}

bool sameGuides(const GuideFrame& a, const GuideFrame& b) {
  return sameBytes(a.mask, b.mask) && sameBytes(a.distance, b.distance) &&
         sameBytes(a.flow, b.flow) && sameBytes(a.direction, b.direction) &&
         sameBytes(a.accForward, b.accForward) && sameBytes(a.accBackward, b.accBackward) &&
         sameBytes(a.shape, b.shape) && sameBytes(a.coverage, b.coverage);
}

/// A disc that travels and grows at such a speed, holds still for three frames, and is gone for
/// one.
InputMask frameOf(int i, float speed, bool soft) {
  if (i == 10) return {Mask(kSize)};
  const auto step = static_cast<float>(i > 6 ? std::max(6, i - 3) : i);
  const Vec2 centre{15.0F + speed * step, 24.0F};
  const float radius = 8.0F + 0.3F * speed * step;
  if (soft) return {test::softDisc(kSize, centre, radius), true};
  return {test::disc(kSize, centre, radius)};
}

struct Case {
  const char* name;
  int frames;
  float speed;
  float timeBlurSigma;
  float flowBlurSigma;
  bool soft;
};

GuideOptions optionsOf(const Case& tested) {
  GuideOptions options;
  options.mask = {1.0F, 0.4F};
  options.timeBlurSigmaFrames = tested.timeBlurSigma;
  options.flowBlurSigmaFrames = tested.flowBlurSigma;
  options.shapeBlurRadiusPx = 5.0F;
  return options;
}

class StoredSequence : public ::testing::TestWithParam<Case> {};

TEST_P(StoredSequence, HasTheSameGuidesInMemoryAndOnTheDisk) {
  const Case& tested = GetParam();
  const test::TemporaryFolder folder;
  const GuideOptions options = optionsOf(tested);
  const auto readMask = [&](int i) { return frameOf(i, tested.speed, tested.soft); };
  GuideStream inMemory(tested.frames, readMask, options);
  GuideStream onDisk(tested.frames, readMask, options, {}, {{0, folder.path()}, {}, {}});
  GuideStream onBoth(tested.frames, readMask, options, {}, {{20'000, folder.path()}, {}, {}});
  GuideStreamSetting keeping{{20'000, folder.path()}, {}, {}};
  keeping.keeps = true;
  GuideStream kept(tested.frames, readMask, options, {}, keeping);
  for (const int turned : {1, tested.frames / 2, tested.frames}) {  // back to the first one there
    for (int i = 0; i < turned; ++i) (void)kept.next();
    kept.rewind();
  }
  for (int i = 0; i < tested.frames; ++i) {
    const GuideFrame expected = inMemory.next();
    EXPECT_TRUE(sameGuides(expected, onDisk.next())) << "frame " << i;
    EXPECT_TRUE(sameGuides(expected, onBoth.next())) << "frame " << i;
    EXPECT_TRUE(sameGuides(expected, kept.next())) << "frame " << i;
  }
}

TEST_P(StoredSequence, FramesThatArePassedOverChangeNothingAfterThem) {
  const Case& tested = GetParam();
  const test::TemporaryFolder folder;
  const GuideOptions options = optionsOf(tested);
  const auto readMask = [&](int i) { return frameOf(i, tested.speed, tested.soft); };
  for (int first = 0; first < tested.frames; ++first) {
    SCOPED_TRACE("up to frame " + std::to_string(first));
    GuideStream all(tested.frames, readMask, options);
    GuideStream some(tested.frames, readMask, options, {}, {{20'000, folder.path()}, {}, {}});
    const int wanted = std::min(first, first % 4);  // before those that are passed over
    std::vector<Mask> expectedMasks;
    for (int i = 0; i < first; ++i) {
      expectedMasks.push_back(all.next().mask);
      if (i < wanted) (void)some.next();
    }
    int passed = wanted;
    some.skip(first - wanted, {},
              [&](const Mask& mask) { EXPECT_TRUE(sameBytes(expectedMasks[at(passed++)], mask)); });
    EXPECT_EQ(passed, first);
    for (int i = first; i < tested.frames; ++i) {
      const GuideFrame expected = all.next();
      const GuideFrame given = some.next();
      EXPECT_TRUE(sameGuides(expected, given)) << "frame " << i;
      EXPECT_EQ(expected.diffusion.cycles, given.diffusion.cycles);
    }
  }
}

TEST_P(StoredSequence, PartsAfterFramesThatArePassedOverAreThoseOfTheWhole) {
  const Case& tested = GetParam();
  const GuideOptions options = optionsOf(tested);
  const auto readMask = [&](int i) { return frameOf(i, tested.speed, tested.soft); };
  const int first = tested.frames / 2;
  GuideStream all(tested.frames, readMask, options);
  GuideStream parts(tested.frames, readMask, options);
  for (int i = 0; i < first; ++i) (void)all.next();
  parts.skip(first);
  for (int i = first; i < tested.frames; ++i) {
    SCOPED_TRACE("frame " + std::to_string(i));
    const GuideFrame expected = all.next();
    const GuidePart given = parts.nextPart(5);
    const auto shown = [&](const auto& image) { return cropped(image, given.part.box); };
    EXPECT_TRUE(sameBytes(shown(expected.mask), given.guides.mask));
    EXPECT_TRUE(sameBytes(shown(expected.distance), given.guides.distance));
    EXPECT_TRUE(sameBytes(shown(expected.flow), given.guides.flow));
    EXPECT_TRUE(sameBytes(shown(expected.direction), given.guides.direction));
    EXPECT_TRUE(sameBytes(shown(expected.accForward), given.guides.accForward));
    EXPECT_TRUE(sameBytes(shown(expected.accBackward), given.guides.accBackward));
  }
}

TEST_P(StoredSequence, PassingOverAsksBeforeEachFrameAndStopsWhereThatThrows) {
  const Case& tested = GetParam();
  const GuideOptions options = optionsOf(tested);
  const auto readMask = [&](int i) { return frameOf(i, tested.speed, tested.soft); };
  const auto asksUntil = [&](int last) {
    GuideStream stream(tested.frames, readMask, options);
    int asked = 0;
    const auto ask = [&] {
      if (++asked == last) throw std::runtime_error("enough");
    };
    if (last > 0) {
      EXPECT_THROW(stream.skip(tested.frames, ask), std::runtime_error);
    } else {
      stream.skip(tested.frames, ask);
    }
    return asked;
  };
  const int asked = asksUntil(0);
  EXPECT_GT(asked, tested.frames) << "forwards and, for some frames at least, backwards";
  const int forwards = asked - tested.frames + 1;  // the first of the forward pass
  for (const int last : {1, std::max(forwards - 1, 1), forwards, asked}) {
    EXPECT_EQ(asksUntil(last), last);
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, StoredSequence,
                         ::testing::Values(Case{"single", 1, 1.0F, 2.0F, 0.0F, false},
                                           Case{"pair", 2, 1.0F, 2.0F, 0.0F, true},
                                           Case{"block", 8, 0.4F, 2.0F, 0.0F, false},
                                           Case{"slow", 17, 0.1F, 2.0F, 0.0F, true},
                                           Case{"fast", 25, 3.0F, 2.0F, 0.0F, false},
                                           Case{"unsmoothed", 12, 1.0F, 0.0F, 0.0F, true},
                                           Case{"wide", 20, 1.0F, 9.0F, 0.0F, false},
                                           Case{"averaged", 20, 1.0F, 0.0F, 1.5F, true}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(StoredSequenceOf, GivenFlowHasTheSameGuidesToo) {
  const test::TemporaryFolder folder;
  const auto readMask = [](int i) { return frameOf(i, 1.0F, false); };
  const auto readFlow = [](int i, const Mask&) {
    return Image<Vec2>(kSize, Vec2{0.1F * static_cast<float>(i), -0.0F});
  };
  GuideStream inMemory(14, readMask, {}, readFlow);
  GuideStream onDisk(14, readMask, {}, readFlow, {{0, folder.path()}, {}, {}});
  for (int i = 0; i < 14; ++i) EXPECT_TRUE(sameGuides(inMemory.next(), onDisk.next()));
}

}  // namespace
}  // namespace fluidymation
