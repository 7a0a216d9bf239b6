#include "synthesis/patch_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <vector>

#include "fluidymation/core/random.h"
#include "patch_kernels_fixture.h"
#include "support/fixed_point.h"
#include "support/synthetic_scene.h"
#include "synthesis/sample_order.h"

namespace fluidymation {
namespace {

TEST(SampleOrder, CoversEveryOffsetOfTheWindowOnceAndIsPaddedWithTheCentre) {
  std::array<int, kPatchArea> seen{};
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    const int x = sampleOffsetX(i);
    const int y = sampleOffsetY(i);
    ASSERT_LE(std::max(std::abs(x), std::abs(y)), kPatchRadius);
    ++seen[static_cast<std::size_t>((y + kPatchRadius) * kPatchSize + x + kPatchRadius)];
  }
  for (const int count : seen) EXPECT_EQ(count, 1);
  for (std::size_t i = kPatchArea; i < kPaddedSamples; ++i) {
    EXPECT_EQ(sampleOffsetX(i), 0);
    EXPECT_EQ(sampleOffsetY(i), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryPatchKernels,
                         ::testing::Values(&portableKernels(), avx2Kernels()),
                         [](const auto& instance) {
                           return instance.index == 0 ? "Portable" : "Avx2";
                         });

TEST_F(Avx2Kernels, CompareToTheSameDistancesAfterTheSameSamples) {
  Random random({62, 0, 0, 0, 0, 0});
  int stopped = 0;
  for (int n = 0; n < kWindows; ++n) {
    const TargetWindow window = randomWindow(random);
    const Match match = randomMatch(random);
    const SourceWindow source = sourceWindow(exemplar_, match);
    for (const Texel* wanted : {window.value.data(), window.swapped.data()}) {
      int all = 0;
      const float full = portableKernels().distance(window, wanted, source, kNever, all);
      ASSERT_EQ(all, kPatchArea);
      for (const float stopAt : {kNever, 0.0F, 0.2F * full, 0.5F * full, 0.9F * full,
                                 std::nextafter(full, 0.0F), full, std::nextafter(full, kNever)}) {
        int expectedSamples = 0;
        int samples = 0;
        const float expected =
            portableKernels().distance(window, wanted, source, stopAt, expectedSamples);
        const float distance = avx2Kernels()->distance(window, wanted, source, stopAt, samples);
        ASSERT_TRUE(sameBits(distance, expected)) << distance << " and " << expected;
        ASSERT_EQ(samples, expectedSamples);
        stopped += samples < kPatchArea ? 1 : 0;
      }
    }
  }
  EXPECT_GT(stopped, kWindows);
}

/// Bounds at which a comparison with these distances stops sooner or later, or never.
std::vector<float> boundsRound(const std::array<float, 2>& full) {
  std::vector<float> bounds{kNever, 0.0F};
  for (const float distance : full) {
    for (const float bound :
         {0.2F * distance, 0.5F * distance, 0.9F * distance, std::nextafter(distance, 0.0F),
          distance, std::nextafter(distance, kNever)}) {
      bounds.push_back(bound);
    }
  }
  return bounds;
}

TEST_F(Avx2Kernels, CompareBothWaysToTheSameDistancesAfterTheSameSamples) {
  Random random({70, 0, 0, 0, 0, 0});
  int stopped = 0;
  for (int n = 0; n < kWindows; ++n) {
    const TargetWindow window = randomWindow(random);
    const SourceWindow source = sourceWindow(exemplar_, randomMatch(random));
    const auto compare = [&](const PatchKernels& kernels, float stopAt, int& samples) {
      return kernels.bothDistances(window, window.value.data(), window.swapped.data(), source,
                                   stopAt, samples);
    };
    int all = 0;
    const std::array<float, 2> full = compare(portableKernels(), kNever, all);
    ASSERT_EQ(all, kPatchArea);
    for (const float stopAt : boundsRound(full)) {
      int expectedSamples = 0;
      int samples = 0;
      const std::array<float, 2> expected = compare(portableKernels(), stopAt, expectedSamples);
      const std::array<float, 2> distances = compare(*avx2Kernels(), stopAt, samples);
      for (const std::size_t way : {0U, 1U}) {
        ASSERT_TRUE(sameBits(distances[way], expected[way]))
            << distances[way] << " and " << expected[way];
      }
      ASSERT_EQ(samples, expectedSamples);
      stopped += samples < kPatchArea ? 1 : 0;
    }
  }
  EXPECT_GT(stopped, kWindows);
}

TEST_P(EveryPatchKernels, BothDistancesAreThatOfAMatchAndThatOfItsOpposite) {
  // To the bit, and not at whole pixels alone: a half turn only exchanges the samples
  Random random({71, 0, 0, 0, 0, 0});
  for (int n = 0; n < kWindows; ++n) {
    const TargetWindow window = randomWindow(random);
    Match match = randomMatch(random);
    if (n % 2 == 0) {
      match.x = static_cast<float>(match.nearestX());
      match.y = static_cast<float>(match.nearestY());
    }
    Match opposite = match;
    opposite.rotation = match.rotation.opposite();
    for (const Texel* turned : {window.value.data(), window.swapped.data()}) {
      int samples = 0;
      const float ofMatch = kernels().distance(window, window.value.data(),
                                               sourceWindow(exemplar_, match), kNever, samples);
      const float ofOpposite =
          kernels().distance(window, turned, sourceWindow(exemplar_, opposite), kNever, samples);
      samples = 0;
      const std::array<float, 2> both = kernels().bothDistances(
          window, window.value.data(), turned, sourceWindow(exemplar_, match), kNever, samples);
      ASSERT_EQ(samples, kPatchArea);
      ASSERT_TRUE(sameBits(both[0], ofMatch)) << both[0] << " and " << ofMatch;
      ASSERT_TRUE(sameBits(both[1], ofOpposite)) << both[1] << " and " << ofOpposite;
    }
  }
}

TEST_P(EveryPatchKernels, CompareBothWaysUntilBothReachTheBound) {
  Random random({72, 0, 0, 0, 0, 0});
  int stopped = 0;
  for (int n = 0; n < kWindows; ++n) {
    const TargetWindow window = randomWindow(random);
    const SourceWindow source = sourceWindow(exemplar_, randomMatch(random));
    const auto compare = [&](float stopAt, int& samples) {
      return kernels().bothDistances(window, window.value.data(), window.swapped.data(), source,
                                     stopAt, samples);
    };
    int samples = 0;
    const std::array<float, 2> full = compare(kNever, samples);
    for (const float stopAt : boundsRound(full)) {
      const std::array<float, 2> early = compare(stopAt, samples);
      ASSERT_TRUE(samples == kPatchArea || samples % kSampleBlock == 0) << samples;
      ASSERT_GE(samples, kSampleBlock);
      for (const std::size_t way : {0U, 1U}) {
        if (samples == kPatchArea) {
          ASSERT_TRUE(sameBits(early[way], full[way]));
        } else {
          ASSERT_GE(early[way], stopAt);
          ASSERT_LE(early[way], full[way]);
        }
      }
      if (std::min(full[0], full[1]) < stopAt) {
        ASSERT_EQ(samples, kPatchArea) << "one of them may be wanted";
      }
      stopped += samples < kPatchArea ? 1 : 0;
    }
  }
  EXPECT_GT(stopped, kWindows);
}

TEST_P(EveryPatchKernels, DistancesEqualASlowDoublePrecisionTwin) {
  constexpr double kError = test::interpolationError(kRange);
  Random random({63, 0, 0, 0, 0, 0});
  for (int n = 0; n < kWindows; ++n) {
    const TargetWindow window = randomWindow(random);
    const Match match = randomMatch(random);
    test::Expected expected{static_cast<double>(window.constant), 0.0};
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      const std::array<int, 8> wanted = lanesOf(window.value[i]);
      for (std::size_t lane = 0; lane < wanted.size(); ++lane) {
        expected.addSquare(window.weight[i][lane / 2], slowSample(match, i, lane) - wanted[lane],
                           kError);
      }
    }
    int samples = 0;
    const float distance = kernels().distance(window, window.value.data(),
                                              sourceWindow(exemplar_, match), kNever, samples);
    // Single precision: fewer than 32 sums after one another, each rounded by 2^-24
    ASSERT_NEAR(distance, expected.value, expected.tolerance + 0x1p-19 * expected.value);
    ASSERT_LT(expected.tolerance, 0.001 * expected.value) << "the twin means something";
  }
}

TEST_P(EveryPatchKernels, StopAfterWholeBlocksOnceTheBoundIsReached) {
  Random random({64, 0, 0, 0, 0, 0});
  for (int n = 0; n < kWindows; ++n) {
    const TargetWindow window = randomWindow(random);
    const SourceWindow source = sourceWindow(exemplar_, randomMatch(random));
    int samples = 0;
    const float full = kernels().distance(window, window.value.data(), source, kNever, samples);
    const float stopAt = randomShare(random) * full;
    const float early = kernels().distance(window, window.value.data(), source, stopAt, samples);
    ASSERT_GE(early, stopAt);
    ASSERT_LE(early, full);
    ASSERT_TRUE(samples == kPatchArea || samples % kSampleBlock == 0) << samples;
    ASSERT_GE(samples, kSampleBlock);
    const float beyond = std::nextafter(full, kNever);
    ASSERT_TRUE(
        sameBits(kernels().distance(window, window.value.data(), source, beyond, samples), full));
    ASSERT_EQ(samples, kPatchArea);
  }
}

}  // namespace
}  // namespace fluidymation
