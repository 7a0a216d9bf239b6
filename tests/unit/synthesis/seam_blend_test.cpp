#include "synthesis/seam_blend.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include "fluidymation/core/random.h"

namespace fluidymation {
namespace {

constexpr Size kSize{9, 7};
constexpr std::size_t kPixels = 63;

/// Random steps; every fourth counts nothing, the others between 0.05 and 1.
WantedSteps randomSteps(Size size = kSize) {
  WantedSteps steps(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Random random({11, 0, 0, 0, x, y});
      for (Image<Float4>* image : {&steps.right, &steps.down}) {
        Float4& step = (*image)(x, y);
        for (std::size_t c = 0; c < 3; ++c) {
          step[c] = static_cast<float>(random.uniform(-100, 100)) / 10.0F;
        }
        step[3] =
            random.uniform(0, 3) == 0 ? 0.0F : static_cast<float>(random.uniform(5, 100)) / 100.0F;
      }
    }
  }
  return steps;
}

/// Visits every pair of neighbours: (p, q, step from p to q).
template <typename Visit>
void forEachStep(const WantedSteps& steps, const Visit& visit) {
  const Size size = steps.right.size();
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto p = static_cast<std::size_t>(y * size.width + x);
      if (x + 1 < size.width) visit(p, p + 1, steps.right(x, y));
      if (y + 1 < size.height) {
        visit(p, p + static_cast<std::size_t>(size.width), steps.down(x, y));
      }
    }
  }
}

/// One channel of the minimum, by elimination.
std::vector<double> slowChanges(const WantedSteps& steps, double weight, std::size_t channel) {
  std::vector<std::vector<double>> rows(kPixels, std::vector<double>(kPixels + 1, 0.0));
  for (std::size_t p = 0; p < kPixels; ++p) rows[p][p] = 1.0;
  forEachStep(steps, [&](std::size_t p, std::size_t q, const Float4& step) {
    const double counts = weight * static_cast<double>(step[3]);
    const double wanted = step[channel];
    rows[p][p] += counts;
    rows[q][q] += counts;
    rows[p][q] -= counts;
    rows[q][p] -= counts;
    rows[q][kPixels] += counts * wanted;
    rows[p][kPixels] -= counts * wanted;
  });
  for (std::size_t i = 0; i < kPixels; ++i) {  // positive definite: no pivots are needed
    for (std::size_t j = 0; j < kPixels; ++j) {
      if (j == i) continue;
      const double factor = rows[j][i] / rows[i][i];
      for (std::size_t k = i; k <= kPixels; ++k) rows[j][k] -= factor * rows[i][k];
    }
  }
  std::vector<double> changes;
  for (std::size_t i = 0; i < kPixels; ++i) changes.push_back(rows[i][kPixels] / rows[i][i]);
  return changes;
}

TEST(SeamChanges, AreTheMinimumThatEliminationFinds) {
  const WantedSteps steps = randomSteps();
  for (const float weight : {0.05F, 0.3F, 1.0F, 10.0F, 100.0F}) {
    const Image<Float4> changes = seamChanges(steps, weight);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const std::vector<double> expected = slowChanges(steps, weight, channel);
      double largest = 0.0;
      for (const double change : expected) largest = std::max(largest, std::abs(change));
      ASSERT_GT(largest, 0.1);
      for (std::size_t i = 0; i < kPixels; ++i) {
        EXPECT_NEAR(changes.data()[i][channel], expected[i], 0.01 * largest) << weight;
      }
    }
  }
}

TEST(SeamChanges, AreNoneWhereNoStepIsWanted) {
  WantedSteps steps(kSize);
  constexpr Float4 kNoChange{0.0F, 0.0F, 0.0F, 1.0F};
  for (Float4& step : steps.right) step = kNoChange;
  for (Float4& step : steps.down) step = kNoChange;
  const auto areAllZero = [](const Image<Float4>& changes) {
    for (const Float4& change : changes) {
      if (change[0] != 0.0F || change[1] != 0.0F || change[2] != 0.0F) return false;
    }
    return true;
  };
  EXPECT_TRUE(areAllZero(seamChanges(steps, 1.0F)));
  EXPECT_TRUE(areAllZero(seamChanges(randomSteps(), 0.0F)));
  WantedSteps countless = randomSteps();
  for (Float4& step : countless.right) step[3] = 0.0F;
  for (Float4& step : countless.down) step[3] = 0.0F;
  EXPECT_TRUE(areAllZero(seamChanges(countless, 1.0F)));
}

TEST(SeamChanges, AreTheSameForAnyNumberOfThreads) {
  const WantedSteps steps = randomSteps({61, 83});
  const int defaultThreads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Image<Float4> one = seamChanges(steps, 1.0F);
  for (const int threads : {2, 3, 7}) {
    omp_set_num_threads(threads);
    const Image<Float4> many = seamChanges(steps, 1.0F);
    EXPECT_EQ(std::memcmp(one.data(), many.data(), one.pixelCount() * sizeof(Float4)), 0);
  }
  omp_set_num_threads(defaultThreads);
}

TEST(SeamChanges, OfALineAreThoseOfALine) {
  // A step of 3 between two pixels, each held by its own color: 3 / (1 + 2 w) is what remains
  for (const bool upright : {false, true}) {
    WantedSteps steps(upright ? Size{1, 2} : Size{2, 1});
    (upright ? steps.down : steps.right)(0, 0) = Float4{3.0F, 0.0F, -1.5F, 1.0F};
    const Image<Float4> changes = seamChanges(steps, 1.0F);
    const Float4& last = changes(upright ? 0 : 1, upright ? 1 : 0);
    EXPECT_NEAR(last[0], 1.0F, 0.02F);
    EXPECT_NEAR(changes(0, 0)[0], -1.0F, 0.02F);
    EXPECT_NEAR(last[2], -0.5F, 0.02F);
  }
}

TEST(SeamChanges, OfASinglePixelAndOfNoneAreNone) {
  EXPECT_EQ(seamChanges(WantedSteps({1, 1}), 1.0F)(0, 0)[0], 0.0F);
  EXPECT_TRUE(seamChanges(WantedSteps({0, 0}), 1.0F).empty());
}

}  // namespace
}  // namespace fluidymation
