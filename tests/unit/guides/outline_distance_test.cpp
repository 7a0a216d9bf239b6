#include "fluidymation/guides/outline_distance.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "fluidymation/guides/distance_field.h"
#include "fluidymation/guides/edge_coverage.h"
#include "fluidymation/guides/gaussian.h"
#include "fluidymation/guides/motion.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

Image<float> distanceOf(const Image<float>& coverage, const MaskOptions& options) {
  const OutlinedMask shape = outlinedMask(coverage, options);
  return outlineDistance(shape.mask, shape.outline);
}

/// Largest and mean difference to `truth(x, y)` over the pixels for which it is given.
struct Errors {
  double largest = 0.0;
  double mean = 0.0;
};

template <typename Truth, typename Wanted>
Errors errorsOf(const Image<float>& distance, const Truth& truth, const Wanted& wanted) {
  Errors errors;
  int count = 0;
  for (int y = 0; y < distance.height(); ++y) {
    for (int x = 0; x < distance.width(); ++x) {
      if (!wanted(x, y)) continue;
      const double error = std::abs(static_cast<double>(distance(x, y) - truth(x, y)));
      errors.largest = std::max(errors.largest, error);
      errors.mean += error;
      ++count;
    }
  }
  errors.mean /= std::max(count, 1);
  return errors;
}

/// How far inside the isoline of `threshold` a step's own place lies, after smoothing.
float isolineShift(float sigmaPx, float threshold) {
  if (sigmaPx == 0.0F) return 0.0F;
  const double sigma = std::sqrt(static_cast<double>(sigmaPx * sigmaPx) + 1.0 / 12.0);
  double low = -5.0;
  double high = 5.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < static_cast<double>(threshold) ? low : high) =
        middle;
  }
  return static_cast<float>(-low * sigma);
}

constexpr float kPi = 3.1415927F;

TEST(OutlineDistance, OfAStraightEdgeIsExactAtEveryAngleAndOffsetNearAndFar) {
  const Size size{150, 140};
  for (const float sigmaPx : {0.0F, 0.5F, 0.7F, 1.0F, 2.5F, 4.2F}) {
    for (const float threshold : {0.3F, 0.5F}) {
      Errors worst;
      for (int i = 0; i <= 24; ++i) {
        const float angle =
            2.0F * kPi * static_cast<float>(i) / 48.0F + (i % 3 == 0 ? 0.0F : 0.013F);
        const Vec2 normal{std::cos(angle), std::sin(angle)};
        const Vec2 point = Vec2{75.0F, 70.0F} + (0.137F * static_cast<float>(i)) * normal;
        const float shift = isolineShift(sigmaPx, threshold);
        const Image<float> distance = distanceOf(
            test::eightBit(test::softHalfPlane(size, point, normal)), {sigmaPx, threshold});
        const auto truth = [&](int x, int y) {
          return dot(test::place(x, y) - point, normal) + shift;
        };
        // Where the foot of the perpendicular lies within the frame, clear of the repeated edge
        const float margin = 3.0F + 3.0F * sigmaPx;
        const auto wanted = [&](int x, int y) {
          const Vec2 foot = test::place(x, y) - truth(x, y) * normal;
          return foot.x > margin && foot.y > margin && foot.x < 149.0F - margin &&
                 foot.y < 139.0F - margin;
        };
        const Errors errors = errorsOf(distance, truth, wanted);
        worst.largest = std::max(worst.largest, errors.largest);
      }
      // A narrow Gaussian of whole pixels is not quite one: below one half, where its isoline lies
      // is a matter of definition, but the same for all angles and offsets
      const double limit = threshold < 0.5F && sigmaPx > 0.0F && sigmaPx < 1.0F ? 0.1 : 0.03;
      EXPECT_LT(worst.largest, limit) << "sigma " << sigmaPx << ", threshold " << threshold;
    }
  }
}

TEST(OutlineDistance, OfADiscFollowsItsRadiusInSubPixelSteps) {
  const Size size{90, 84};
  const Vec2 centre{44.3F, 41.7F};
  for (const float sigmaPx : {0.0F, 1.0F}) {
    double hardMean = 0.0;
    double softMean = 0.0;
    for (float radius = 4.0F; radius < 30.0F; radius += radius < 8.0F ? 0.17F : 2.13F) {
      const Image<float> coverage = test::eightBit(test::softDisc(size, centre, radius));
      const auto truth = [&](int x, int y) { return radius - length(test::place(x, y) - centre); };
      const auto everywhere = [](int, int) { return true; };
      const Errors soft = errorsOf(distanceOf(coverage, {sigmaPx, 0.5F}), truth, everywhere);
      const Errors hard = errorsOf(
          continuousDistance(signedDistance(test::disc(size, centre, radius))), truth, everywhere);
      // Smoothing itself shrinks a disc, by about sigma^2 / (2 radius)
      EXPECT_LT(soft.largest, 0.1 + static_cast<double>(0.5F * sigmaPx * sigmaPx / radius))
          << radius << ", sigma " << sigmaPx;
      hardMean += hard.mean;
      softMean += soft.mean;
    }
    if (sigmaPx == 0.0F) {
      EXPECT_LT(softMean, 0.1 * hardMean);
    }
  }
}

/// Looks at every piece of the polygon.
Image<float> bruteForce(const Mask& mask, const Outline& outline) {
  const Crossings crossings = outline.crossings(mask);
  struct Piece {
    Vec2 from;
    Vec2 to;
  };
  std::vector<Piece> pieces;
  for (int y = 0; y + 1 < mask.height(); ++y) {
    for (int x = 0; x + 1 < mask.width(); ++x) {
      const Vec2 top{static_cast<float>(x) + crossings.right(x, y), static_cast<float>(y)};
      const Vec2 bottom{static_cast<float>(x) + crossings.right(x, y + 1),
                        static_cast<float>(y + 1)};
      const Vec2 left{static_cast<float>(x), static_cast<float>(y) + crossings.down(x, y)};
      const Vec2 right{static_cast<float>(x + 1), static_cast<float>(y) + crossings.down(x + 1, y)};
      std::vector<Vec2> ends;
      if (crossings.right(x, y) > 0.0F) ends.push_back(top);
      if (crossings.right(x, y + 1) > 0.0F) ends.push_back(bottom);
      if (crossings.down(x, y) > 0.0F) ends.push_back(left);
      if (crossings.down(x + 1, y) > 0.0F) ends.push_back(right);
      if (ends.size() == 2) pieces.push_back({ends[0], ends[1]});
      if (ends.size() != 4) continue;
      const bool upperLeftIsCut = mask(x, y) == 0;
      pieces.push_back({top, upperLeftIsCut ? left : right});
      pieces.push_back({bottom, upperLeftIsCut ? right : left});
    }
  }
  const auto onFrame = [&mask](Vec2 end) {
    return end.x == 0.0F || end.y == 0.0F || end.x == static_cast<float>(mask.width() - 1) ||
           end.y == static_cast<float>(mask.height() - 1);
  };
  // How far a piece reaches past its end on the frame
  const auto past = [&](Vec2 end, Vec2 pixel) {
    return onFrame(end) ? std::clamp(2.0F - length(pixel - end), 0.0F, 1.0F) : 0.0F;
  };
  Image<float> distance(mask.size());
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      float nearest = INFINITY;
      for (const Piece& piece : pieces) {
        const Vec2 along = piece.to - piece.from;
        const float first = -past(piece.from, test::place(x, y)) / length(along);
        const float last = 1.0F + past(piece.to, test::place(x, y)) / length(along);
        const float share =
            std::clamp(dot(test::place(x, y) - piece.from, along) / dot(along, along), first, last);
        nearest = std::min(nearest, length(test::place(x, y) - piece.from - share * along));
      }
      distance(x, y) = mask(x, y) != 0 ? nearest : -nearest;
    }
  }
  return distance;
}

/// Coverage with no order in it, or with a little after smoothing.
Image<float> randomCoverage(Size size, std::uint64_t seed, float blurPx) {
  const Mask blobs = test::randomBlobs(size, seed);
  const Mask dust = test::randomMask(size, seed + 100, 50);
  Image<float> coverage(size);
  for (std::size_t i = 0; i < coverage.pixelCount(); ++i) {
    coverage.data()[i] =
        0.8F * static_cast<float>(blobs.data()[i]) + 0.2F * static_cast<float>(dust.data()[i]);
  }
  return gaussianBlur(coverage, blurPx);
}

TEST(OutlineDistance, IsNearlyThatToTheWholePolygon) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    for (const float blurPx : {0.0F, 0.8F}) {
      const OutlinedMask shape =
          outlinedMask(randomCoverage({41, 37}, seed, blurPx), MaskOptions{0.0F, 0.5F});
      if (shape.outline.crossingCount() == 0) continue;
      const Image<float> distance = outlineDistance(shape.mask, shape.outline);
      const Image<float> slow = bruteForce(shape.mask, shape.outline);
      // The nearest piece need not meet the nearest corner: but never nearer than the truth
      for (std::size_t i = 0; i < slow.pixelCount(); ++i) {
        const float fast = std::abs(distance.data()[i]);
        const float truth = std::abs(slow.data()[i]);
        ASSERT_GE(fast, truth - 1e-4F);
        ASSERT_LE(fast, truth + 0.1F);
        ASSERT_EQ(distance.data()[i] > 0.0F, shape.mask.data()[i] != 0);
      }
    }
  }
}

TEST(OutlineDistance, CommutesWithFlipsAndTransposition) {
  const Image<float> coverage = randomCoverage({40, 23}, 3, 0.7F);
  const Image<float> distance = distanceOf(coverage, {1.0F, 0.4F});
  EXPECT_TRUE(test::nearEverywhere(test::flippedX(distance),
                                   distanceOf(test::flippedX(coverage), {1.0F, 0.4F}), 2e-3F));
  EXPECT_TRUE(test::nearEverywhere(test::transposed(distance),
                                   distanceOf(test::transposed(coverage), {1.0F, 0.4F}), 2e-3F));
}

TEST(OutlineDistance, WorksOnTheSmallestFrames) {
  for (const Size size : {Size{2, 1}, Size{1, 2}, Size{1, 7}, Size{3, 3}, Size{2, 2}}) {
    Image<float> coverage(size);
    coverage(0, 0) = 0.75F;
    const Image<float> distance = distanceOf(coverage, {0.0F, 0.5F});
    for (const float d : distance) ASSERT_TRUE(std::isfinite(d));
    EXPECT_GT(distance(0, 0), 0.0F);
    EXPECT_LT(distance(size.width - 1, size.height - 1), 0.0F);
  }
  Image<float> row(Size{9, 1});
  for (int x = 4; x < 9; ++x) row(x, 0) = 1.0F;
  row(3, 0) = 0.3F;  // the edge is at 3.2
  const Image<float> distance = distanceOf(row, {0.0F, 0.5F});
  for (int x = 0; x < 9; ++x) EXPECT_NEAR(distance(x, 0), static_cast<float>(x) - 3.2F, 1e-4F);
}

TEST(OutlineDistance, TheNumberOfThreadsDoesNotShow) {
  const Image<float> coverage = randomCoverage({210, 190}, 8, 1.5F);
  const int threadsBefore = omp_get_max_threads();
  omp_set_num_threads(1);
  const Image<float> one = distanceOf(coverage, {1.0F, 0.3F});
  for (const int threads : {2, 5}) {
    omp_set_num_threads(threads);
    const Image<float> many = distanceOf(coverage, {1.0F, 0.3F});
    EXPECT_EQ(std::memcmp(one.data(), many.data(), one.pixelCount() * sizeof(float)), 0);
  }
  omp_set_num_threads(threadsBefore);
}

TEST(PixelCentreDistance, IsUndoneByContinuousDistance) {
  const OutlinedMask shape = outlinedMask(randomCoverage({30, 20}, 2, 1.0F), {0.0F, 0.5F});
  const Image<float> distance = outlineDistance(shape.mask, shape.outline);
  const Image<float> centre = pixelCentreDistance(shape.mask, distance);
  EXPECT_TRUE(test::nearEverywhere(distance, continuousDistance(centre), 1e-5F));
  for (std::size_t i = 0; i < centre.pixelCount(); ++i) {
    ASSERT_GE(std::abs(centre.data()[i]), 0.5F);
  }
}

TEST(EdgeCoverage, IsTheAreaOfThePixelOnTheInnerSide) {
  for (int i = 0; i < 60; ++i) {
    const float angle = 2.0F * kPi * static_cast<float>(i) / 60.0F;
    const Vec2 normal{std::cos(angle), std::sin(angle)};
    for (const float distance : {-0.9F, -0.6F, -0.31F, 0.0F, 0.17F, 0.52F, 0.7F, 1.0F}) {
      const Image<float> truth = test::softHalfPlane({1, 1}, (-distance) * normal, normal);
      EXPECT_NEAR(edgeCoverage(distance, 3.0F * normal), truth(0, 0), 2e-3F)
          << angle << ", " << distance;
    }
  }
  EXPECT_EQ(edgeCoverage(0.25F, {}), 0.75F);
}

TEST(CoverageOf, AStraightEdgeIsWhatItWas) {
  for (int i = 0; i <= 24; ++i) {
    const float angle = 2.0F * kPi * static_cast<float>(i) / 48.0F + (i % 3 == 0 ? 0.0F : 0.013F);
    const Vec2 normal{std::cos(angle), std::sin(angle)};
    const Vec2 point = Vec2{20.0F, 19.0F} + (0.137F * static_cast<float>(i)) * normal;
    const Image<float> coverage = test::eightBit(test::softHalfPlane({44, 40}, point, normal));
    const Image<float> again = coverageOf(distanceOf(coverage, {0.0F, 0.5F}));
    // Up to the sides of the frame that the edge crosses at more than 45 degrees
    const int marginX = std::abs(normal.x) > 0.7F ? 2 : 0;
    const int marginY = std::abs(normal.y) > 0.7F ? 2 : 0;
    for (int y = marginY; y < 40 - marginY; ++y) {
      for (int x = marginX; x < 44 - marginX; ++x) {
        ASSERT_NEAR(again(x, y), coverage(x, y), 1.0F / 255.0F) << angle << " " << x << "," << y;
      }
    }
  }
}

}  // namespace
}  // namespace fluidymation
