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

struct alignas(16) Sum {
  std::array<std::int32_t, kColorLanes> lanes{};
};

/// Sums of a 5 x 5 picture, whose middle one is the window's own pixel.
class Sums {
 public:
  /// All samples count alike.
  Sums() : Sums([](std::size_t /*i*/) { return 1; }) {}

  /// @param weightOf  of sample i.
  template <typename WeightOf>
  explicit Sums(const WeightOf& weightOf) {
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      offsets_[i] = static_cast<std::ptrdiff_t>(kColorLanes) *
                    (sampleOffsetY(i) * kPatchSize + sampleOffsetX(i));
      weights_.ofSample[i] = weightOf(i);
      if (weights_.ofSample[i] != 0) weights_.blockCounts[i / kSampleBlock] = true;
    }
  }
  [[nodiscard]] WindowSums window() {
    return {sums_[kPatchArea / 2].lanes.data(), offsets_.data(), &weights_};
  }
  [[nodiscard]] const Sum& ofSample(std::size_t i) const {
    constexpr int kCentre = kPatchArea / 2;
    return sums_[static_cast<std::size_t>(kCentre + sampleOffsetY(i) * kPatchSize +
                                          sampleOffsetX(i))];
  }
  friend bool operator==(const Sums& a, const Sums& b) {
    return std::memcmp(a.sums_.data(), b.sums_.data(), sizeof a.sums_) == 0;
  }

 private:
  std::array<Sum, kPatchArea> sums_;
  std::array<std::ptrdiff_t, kPatchArea> offsets_{};
  SampleWeights weights_;
};

TEST_F(Avx2Kernels, AddTheSameColours) {
  Random random({68, 0, 0, 0, 0, 0});
  Sums expected;
  Sums sums;
  for (int n = 0; n < kWindows; ++n) {
    const SourceWindow source = sourceWindow(exemplar_, randomMatch(random));
    portableKernels().addColors(source, expected.window());
    avx2Kernels()->addColors(source, sums.window());
    ASSERT_TRUE(sums == expected) << n;
  }
}

TEST_P(EveryPatchKernels, AddColoursTimesTheirWeights) {
  Random random({70, 0, 0, 0, 0, 0});
  // Of the first block none counts; the window's own pixel does, by most
  const auto weightOf = [](std::size_t i) {
    if (i + 1 == kPatchArea) return 256;
    return i < kSampleBlock ? 0 : static_cast<std::int32_t>((i * 37 + 11) % 256);
  };
  for (int n = 0; n < kWindows; ++n) {
    const SourceWindow source = sourceWindow(exemplar_, randomMatch(random));
    Sums once;
    Sums weighted(weightOf);
    kernels().addColors(source, once.window());
    kernels().addColors(source, weighted.window());
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      for (std::size_t lane = 0; lane < kColorLanes; ++lane) {
        ASSERT_EQ(weighted.ofSample(i).lanes[lane], weightOf(i) * once.ofSample(i).lanes[lane]);
      }
    }
  }
}

TEST_P(EveryPatchKernels, AddedColoursEqualASlowDoublePrecisionTwin) {
  Random random({69, 0, 0, 0, 0, 0});
  for (int n = 0; n < kWindows; ++n) {
    const Match match = randomMatch(random);
    Sums sums;
    kernels().addColors(sourceWindow(exemplar_, match), sums.window());
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      const Sum& sum = sums.ofSample(i);
      for (std::size_t lane = 0; lane < 3; ++lane) {
        ASSERT_NEAR(sum.lanes[lane], slowSample(match, i, lane), test::interpolationError(kRange));
      }
      ASSERT_EQ(sum.lanes[3], 1) << "one window";
    }
  }
}

/// A grid of the exemplar's texels, its margins among them, and weights of either sign.
struct RandomGrid {
  RandomGrid(Random& random, Size size, int frames) {
    static constexpr std::array<int, 3> kTaps{2, 4, 6};  // linear, cubic, Lanczos
    taps = kTaps[static_cast<std::size_t>(random.uniform(0, 2))];
    constexpr int kMargin = ExemplarLevel::kMarginPx;
    left = random.uniform(-kMargin, size.width + kMargin - taps);
    top = random.uniform(-kMargin, size.height + kMargin - taps);
    frame = random.uniform(0, frames - 1);
    for (std::array<float, kMostTaps>* weights : {&columnWeights, &rowWeights}) {
      for (float& weight : *weights) weight = 2.0F * randomShare(random) - 1.0F;
    }
  }

  [[nodiscard]] std::array<float, kColorLanes> sum(const PatchKernels& kernels,
                                                   const ExemplarLevel& exemplar) const {
    return kernels.weightedGrid(&exemplar.texel(left, top, frame), exemplar.stride(),
                                static_cast<std::size_t>(taps), columnWeights.data(),
                                rowWeights.data());
  }

  static constexpr std::size_t kMostTaps = 6;
  int taps = 0;
  int left = 0;
  int top = 0;
  int frame = 0;
  std::array<float, kMostTaps> columnWeights{};
  std::array<float, kMostTaps> rowWeights{};
};

TEST_F(Avx2Kernels, SumTheSameGrids) {
  Random random({73, 0, 0, 0, 0, 0});
  for (int n = 0; n < kWindows; ++n) {
    const RandomGrid grid(random, size_, kFrames);
    const std::array<float, kColorLanes> expected = grid.sum(portableKernels(), exemplar_);
    const std::array<float, kColorLanes> sum = grid.sum(*avx2Kernels(), exemplar_);
    ASSERT_EQ(std::memcmp(sum.data(), expected.data(), sizeof sum), 0) << n;
  }
}

TEST_P(EveryPatchKernels, WeightedGridsEqualADoublePrecisionTwin) {
  Random random({74, 0, 0, 0, 0, 0});
  for (int n = 0; n < kWindows; ++n) {
    const RandomGrid grid(random, size_, kFrames);
    std::array<double, kColorLanes> expected{};
    std::array<double, kColorLanes> absolute{};
    for (int j = 0; j < grid.taps; ++j) {
      for (int i = 0; i < grid.taps; ++i) {
        const double weight = static_cast<double>(grid.columnWeights[static_cast<std::size_t>(i)]) *
                              static_cast<double>(grid.rowWeights[static_cast<std::size_t>(j)]);
        const std::array<int, 8> lanes =
            lanesOf(exemplar_.texel(grid.left + i, grid.top + j, grid.frame));
        for (std::size_t lane = 0; lane < kColorLanes; ++lane) {
          expected[lane] += weight * lanes[lane];
          absolute[lane] += std::abs(weight * lanes[lane]);
        }
      }
    }
    const std::array<float, kColorLanes> sum = grid.sum(kernels(), exemplar_);
    // Along a row and then along the column: a product and taps - 1 sums each, rounded by 2^-24;
    // one more for what the roundings multiply to
    const double rounding = (2 * grid.taps + 1) * 0x1p-24;
    for (std::size_t lane = 0; lane < kColorLanes; ++lane) {
      ASSERT_NEAR(sum[lane], expected[lane], rounding * absolute[lane]);
    }
  }
}

TEST_P(EveryPatchKernels, ReadPixelsThemselvesAtWholePlaces) {
  // No interpolation, and no rounding: an identity stays one
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) {
      const Match match{static_cast<float>(x), static_cast<float>(y), 1, {0.0F, -1.0F}};
      Sums sums;
      kernels().addColors(sourceWindow(exemplar_, match), sums.window());
      for (std::size_t i = 0; i < kPatchArea; ++i) {
        // R_90 turns (dx, dy) into (-dy, dx)
        const Texel& there = exemplar_.texel(x - sampleOffsetY(i), y + sampleOffsetX(i), 1);
        const std::array<int, 8> expected = lanesOf(there);
        for (std::size_t lane = 0; lane < kColorLanes; ++lane) {
          ASSERT_EQ(sums.ofSample(i).lanes[lane], expected[lane]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace fluidymation
