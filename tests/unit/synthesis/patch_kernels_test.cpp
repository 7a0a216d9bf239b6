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
#include "support/fixed_point.h"
#include "support/synthetic_scene.h"
#include "synthesis/sample_order.h"

namespace fluidymation {

/// So that a failing test says which kernels it is about.
void PrintTo(const PatchKernels* kernels, std::ostream* out) {
  *out << (kernels == nullptr ? "none" : kernels->name);
}

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr int kWindows = 4000;
constexpr std::size_t kColorLanes = 4;  // L, a, b and the weight

/// Two values may be as far apart as fixed point allows.
constexpr double kRange = 2.0 * kLargestFixed;

std::int16_t randomFixed(Random& random) {
  return static_cast<std::int16_t>(random.uniform(-kLargestFixed, kLargestFixed));
}

FixedLab randomColor(Random& random) {
  return {randomFixed(random), randomFixed(random), randomFixed(random), 1};
}

FixedGuides randomGuides(Random& random) {
  return {randomFixed(random), 0, randomFixed(random), randomFixed(random)};
}

float randomShare(Random& random) { return static_cast<float>(random.uniform(0, 1000)) / 1000.0F; }

std::array<int, 8> lanesOf(const Texel& t) {
  return {t.color.l,     t.color.a,       t.color.b,           t.color.weight,
          t.guides.edge, t.guides.unused, t.guides.extForward, t.guides.extBackward};
}

bool sameBits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

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

INSTANTIATE_TEST_SUITE_P(Kernels, EveryPatchKernels,
                         ::testing::Values(&portableKernels(), avx2Kernels()),
                         [](const auto& instance) {
                           return instance.index == 0 ? "Portable" : "Avx2";
                         });

/// The AVX2 kernels beside the portable ones.
class Avx2Kernels : public PatchKernelsTest {
 protected:
  void SetUp() override {
    if (avx2Kernels() == nullptr) GTEST_SKIP() << "no AVX2 in this build or processor";
  }
};

/// A target's window of random pixels, with random weights, some of them 0. Its last sample, which
/// is none of the window's, weighs nothing.
TargetWindow randomWindow(Random& random) {
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

struct alignas(16) Sum {
  std::array<std::int32_t, kColorLanes> lanes{};
};

/// Sums of a 5 x 5 picture, whose middle one is the window's own pixel.
class Sums {
 public:
  Sums() {
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      offsets_[i] = static_cast<std::ptrdiff_t>(kColorLanes) *
                    (sampleOffsetY(i) * kPatchSize + sampleOffsetX(i));
    }
  }
  [[nodiscard]] WindowSums window() {
    return {sums_[kPatchArea / 2].lanes.data(), offsets_.data()};
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
