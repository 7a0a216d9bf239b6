#include "fluidymation/synthesis/patch_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fluidymation/core/random.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr float kBorderWidthPx = 5.0F;

double square(double v) { return v * v; }

double slowSample(const ExemplarLevel& level, int frame, double x, double y, int channel) {
  x = std::clamp(x, 0.0, level.size().width - 1.0);
  y = std::clamp(y, 0.0, level.size().height - 1.0);
  const int x0 = std::min(static_cast<int>(x), std::max(0, level.size().width - 2));
  const int y0 = std::min(static_cast<int>(y), std::max(0, level.size().height - 2));
  const int x1 = std::min(x0 + 1, level.size().width - 1);
  const int y1 = std::min(y0 + 1, level.size().height - 1);
  const double fx = x - x0;
  const double fy = y - y0;
  const auto at = [&](int px, int py) {
    return static_cast<double>(level.pixel(px, py, frame)[channel]);
  };
  return (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x1, y0)) +
         fy * ((1 - fx) * at(x0, y1) + fx * at(x1, y1));
}

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
/// early stop.
double slowDistance(const ExemplarLevel& exemplar, const TargetLevel& target,
                    const DistanceWeights& w, int x, int y, const Match& match) {
  const double c = match.rotation.cosine;
  const double s = match.rotation.sine;
  const Vec2 sourceDirection = exemplar.direction(match.nearestX(), match.nearestY(), match.frame);
  const Vec2 turned = match.rotation.apply(sourceDirection);
  const bool opposite = dot(turned, target.direction(x, y)) < 0.0F;
  double color = 0.0;
  double directions = 0.0;
  double previous = 0.0;
  double guides = 0.0;
  int colored = 0;
  int remembered = 0;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const auto sample = [&](int channel) {
        return slowSample(exemplar, match.frame, match.x + c * dx + s * dy,
                          match.y - s * dx + c * dy, channel);
      };
      const int qx = x + dx;
      const int qy = y + dy;
      const auto toColor = [&](Lab lab) {
        return (square(sample(kLightness) - lab.l) + square(sample(kGreenRed) - lab.a) +
                square(sample(kBlueYellow) - lab.b)) /
               3.0;
      };
      if (target.segment.contains(qx, qy) && target.inside(qx, qy)) {
        color += toColor(target.picture(qx, qy));
        directions += slowMisalignment(sample(kDirectionX), sample(kDirectionY), match.rotation,
                                       target.direction(qx, qy));
        ++colored;
      }
      if (target.segment.contains(qx, qy) && target.hasPrevious(qx, qy) != 0) {
        previous += toColor(target.previous(qx, qy));
        ++remembered;
      }
      const double forward = sample(opposite ? kExtBackward : kExtForward);
      const double backward = sample(opposite ? kExtForward : kExtBackward);
      guides += w.dist * square(sample(kEdge) - target.edge.clamped(qx, qy)) +
                w.flow * (square(forward - target.extForward.clamped(qx, qy)) +
                          square(backward - target.extBackward.clamped(qx, qy)));
    }
  }
  double sum = w.color * color / colored + guides / 25.0 + w.dir * directions / colored;
  if (remembered > 0) sum += target.modulation(x, y) * w.prev * previous / remembered;
  return sum;
}

class PatchDistanceTest : public ::testing::Test {
 protected:
  PatchDistanceTest() {
    target_.picture = test::randomTexture(disc_.size, 11);
    target_.previous = test::randomTexture(disc_.size, 12);
    for (int y = 0; y < disc_.size.height; ++y) {
      for (int x = 0; x < disc_.size.width; ++x) {
        Random random({13, 0, 0, 0, x, y});
        target_.hasPrevious(x, y) =
            static_cast<std::uint8_t>(target_.inside(x, y) && random.uniform(0, 3) > 0);
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

  /// Expects what the twin says, to `tolerance` of it and 1e-4, of random matches at random pixels
  /// inside, and adds what it says to `compared`.
  void compareWithTwin(const DistanceWeights& weights, double tolerance, Random& random,
                       std::vector<double>& compared) const {
    const PatchDistance distance(exemplar_.level(0), target_, weights);
    TargetWindow window;
    for (int i = 0; i < 2000; ++i) {
      const int x = random.uniform(0, 47);
      const int y = random.uniform(0, 39);
      const Match match = randomMatch(random);
      if (!target_.inside(x, y)) continue;
      distance.gather(x, y, window);
      const double slow = slowDistance(exemplar_.level(0), target_, weights, x, y, match);
      ASSERT_NEAR(distance(window, match, kNever), slow, tolerance * slow + 1e-4)
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
  std::vector<double> compared;
  ASSERT_NO_FATAL_FAILURE(compareWithTwin(weights_, 1e-4, random, compared));
  EXPECT_GT(compared.size(), 500U);
}

TEST_F(PatchDistanceTest, TheDirectionTermEqualsASlowDoublePrecisionTwin) {
  const DistanceWeights onlyDirections{0.0F, 0.0F, 0.0F, 0.0F, 1.0F};
  weights_.dir = 1.5F;
  Random random({17, 0, 0, 0, 0, 0});
  std::vector<double> compared;
  for (const DistanceWeights& weights : {onlyDirections, weights_}) {
    // Near 84.3 degrees, where the clamp begins, tan multiplies the angle's rounding by 100
    ASSERT_NO_FATAL_FAILURE(compareWithTwin(weights, 3e-4, random, compared));
  }
  EXPECT_GT(std::count_if(compared.begin(), compared.end(), [](double d) { return d > 0.1; }), 500);
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
    const double slow = slowDistance(exemplar_.level(0), target_, weights, 20, 20, match);
    EXPECT_GT(slow, 0.0);
    EXPECT_NEAR(distance(window, match, kNever), slow, 1e-4 * slow + 1e-4);
  }
}

TEST_F(PatchDistanceTest, IsZeroOnItself) {
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      const Lanes& pixel = exemplar_.level(0).pixel(x, y, 4);
      target_.picture(x, y) = {pixel[kLightness], pixel[kGreenRed], pixel[kBlueYellow]};
    }
  }
  target_.hasPrevious = Mask(disc_.size);
  const PatchDistance distance(exemplar_.level(0), target_, weights_);
  TargetWindow window;
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      if (!target_.inside(x, y)) continue;
      distance.gather(x, y, window);
      const Match itself{static_cast<float>(x), static_cast<float>(y), 4, Rotation{}};
      EXPECT_NEAR(distance(window, itself, kNever), 0.0F, 1e-6F) << x << ' ' << y;
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
  EXPECT_NEAR(distance(window, aligned, kNever), 0.0F, 1e-6F);
  const Match turned{36.0F, 12.0F, 4, Rotation{-1.0F, 0.0F}};
  EXPECT_GT(distance(window, turned, kNever), 0.1F);
}

}  // namespace
}  // namespace fluidymation
