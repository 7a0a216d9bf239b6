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

/// What a window is gathered from: images of random pixels, some of which have no picture, no
/// previous one, or neither.
struct RandomTarget {
  explicit RandomTarget(Random& random) {
    const int presence = random.uniform(0, 5);  // of five: from none to all
    for (std::size_t i = 0; i < guides.size(); ++i) {
      if (random.uniform(0, 4) < presence) picture[i] = randomColor(random);
      if (random.uniform(0, 4) < presence) previous[i] = randomColor(random);
      guides[i] = randomGuides(random);
    }
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      offsets[i] = sampleOffsetY(i) * kPatchSize + sampleOffsetX(i);
    }
    weights.color = random.uniform(0, 4) == 0 ? 0.0F : randomShare(random);
    weights.previous = random.uniform(0, 4) == 0 ? 0.0F : 5.0F * randomShare(random);
    weights.dist = randomShare(random);
    weights.flow = randomShare(random);
  }

  [[nodiscard]] WindowSource source() const {
    constexpr std::size_t kCentre = kPatchArea / 2;
    return {&picture[kCentre], &previous[kCentre], &guides[kCentre], offsets.data()};
  }

  std::array<FixedLab, kPatchArea> picture;
  std::array<FixedLab, kPatchArea> previous;
  std::array<FixedGuides, kPatchArea> guides;
  std::array<std::int32_t, TargetWindow::kSamples> offsets{};
  WindowWeights weights;
};

::testing::AssertionResult sameWindows(const TargetWindow& a, const TargetWindow& b) {
  constexpr std::size_t kTexels = kPatchArea * sizeof(Texel);  // the last one may be anything
  if (std::memcmp(a.value.data(), b.value.data(), kTexels) != 0) {
    return ::testing::AssertionFailure() << "values differ";
  }
  if (std::memcmp(a.swapped.data(), b.swapped.data(), kTexels) != 0) {
    return ::testing::AssertionFailure() << "swapped values differ";
  }
  if (std::memcmp(a.weight.data(), b.weight.data(), sizeof a.weight) != 0) {
    return ::testing::AssertionFailure() << "weights differ";
  }
  if (!sameBits(a.constant, b.constant)) {
    return ::testing::AssertionFailure()
           << "constants differ: " << a.constant << " and " << b.constant;
  }
  return ::testing::AssertionSuccess();
}

TEST_F(Avx2Kernels, GatherTheSameWindows) {
  Random random({65, 0, 0, 0, 0, 0});
  for (int n = 0; n < kWindows; ++n) {
    const RandomTarget target(random);
    TargetWindow expected;
    TargetWindow window = randomWindow(random);  // what is there before does not show
    portableKernels().gather(target.source(), target.weights, expected);
    avx2Kernels()->gather(target.source(), target.weights, window);
    ASSERT_TRUE(sameWindows(window, expected)) << n;
  }
}

/// `a` and `b` blended with the shares 1 - share and share, steps.
double blend(int a, int b, double share) { return a + share * (b - a); }

TEST_P(EveryPatchKernels, GatheredWindowsEqualASlowDoublePrecisionTwin) {
  constexpr double kSingle = 1e-6;  // relative: a few operations in single precision
  Random random({66, 0, 0, 0, 0, 0});
  int blended = 0;
  for (int n = 0; n < kWindows; ++n) {
    const RandomTarget target(random);
    TargetWindow window;
    kernels().gather(target.source(), target.weights, window);
    int colored = 0;
    int remembered = 0;
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      colored += target.picture[i].exists() ? 1 : 0;
      remembered += target.previous[i].exists() ? 1 : 0;
    }
    const double ofColor = colored > 0 ? static_cast<double>(target.weights.color) / colored : 0.0;
    const double ofPrevious =
        remembered > 0 ? static_cast<double>(target.weights.previous) / remembered : 0.0;
    const double both = ofColor + ofPrevious;
    const double share = both > 0.0 ? ofPrevious / both : 0.0;
    double apart = 0.0;
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      constexpr std::size_t kCentre = kPatchArea / 2;
      const std::size_t pixel =
          static_cast<std::size_t>(static_cast<int>(kCentre) + target.offsets[i]);
      const FixedLab t = target.picture[pixel];
      const FixedLab p = target.previous[pixel];
      const FixedGuides g = target.guides[pixel];
      const Texel& value = window.value[i];
      const double weight = (t.exists() ? ofColor : 0.0) + (p.exists() ? ofPrevious : 0.0);
      for (const std::size_t lane : {0U, 1U}) {
        ASSERT_NEAR(window.weight[i][lane], weight, kSingle * weight);
      }
      ASSERT_EQ(window.weight[i][2], target.weights.dist);
      ASSERT_EQ(window.weight[i][3], target.weights.flow);
      const std::array<int, 8> lanes = lanesOf(value);
      const std::array<int, 8> ofT = lanesOf({t, g});
      const std::array<int, 8> ofP = lanesOf({p, g});
      for (std::size_t lane = 0; lane < 3; ++lane) {
        if (t.exists() && p.exists()) {
          const double range = std::abs(ofT[lane] - ofP[lane]);
          ASSERT_NEAR(lanes[lane], blend(ofT[lane], ofP[lane], share), test::blendError(range));
          apart += range * range;
        } else if (t.exists() || p.exists()) {
          ASSERT_EQ(lanes[lane], t.exists() ? ofT[lane] : ofP[lane]);
        }
      }
      blended += t.exists() && p.exists() && share > 0.0 ? 1 : 0;
      ASSERT_EQ(value.color.weight, 1) << "as the exemplar's, so that it makes no difference";
      ASSERT_EQ(value.guides.edge, g.edge);
      ASSERT_EQ(value.guides.unused, 0);
      ASSERT_EQ(value.guides.extForward, g.extForward);
      ASSERT_EQ(value.guides.extBackward, g.extBackward);
      const Texel swapped{value.color, {g.edge, 0, g.extBackward, g.extForward}};
      ASSERT_EQ(lanesOf(window.swapped[i]), lanesOf(swapped));
    }
    // a b / (a + b) |t - p|^2 with a share that slips
    ASSERT_NEAR(window.constant, ofColor * share * apart,
                ofColor * (test::kBlendSlip + kSingle * share) * apart);
    for (const float weight : window.weight[kPatchArea]) ASSERT_EQ(weight, 0.0F);
  }
  EXPECT_GT(blended, kWindows);
}

TEST(PatchDistanceGather, RepeatsTheEdgeAndHasNoColourBeyondIt) {
  // Window by window what the portable kernel makes of a copy in which the edge repeats
  const test::GrowingDisc all{Size{9, 8}, {4.0F, 4.0F}, 100.0F, 1.0F, 3};
  const Exemplar exemplar = test::discExemplar(all, 0, 5.0F, 1);
  TargetLevel target(finestLevel(all.guides(1)), 5.0F);
  Random random({67, 0, 0, 0, 0, 0});
  for (std::size_t i = 0; i < target.picture.pixelCount(); ++i) {
    if (random.uniform(0, 3) > 0) target.picture.data()[i] = randomColor(random);
    if (random.uniform(0, 3) > 0) target.previous.data()[i] = randomColor(random);
    target.guides.data()[i] = randomGuides(random);
    target.modulation.data()[i] = randomShare(random);
  }
  const DistanceWeights weights{1.0F, 5.0F, 0.1F, 2.0F};
  const PatchDistance distance(exemplar.level(0), target, weights);
  for (int y = 0; y < all.size.height; ++y) {
    for (int x = 0; x < all.size.width; ++x) {
      std::array<FixedLab, kPatchArea> picture{};
      std::array<FixedLab, kPatchArea> previous{};
      std::array<FixedGuides, kPatchArea> guides{};
      std::array<std::int32_t, TargetWindow::kSamples> offsets{};
      for (std::size_t i = 0; i < kPatchArea; ++i) {
        const int qx = x + sampleOffsetX(i);
        const int qy = y + sampleOffsetY(i);
        offsets[i] = static_cast<std::int32_t>(i);
        guides[i] = target.guides.clamped(qx, qy);
        if (!target.picture.contains(qx, qy)) continue;
        picture[i] = target.picture(qx, qy);
        previous[i] = target.previous(qx, qy);
      }
      const auto perStep = [](float weight, float steps) { return weight / (steps * steps); };
      const float prev = target.modulation(x, y) * weights.prev;
      constexpr auto kColors = static_cast<float>(kColorChannels);
      constexpr auto kArea = static_cast<float>(kPatchArea);
      const WindowWeights ofSteps{perStep(weights.color / kColors, kColorSteps),
                                  perStep(prev / kColors, kColorSteps),
                                  perStep(weights.dist / kArea, kEdgeSteps),
                                  perStep(weights.flow / kArea, exemplar.level(0).extentSteps())};
      TargetWindow expected;
      portableKernels().gather({picture.data(), previous.data(), guides.data(), offsets.data()},
                               ofSteps, expected);
      TargetWindow window;
      distance.gather(x, y, window);
      ASSERT_TRUE(sameWindows(window, expected)) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace fluidymation
