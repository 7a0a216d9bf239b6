#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/exemplar.h"
#include "synthesis/patch_kernels.h"
#include "synthesis/sample_order.h"

namespace fluidymation {

/// So that a failing test says which kernels it is about.
inline void PrintTo(const PatchKernels* kernels, std::ostream* out) {
  *out << (kernels == nullptr ? "none" : kernels->name);
}

inline constexpr float kNever = std::numeric_limits<float>::infinity();
inline constexpr int kWindows = 4000;
inline constexpr std::size_t kColorLanes = 4;  // L, a, b and the weight

/// Two values may be as far apart as fixed point allows.
inline constexpr double kRange = 2.0 * kLargestFixed;

inline std::int16_t randomFixed(Random& random) {
  return static_cast<std::int16_t>(random.uniform(-kLargestFixed, kLargestFixed));
}

inline FixedLab randomColor(Random& random) {
  return {randomFixed(random), randomFixed(random), randomFixed(random), 1};
}

inline FixedGuides randomGuides(Random& random) {
  return {randomFixed(random), 0, randomFixed(random), randomFixed(random)};
}

inline float randomShare(Random& random) {
  return static_cast<float>(random.uniform(0, 1000)) / 1000.0F;
}

inline std::array<int, 8> lanesOf(const Texel& t) {
  return {t.color.l,     t.color.a,       t.color.b,           t.color.weight,
          t.guides.edge, t.guides.unused, t.guides.extForward, t.guides.extBackward};
}

inline bool sameBits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// An exemplar in which every value of every pixel is drawn from all that fixed point has: the
/// hardest for the arithmetic.
class PatchKernelsTest : public ::testing::Test {
 protected:
  static constexpr int kFrames = 2;
  const Size size_{13, 11};

  PatchKernelsTest() : exemplar_(size_, kFrames, kBorderWidthPx) {
    const ExtentScale scale;
    for (int k = 0; k < kFrames; ++k) {
      Image<Lab> color(size_);
      GuideLevel guides{Mask(size_, 1),
                        Image<float>(size_),
                        Image<float>(size_),
                        Image<float>(size_),
                        Image<Vec2>(size_),
                        Image<Vec2>(size_),
                        {}};
      for (int y = 0; y < size_.height; ++y) {
        for (int x = 0; x < size_.width; ++x) {
          Random random({61, k, 0, 0, x, y});
          const auto draw = [&random](float steps) {
            return static_cast<float>(randomFixed(random)) / steps;
          };
          color(x, y) = {draw(kColorSteps), draw(kColorSteps), draw(kColorSteps)};
          guides.distance(x, y) = draw(kEdgeSteps) / kEdgeScale * kBorderWidthPx;
          guides.extForward(x, y) = draw(scale.stepsPerUnit()) * kExtUnitPx;
          guides.extBackward(x, y) = draw(scale.stepsPerUnit()) * kExtUnitPx;
        }
      }
      exemplar_.setColor(k, color);
      exemplar_.setGuides(k, guides);
    }
    exemplar_.finish(scale);
  }

  /// Anywhere whose nearest pixel is in the image, and often at the ends of that; turned by any
  /// angle, and often by a multiple of a quarter.
  [[nodiscard]] Match randomMatch(Random& random) const {
    const auto coordinate = [&random](int length) {
      const float last = std::nextafter(static_cast<float>(length) - 0.5F, 0.0F);
      switch (random.uniform(0, 7)) {
        case 0:
          return -0.5F;
        case 1:
          return last;
        case 2:
          return static_cast<float>(random.uniform(0, length - 1));
        default:
          return std::clamp(static_cast<float>(random.uniform(0, 1000 * length)) / 1000.0F - 0.5F,
                            -0.5F, last);
      }
    };
    const float x = coordinate(size_.width);
    const float y = coordinate(size_.height);
    static constexpr std::array<Rotation, 4> kQuarters{
        {{1.0F, 0.0F}, {0.0F, 1.0F}, {-1.0F, 0.0F}, {0.0F, -1.0F}}};
    const int turn = random.uniform(0, 9999);
    const float angle = kTwoPi * static_cast<float>(turn) / 10000.0F;
    const Rotation rotation = turn % 4 == 0
                                  ? kQuarters[static_cast<std::size_t>(random.uniform(0, 3))]
                                  : Rotation{std::cos(angle), std::sin(angle)};
    return {x, y, random.uniform(0, kFrames - 1), rotation};
  }

  /// A lane of the exemplar's pixels at the i-th sample of a window, steps, in double precision.
  [[nodiscard]] double slowSample(const Match& match, std::size_t i, std::size_t lane) const {
    const double dx = sampleOffsetX(i);
    const double dy = sampleOffsetY(i);
    const double c = match.rotation.cosine;
    const double s = match.rotation.sine;
    const double x = match.x + dx * c + dy * s;
    const double y = match.y + dy * c - dx * s;
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto at = [&](int px, int py) {
      const Texel& texel =
          exemplar_.texel(std::clamp(static_cast<int>(left) + px, 0, size_.width - 1),
                          std::clamp(static_cast<int>(top) + py, 0, size_.height - 1), match.frame);
      return static_cast<double>(lanesOf(texel)[lane]);
    };
    const double fx = x - left;
    const double fy = y - top;
    return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) +
           fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
  }

  static constexpr float kBorderWidthPx = 5.0F;
  ExemplarLevel exemplar_;
};

/// The same with each instruction set that the processor has.
class EveryPatchKernels : public PatchKernelsTest,
                          public ::testing::WithParamInterface<const PatchKernels*> {
 protected:
  void SetUp() override {
    if (GetParam() == nullptr) GTEST_SKIP() << "no AVX2 in this build or processor";
  }
  [[nodiscard]] static const PatchKernels& kernels() { return *GetParam(); }
};

/// The AVX2 kernels beside the portable ones.
class Avx2Kernels : public PatchKernelsTest {
 protected:
  void SetUp() override {
    if (avx2Kernels() == nullptr) GTEST_SKIP() << "no AVX2 in this build or processor";
  }
};

/// A target's window of random pixels, with random weights, some of them 0. Its last sample, which
/// is none of the window's, weighs nothing.
inline TargetWindow randomWindow(Random& random) {
  TargetWindow window;
  for (std::size_t i = 0; i < TargetWindow::kSamples; ++i) {
    window.value[i] = {randomColor(random), randomGuides(random)};
    window.swapped[i] = {randomColor(random), randomGuides(random)};
    if (i == kPatchArea) continue;
    const float color = random.uniform(0, 4) == 0 ? 0.0F : 1e-6F * randomShare(random);
    window.weight[i] = {color, color, 1e-6F * randomShare(random), 1e-6F * randomShare(random)};
  }
  window.constant = randomShare(random);
  return window;
}

}  // namespace fluidymation
