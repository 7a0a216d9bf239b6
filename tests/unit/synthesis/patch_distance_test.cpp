#include "fluidymation/synthesis/patch_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fluidymation/core/random.h"
#include "support/fixed_point.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr float kBorderWidthPx = 5.0F;

/// Steps between the colours of two pixels of the scene at most: lightness lies within 0..100, a
/// and b within +-15.
constexpr double kColorRange = 100.0 * kColorSteps;
/// Neighbours' edge guides differ by a pixel's distance, and by two at the edge: 2 kEdgeScale / 5.
/// The extents of a disc differ by less than its 8 frames move, and drop to 0 outside.
constexpr double kGuideRange = 8.0 * kEdgeSteps;

/// P§3.2 by angles: |tan(S^dir + theta - T^dir)|, at most 10; 0 where the source has no direction.
double slowMisalignment(double sx, double sy, const Rotation& rotation, Vec2 target) {
  if (sx == 0.0 && sy == 0.0) return 0.0;
  const double sourceAngle = std::atan2(sy, sx);
  const double theta =
      std::atan2(static_cast<double>(rotation.sine), static_cast<double>(rotation.cosine));
  const double targetAngle =
      std::atan2(static_cast<double>(target.y), static_cast<double>(target.x));
  return std::min(std::abs(std::tan(sourceAngle + theta - targetAngle)), 10.0);
}

/// Thesis §3.7 and P§3.2 term by term in double precision: no blending, no swapped windows, no
/// early stop; of the pixels as they are held in fixed point. A colour is off by the rounding of
/// its interpolation and of the blend, a guide by that of its interpolation.
test::Expected slowDistance(const ExemplarLevel& exemplar, const TargetLevel& target,
                            const DistanceWeights& w, int x, int y, const Match& match) {
  constexpr double kColorError =
      (test::interpolationError(kColorRange) + test::blendError(kColorRange)) / kColorSteps;
  constexpr double kEdgeError = test::interpolationError(kGuideRange) / kEdgeSteps;
  const double extSteps = exemplar.extentSteps();
  const double extError = test::interpolationError(kGuideRange) / extSteps;
  const double c = match.rotation.cosine;
  const double s = match.rotation.sine;
  const Vec2 sourceDirection = exemplar.direction(match.nearestX(), match.nearestY(), match.frame);
  const Vec2 turned = match.rotation.apply(sourceDirection);
  const bool opposite = dot(turned, target.direction(x, y)) < 0.0F;
  test::Expected color;
  test::Expected previous;
  test::Expected guides;
  double apart = 0.0;  // squares between the picture and the previous one
  double directions = 0.0;
  int inside = 0;
  int colored = 0;
  int remembered = 0;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const auto sample = [&](Channel channel) {
        return test::slowSample(exemplar, match.frame, match.x + c * dx + s * dy,
                                match.y - s * dx + c * dy, channel);
      };
      const int qx = x + dx;
      const int qy = y + dy;
      const auto addColor = [&](Lab lab, test::Expected& sum) {
        sum.addSquare(1.0 / 3.0, sample(kLightness) - lab.l, kColorError);
        sum.addSquare(1.0 / 3.0, sample(kGreenRed) - lab.a, kColorError);
        sum.addSquare(1.0 / 3.0, sample(kBlueYellow) - lab.b, kColorError);
      };
      const FixedLab t = target.segment.contains(qx, qy) ? target.picture(qx, qy) : FixedLab{};
      const FixedLab p = target.segment.contains(qx, qy) ? target.previous(qx, qy) : FixedLab{};
      if (t.exists()) {
        addColor(t.lab(), color);
        ++colored;
      }
      if (p.exists()) {
        addColor(p.lab(), previous);
        ++remembered;
      }
      if (t.exists() && p.exists()) {
        for (const float d :
             {t.lab().l - p.lab().l, t.lab().a - p.lab().a, t.lab().b - p.lab().b}) {
          apart += static_cast<double>(d) * static_cast<double>(d) / 3.0;
        }
      }
      if (target.segment.contains(qx, qy) && target.inside(qx, qy)) {
        directions += slowMisalignment(sample(kDirectionX), sample(kDirectionY), match.rotation,
                                       target.direction(qx, qy));
        ++inside;
      }
      const FixedGuides here = target.guides.clamped(qx, qy);
      const double forward = sample(opposite ? kExtBackward : kExtForward);
      const double backward = sample(opposite ? kExtForward : kExtBackward);
      guides.addSquare(w.dist, sample(kEdge) - here.edge / static_cast<double>(kEdgeSteps),
                       kEdgeError);
      guides.addSquare(w.flow, forward - here.extForward / extSteps, extError);
      guides.addSquare(w.flow, backward - here.extBackward / extSteps, extError);
    }
  }
  test::Expected sum;
  const double ofColor = colored > 0 ? static_cast<double>(w.color) / colored : 0.0;
  sum.add(ofColor, color);
  sum.tolerance += ofColor * test::kBlendSlip * apart;  // the window's constant
  sum.add(1.0 / kPatchArea, guides);
  if (remembered > 0) {
    const double ofPrevious = static_cast<double>(target.modulation(x, y)) * w.prev;
    sum.add(ofPrevious / remembered, previous);
  }
  // Near 84.3 degrees, where the clamp begins, tan multiplies the angle's rounding by 100
  const double misaligned = w.dir * directions / inside;
  sum.value += misaligned;
  sum.tolerance += 3e-4 * misaligned + 1e-5 * sum.value + 1e-6;  // single precision
  return sum;
}

class PatchDistanceTest : public ::testing::Test {
 protected:
  PatchDistanceTest() {
    target_.picture = test::fixedPicture(test::randomTexture(disc_.size, 11), target_.segment);
    target_.previous = test::fixedPicture(test::randomTexture(disc_.size, 12), target_.segment);
    for (int y = 0; y < disc_.size.height; ++y) {
      for (int x = 0; x < disc_.size.width; ++x) {
        Random random({13, 0, 0, 0, x, y});
        if (random.uniform(0, 3) == 0) target_.previous(x, y) = FixedLab{};
        target_.modulation(x, y) = static_cast<float>(random.uniform(0, 10)) / 10.0F;
      }
    }
  }

  [[nodiscard]] Match randomMatch(Random& random) const {
    const auto angle = static_cast<float>(random.uniform(0, 628)) / 100.0F;
    return {static_cast<float>(random.uniform(0, 4700)) / 100.0F,
            static_cast<float>(random.uniform(0, 3900)) / 100.0F,
            random.uniform(0, 7),
            {std::cos(angle), std::sin(angle)}};
  }

  /// Expects what the twin says of random matches at random pixels inside, and adds what it says
  /// to `compared`.
  void compareWithTwin(const DistanceWeights& weights, Random& random,
                       std::vector<test::Expected>& compared) const {
    const PatchDistance distance(exemplar_.level(0), target_, weights);
    TargetWindow window;
    for (int i = 0; i < 2000; ++i) {
      const int x = random.uniform(0, 47);
      const int y = random.uniform(0, 39);
      const Match match = randomMatch(random);
      if (!target_.inside(x, y)) continue;
      distance.gather(x, y, window);
      const test::Expected slow = slowDistance(exemplar_.level(0), target_, weights, x, y, match);
      ASSERT_NEAR(distance(window, match, kNever), slow.value, slow.tolerance)
          << "pixel " << x << ", " << y << "; match " << match.x << ", " << match.y;
      compared.push_back(slow);
    }
  }

  test::GrowingDisc disc_{Size{48, 40}, {20.0F, 12.0F}, 16.0F, 1.0F, 8};  // cut by the image edge
  Exemplar exemplar_ = test::discExemplar(disc_, 0, kBorderWidthPx, 10);
  TargetLevel target_{finestLevel(disc_.guides(4)), kBorderWidthPx};
  DistanceWeights weights_{1.0F, 5.0F, 0.1F, 1.0F};
};

TEST_F(PatchDistanceTest, EqualsASlowDoublePrecisionTwin) {
  Random random({14, 0, 0, 0, 0, 0});
  std::vector<test::Expected> compared;
  ASSERT_NO_FATAL_FAILURE(compareWithTwin(weights_, random, compared));
  EXPECT_GT(compared.size(), 500U);
  // The twin means something: it leaves little room
  double value = 0.0;
  double tolerance = 0.0;
  for (const test::Expected& e : compared) {
    value += e.value;
    tolerance += e.tolerance;
  }
  EXPECT_LT(tolerance, 0.01 * value);
}

TEST_F(PatchDistanceTest, TheDirectionTermEqualsASlowDoublePrecisionTwin) {
  const DistanceWeights onlyDirections{0.0F, 0.0F, 0.0F, 0.0F, 1.0F};
  weights_.dir = 1.5F;
  Random random({17, 0, 0, 0, 0, 0});
  std::vector<test::Expected> compared;
  for (const DistanceWeights& weights : {onlyDirections, weights_}) {
    ASSERT_NO_FATAL_FAILURE(compareWithTwin(weights, random, compared));
  }
  EXPECT_GT(std::count_if(compared.begin(), compared.end(),
                          [](const test::Expected& e) { return e.value > 0.1; }),
            500);
}

TEST_F(PatchDistanceTest, DirectionsCostNothingAlongAndAgainstAndMostAcross) {
  const DistanceWeights onlyDirections{0.0F, 0.0F, 0.0F, 0.0F, 2.0F};
  target_.direction = Image<Vec2>(disc_.size, Vec2{0.0F, 1.0F});
  // All directions of the exemplar's window are nearly (1, 0), far right of the disc's centre
  const auto cost = [&](Vec2 rotation) {
    const PatchDistance distance(exemplar_.level(0), target_, onlyDirections);
    TargetWindow window;
    distance.gather(20, 12, window);
    return distance(window, {38.0F, 12.0F, 7, Rotation{rotation.x, rotation.y}}, kNever);
  };
  EXPECT_LT(cost({0.0F, 1.0F}), 0.2F);
  EXPECT_LT(cost({0.0F, -1.0F}), 0.2F);
  EXPECT_NEAR(cost({std::sqrt(0.5F), std::sqrt(0.5F)}), 2.0F, 0.1F);  // tan 45 degrees
  EXPECT_GT(cost({1.0F, 0.0F}), 0.9F * 2.0F * kLargestMisalignment);
  EXPECT_LE(cost({1.0F, 0.0F}), 1.001F * 2.0F * kLargestMisalignment);
}

TEST_F(PatchDistanceTest, EveryWeightSwitchesItsTermOff) {
  Random random({15, 0, 0, 0, 0, 0});
  const Match match = randomMatch(random);
  for (const DistanceWeights& weights :
       {DistanceWeights{1, 0, 0, 0}, DistanceWeights{0, 5, 0, 0}, DistanceWeights{0, 0, 0.1F, 0},
        DistanceWeights{0, 0, 0, 1}, DistanceWeights{0, 0, 0, 0, 1}}) {
    const PatchDistance distance(exemplar_.level(0), target_, weights);
    TargetWindow window;
    distance.gather(20, 20, window);
    const test::Expected slow = slowDistance(exemplar_.level(0), target_, weights, 20, 20, match);
    EXPECT_GT(slow.value, 2.0 * slow.tolerance);  // cannot be mistaken for 0
    EXPECT_NEAR(distance(window, match, kNever), slow.value, slow.tolerance);
  }
}

TEST_F(PatchDistanceTest, IsZeroOnItself) {
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      if (target_.inside(x, y)) target_.picture(x, y) = exemplar_.level(0).texel(x, y, 4).color;
    }
  }
  target_.previous = Image<FixedLab>(disc_.size);
  const PatchDistance distance(exemplar_.level(0), target_, weights_);
  TargetWindow window;
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      if (!target_.inside(x, y)) continue;
      distance.gather(x, y, window);
      const Match itself{static_cast<float>(x), static_cast<float>(y), 4, Rotation{}};
      EXPECT_EQ(distance(window, itself, kNever), 0.0F) << x << ' ' << y;
    }
  }
}

TEST_F(PatchDistanceTest, StoppingEarlyNeverReportsLessThanTheBound) {
  const PatchDistance distance(exemplar_.level(0), target_, weights_);
  Random random({16, 0, 0, 0, 0, 0});
  TargetWindow window;
  distance.gather(20, 20, window);
  int stopped = 0;
  for (int i = 0; i < 300; ++i) {
    const Match match = randomMatch(random);
    const float full = distance(window, match, kNever);
    for (const float share : {0.1F, 0.5F, 0.9F, 1.5F}) {
      const float bound = share * full;
      const float early = distance(window, match, bound);
      if (full >= bound) {
        EXPECT_GE(early, bound);
        stopped += early < full ? 1 : 0;
      } else {
        EXPECT_EQ(early, full);
      }
    }
  }
  EXPECT_GT(stopped, 100);
}

TEST_F(PatchDistanceTest, OppositeDirectionsExchangeTheExtents) {
  // Frame 4 of 8 frames, rim right of the centre: ext+ and ext- differ there.
  DistanceWeights onlyFlow{0.0F, 0.0F, 1.0F, 0.0F};
  const PatchDistance distance(exemplar_.level(0), target_, onlyFlow);
  TargetWindow window;
  distance.gather(36, 12, window);
  const Match aligned{36.0F, 12.0F, 4, Rotation{}};
  EXPECT_EQ(distance(window, aligned, kNever), 0.0F);
  const Match turned{36.0F, 12.0F, 4, Rotation{-1.0F, 0.0F}};
  EXPECT_GT(distance(window, turned, kNever), 0.1F);
}

}  // namespace
}  // namespace fluidymation
