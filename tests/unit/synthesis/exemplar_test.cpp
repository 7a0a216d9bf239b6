// An exemplar that holds a part of a film, and goes on in it.

#include "fluidymation/synthesis/exemplar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderWidthPx = 5.0F;
constexpr int kCoarsest = 2;
constexpr int kHeld = 4;
constexpr std::uint64_t kSeed = 31;

template <typename T>
bool sameBytes(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Whether frame k of `a` reads like frame l of `b` in everything that a search may ask.
::testing::AssertionResult readAlike(const Exemplar& a, int k, const Exemplar& b, int l) {
  for (int i = 0; i < a.levelCount(); ++i) {
    const ExemplarLevel& one = a.level(i);
    const ExemplarLevel& other = b.level(i);
    const auto differs = [&](const char* what, int x, int y) {
      return ::testing::AssertionFailure()
             << what << " of level " << i << " at (" << x << ", " << y << ")";
    };
    constexpr int kMargin = ExemplarLevel::kMarginPx;
    for (int y = -kMargin; y < one.size().height + kMargin; ++y) {
      for (int x = -kMargin; x < one.size().width + kMargin; ++x) {
        if (!sameBytes(one.texel(x, y, k), other.texel(x, y, l))) return differs("texel", x, y);
      }
    }
    for (int y = 0; y < one.size().height; ++y) {
      for (int x = 0; x < one.size().width; ++x) {
        if (one.segment(x, y, k) != other.segment(x, y, l)) return differs("segment", x, y);
        if (!sameBytes(one.direction(x, y, k), other.direction(x, y, l))) {
          return differs("direction", x, y);
        }
        if (one.modulationDistancePx(x, y, k) != other.modulationDistancePx(x, y, l)) {
          return differs("modulation distance", x, y);
        }
      }
    }
  }
  for (const auto& [one, other] : {std::pair{&a.accForward(k), &b.accForward(l)},
                                   std::pair{&a.accBackward(k), &b.accBackward(l)}}) {
    if (one->size() != other->size() || one->pixelCount() == 0) {
      return ::testing::AssertionFailure() << "size of the accumulated motion";
    }
    if (std::memcmp(one->data(), other->data(), one->pixelCount() * sizeof(Vec2)) != 0) {
      return ::testing::AssertionFailure() << "accumulated motion";
    }
  }
  return ::testing::AssertionSuccess();
}

class HeldExemplar : public ::testing::TestWithParam<ShapeRules> {
 protected:
  [[nodiscard]] Exemplar holding(int begin, int held = kHeld) const {
    return test::heldDiscExemplar(disc_, begin, held, kCoarsest, kBorderWidthPx, kSeed, GetParam());
  }

  test::GrowingDisc disc_{Size{47, 40}, {23.0F, 20.0F}, 4.0F, 1.1F, 14};
};

TEST_P(HeldExemplar, ReadsLikeTheWholeFilm) {
  const Exemplar whole = holding(0, disc_.frameCount);
  const Exemplar part = holding(3);
  EXPECT_EQ(part.firstFrame(), 3);
  for (int k = 0; k < kHeld; ++k) EXPECT_TRUE(readAlike(part, k, whole, k + 3)) << "frame " << k;
}

TEST_P(HeldExemplar, IsTheSameHoweverItCameThere) {
  for (const std::vector<int>& steps : {std::vector<int>{1, 1, 1}, {3}, {2, 5}, {4}, {9}, {0, 1}}) {
    Exemplar advanced = holding(0);
    for (const int step : steps) {
      const int heldSoFar = advanced.firstFrame() + kHeld;
      advanced.advance(step);
      const int from = std::max(heldSoFar, advanced.firstFrame());
      for (int k = from; k < advanced.firstFrame() + kHeld; ++k) {
        test::fillFrame(disc_, k, kSeed, advanced);
      }
      advanced.finish();
    }
    const Exemplar expected = holding(advanced.firstFrame());
    for (int k = 0; k < kHeld; ++k) EXPECT_TRUE(readAlike(advanced, k, expected, k)) << k;
    for (int l = 0; l <= kCoarsest; ++l) {
      for (const Segment segment : {Segment::kBorder, Segment::kInterior}) {
        EXPECT_EQ(advanced.level(l).candidates(segment), expected.level(l).candidates(segment));
        EXPECT_EQ(advanced.level(l).pixelsOf(segment), expected.level(l).pixelsOf(segment));
      }
      EXPECT_EQ(advanced.level(l).segmented(), expected.level(l).segmented());
    }
  }
}

TEST_P(HeldExemplar, ScalesExtentsByAllFramesWhicheverItHolds) {
  FilmExtents extents;
  Exemplar whole(disc_.size, disc_.frameCount, kCoarsest, kBorderWidthPx, GetParam());
  for (int k = 0; k < disc_.frameCount; ++k) {
    extents.add(disc_.guides(k));
    test::fillFrame(disc_, k, kSeed, whole);
  }
  whole.finish(ExtentUnit::kExemplar);
  Exemplar part(disc_.size, kHeld, kCoarsest, kBorderWidthPx, GetParam());
  part.setExtentScale(extents.scale(ExtentUnit::kExemplar));
  part.advance(6);
  for (int k = 6; k < 6 + kHeld; ++k) test::fillFrame(disc_, k, kSeed, part);
  part.finish(ExtentUnit::kExemplar);
  EXPECT_EQ(part.extentScale()(10.0F), whole.extentScale()(10.0F));
  for (int k = 0; k < kHeld; ++k) EXPECT_TRUE(readAlike(part, k, whole, k + 6)) << "frame " << k;
}

INSTANTIATE_TEST_SUITE_P(
    Rules, HeldExemplar,
    ::testing::Values(ShapeRules{},
                      ShapeRules{ShapeGuide::kBlurredMask, false, ModulationDistance::kUnclamped}),
    [](const auto& tested) { return tested.param.hardSegments ? "thesis" : "paper"; });

}  // namespace
}  // namespace fluidymation
