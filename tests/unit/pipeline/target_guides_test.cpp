// What a run that goes on asks of the guides of frames that are painted already.

#include "pipeline/target_guides.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "fluidymation/core/index.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

/// Notes what is asked of it.
struct NotingSource {
  std::string asked;
  GuideSource source{[this] {
                       asked += 'n';
                       GuidePart frame;
                       frame.guides.diffusion.cycles = static_cast<int>(asked.size());
                       return frame;
                     },
                     [this](int count, const std::function<void()>& beforeEach) {
                       for (int i = 0; i < count; ++i) {
                         beforeEach();
                         asked += 's';
                       }
                     }};
};

TEST(TargetGuides, NoneOfPaintedFramesAreMadeButThoseOfTheLastToGoOnFrom) {
  const auto askedFor = [](int count, bool wantsLast) {
    NotingSource noting;
    const GuidePart last = passOver(count, wantsLast, noting.source, [] {});
    EXPECT_EQ(last.guides.diffusion.cycles, wantsLast ? count : 0);
    return noting.asked;
  };
  EXPECT_EQ(askedFor(0, false), "");
  EXPECT_EQ(askedFor(5, false), "sssss");
  EXPECT_EQ(askedFor(5, true), "ssssn");
  EXPECT_EQ(askedFor(1, true), "n");
}

TEST(TargetGuides, PassingOverStopsWhereTheCallerWantsNoMore) {
  NotingSource noting;
  int left = 3;
  const auto stops = [&left] {
    if (left-- == 0) throw std::runtime_error("enough");
  };
  EXPECT_THROW((void)passOver(9, false, noting.source, stops), std::runtime_error);
  EXPECT_EQ(noting.asked, "sss");
}

TEST(TargetGuides, AgesCountFramesThatArePassedOverInWholeFramesAndParts) {
  const auto readMask = [](int i) {
    const auto step = static_cast<float>(i);
    return test::disc({60, 50}, {30.0F + 0.6F * step, 25.0F}, 8.0F + 1.5F * step);
  };
  constexpr int kFrames = 6;
  GuideStream all(kFrames, readMask, {});
  GuideStream some(kFrames, readMask, {});
  GuideStream others(kFrames, readMask, {});
  constexpr int kMarginPx = 5;
  const GuideSource whole = targetGuides(all, std::nullopt, true);
  const GuideSource passed = targetGuides(some, std::nullopt, true);
  const GuideSource inParts = targetGuides(others, kMarginPx, true);
  for (int i = 0; i < kFrames - 2; ++i) (void)whole.next();
  passed.skip(kFrames - 2, [] {});
  inParts.skip(kFrames - 2, [] {});
  for (int i = kFrames - 2; i < kFrames; ++i) {
    const GuideFrame expected = whole.next().guides;
    EXPECT_EQ(expected.age(30, 25), static_cast<float>(i));
    for (const GuideSource& source : {passed, inParts}) {
      const GuidePart given = source.next();
      EXPECT_TRUE(
          test::nearEverywhere(cropped(expected.age, given.part.box), given.guides.age, 0.0F));
      EXPECT_EQ(expected.ageGrows, given.guides.ageGrows);
    }
  }
}

}  // namespace
}  // namespace fluidymation
