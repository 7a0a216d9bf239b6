#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "fluidymation/guides/distance_field.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/guides/motion.h"
#include "support/border_speed.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

const Size kSize{60, 58};
const Vec2 kCentre{29.3F, 28.8F};
constexpr int kFrames = 12;

TEST(SoftSequence, ADiscThatGrowsByAFractionOfAPixelMovesAtItsSpeedInEveryFrame) {
  for (const float blurPx : {0.0F, 1.5F}) {
    for (const float speed : {0.05F, 0.1F, 0.2F, 1.0F}) {
      std::vector<Image<float>> coverages;
      std::vector<Mask> masks;
      for (int i = 0; i < kFrames; ++i) {
        const float radius = 12.0F + speed * static_cast<float>(i);
        coverages.push_back(test::eightBit(test::softDisc(kSize, kCentre, radius)));
        masks.push_back(test::disc(kSize, kCentre, radius));
      }
      const std::vector<GuideFrame> soft = test::softGuidesOf(coverages, 2.0F, blurPx);
      const std::vector<GuideFrame> hard = test::guidesOf(masks, 2.0F);
      float hardMost = 0.0F;
      float softMost = 0.0F;
      for (std::size_t i = 0; i < soft.size(); ++i) {
        const test::BorderSpeed measured = test::borderSpeed(soft[i], kCentre);
        EXPECT_NEAR(measured.outward, speed, 0.02F * speed) << "frame " << i;
        EXPECT_LT(measured.sideways, 0.01F * speed) << "frame " << i;
        softMost = std::max(softMost, std::abs(measured.outward / speed - 1.0F));
        hardMost = std::max(hardMost,
                            std::abs(test::borderSpeed(hard[i], kCentre).outward / speed - 1.0F));
      }
      if (speed <= 0.1F) {
        EXPECT_GT(hardMost, 3.0F * softMost);
      }
    }
  }
}

TEST(SoftSequence, ADiscThatMovesByAFractionOfAPixelFlowsAlongTheMotion) {
  const Vec2 velocity{0.16F, 0.12F};
  constexpr float kSpeed = 0.2F;
  std::vector<Image<float>> coverages;
  for (int i = 0; i < kFrames; ++i) {
    coverages.push_back(
        test::eightBit(test::softDisc(kSize, kCentre + static_cast<float>(i) * velocity, 17.0F)));
  }
  const std::vector<GuideFrame> frames = test::softGuidesOf(coverages, 2.0F);
  for (int i = 0; i < kFrames; ++i) {
    const GuideFrame& frame = frames[static_cast<std::size_t>(i)];
    const Mask border = borderPixels(frame.mask);
    const Vec2 centre = kCentre + static_cast<float>(i) * velocity;
    float largest = 0.0F;
    for (int y = 0; y < border.height(); ++y) {
      for (int x = 0; x < border.width(); ++x) {
        if (border(x, y) == 0) continue;
        const Vec2 arm = test::place(x, y) - centre;
        const Vec2 outward = (1.0F / length(arm)) * arm;
        const Vec2 expected = dot(velocity, outward) * outward;
        largest = std::max(largest, length(frame.flow(x, y) - expected));
      }
    }
    EXPECT_LT(largest, 0.05F * kSpeed) << "frame " << i;
  }
}

TEST(SoftSequence, DistancesKeepThePixelCentreConvention) {
  const std::vector<GuideFrame> frames = [] {
    std::vector<Image<float>> coverages;
    coverages.push_back(test::softHalfPlane({20, 9}, {8.2F, 0.0F}, {1.0F, 0.0F}));
    return test::softGuidesOf(coverages, 2.0F);
  }();
  for (int x = 0; x < 20; ++x) {
    const float d = static_cast<float>(x) - 8.2F;
    EXPECT_NEAR(frames[0].distance(x, 4), d > 0.0F ? d + 0.5F : d - 0.5F, 1e-3F);
    EXPECT_NEAR(frames[0].coverage(x, 4), std::clamp(0.5F + d, 0.0F, 1.0F), 1e-3F);
  }
}

bool sameBytes(const Image<float>& a, const Image<float>& b) {
  return a.size() == b.size() &&
         (a.pixelCount() == 0 ||
          std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(float)) == 0);
}

bool sameBytes(const Image<Vec2>& a, const Image<Vec2>& b) {
  return std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Vec2)) == 0;
}

TEST(SoftSequence, HardMasksAreTreatedAsEver) {
  // Scaled, they have partly covered pixels, but are cut at one half
  for (const float sigmaPx : {0.0F, 0.3F, 0.8F, 2.0F}) {
    std::vector<Image<float>> scaled;
    std::vector<Mask> cut;
    for (int i = 0; i < 4; ++i) {
      scaled.push_back(test::softDisc(kSize, kCentre, 10.0F + static_cast<float>(i)));
      cut.push_back(InputMask(scaled.back().clone(), false).cut());
    }
    GuideOptions options;
    options.mask = {sigmaPx, 0.3F};
    GuideStream stream(
        4, [&](int i) { return InputMask(scaled[static_cast<std::size_t>(i)].clone(), false); },
        options);
    for (std::size_t i = 0; i < 4; ++i) {
      const GuideFrame frame = stream.next();
      const Mask expected = smoothMask(cut[i], options.mask);
      EXPECT_TRUE(test::equalEverywhere(expected, frame.mask));
      EXPECT_TRUE(sameBytes(signedDistance(expected), frame.distance));
      EXPECT_TRUE(frame.coverage.empty());
    }
  }
}

TEST(SoftSequence, OneSoftFrameMakesTheSequenceSoft) {
  for (const std::size_t softFrame : {0U, 2U, 4U}) {
    std::vector<Image<float>> coverages;
    for (int i = 0; i < 5; ++i) {
      coverages.push_back(test::softDisc(kSize, kCentre, 10.0F + static_cast<float>(i)));
    }
    GuideOptions options;
    options.mask = {0.0F, 0.3F};
    GuideStream stream(
        5,
        [&](int i) {
          const auto frame = static_cast<std::size_t>(i);
          return InputMask(coverages[frame].clone(), frame == softFrame);
        },
        options);
    for (std::size_t i = 0; i < 5; ++i) {
      const GuideFrame frame = stream.next();
      ASSERT_FALSE(frame.coverage.empty());
      const std::vector<GuideFrame> all = test::softGuidesOf(coverages, 2.0F);
      EXPECT_TRUE(sameBytes(all[i].distance, frame.distance));
      EXPECT_TRUE(sameBytes(all[i].flow, frame.flow));
      EXPECT_TRUE(sameBytes(all[i].coverage, frame.coverage));
    }
  }
}

TEST(SoftSequence, IsSoundForAnyLengthSizeAndKindOfMask) {
  for (int frames = 1; frames <= 6; ++frames) {
    for (const float blurPx : {0.0F, 1.0F}) {
      for (const Size size : {Size{1, 1}, Size{3, 3}, Size{2, 9}, Size{31, 27}}) {
        std::vector<Image<float>> coverages;
        for (int i = 0; i < frames; ++i) {
          const auto seed = static_cast<std::uint64_t>(10 * frames + i);
          const Mask blobs = test::randomBlobs(size, seed);
          Image<float> coverage(size, static_cast<float>(frames % 2));
          for (int y = 0; y < size.height && i % 4 != 3; ++y) {
            for (int x = 0; x < size.width; ++x) {
              coverage(x, y) = 0.6F * static_cast<float>(blobs(x, y)) +
                               0.4F * static_cast<float>((7 * x + 3 * y + i) % 10) / 9.0F;
            }
          }
          coverages.push_back(std::move(coverage));
        }
        for (const GuideFrame& frame : test::softGuidesOf(coverages, 1.0F, blurPx)) {
          ASSERT_EQ(frame.coverage.size(), size);
          EXPECT_TRUE(frame.diffusion.converged);
          for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
              ASSERT_TRUE(std::isfinite(frame.distance(x, y)));
              ASSERT_EQ(frame.distance(x, y) > 0.0F, frame.mask(x, y) != 0);
              ASSERT_GE(frame.coverage(x, y), frame.mask(x, y) != 0 ? 0.5F : 0.0F);
              ASSERT_LE(frame.coverage(x, y), frame.mask(x, y) != 0 ? 1.0F : 0.5F);
              if (frame.mask(x, y) != 0) {
                ASSERT_NEAR(length(frame.direction(x, y)), 1.0F, 1e-5F);
              }
              ASSERT_TRUE(std::isfinite(length(frame.flow(x, y))));
            }
          }
        }
      }
    }
  }
}

TEST(SoftSequence, EmptyAndFullFramesDoNotLeakTheirStandInDistances) {
  for (const float filling : {0.0F, 1.0F}) {
    std::vector<Image<float>> coverages;
    for (int i = 0; i < 12; ++i) {
      if (i == 0 || i == 6 || i == 11) {
        coverages.emplace_back(kSize, filling);
      } else {
        coverages.push_back(test::softDisc(kSize, kCentre, 9.0F + 0.2F * static_cast<float>(i)));
      }
    }
    const std::vector<GuideFrame> frames = test::softGuidesOf(coverages, 2.0F);
    for (std::size_t i = 0; i < 12; ++i) {
      for (const Vec2 flow : frames[i].flow) ASSERT_LT(length(flow), 0.3F) << i;
    }
    for (const std::size_t i : {0U, 6U, 11U}) {
      const auto far = static_cast<float>(kSize.width + kSize.height);
      EXPECT_EQ(frames[i].distance(3, 3), filling > 0.0F ? far : -far);
      EXPECT_EQ(frames[i].coverage(3, 3), filling);
    }
    EXPECT_NEAR(test::borderSpeed(frames[3], kCentre).outward, 0.2F, 0.016F);
  }
}

TEST(SoftSequence, TheNumberOfThreadsDoesNotShow) {
  std::vector<Image<float>> coverages;
  for (int i = 0; i < 3; ++i) {
    coverages.push_back(
        test::softDisc({140, 130}, {70.2F, 60.0F + 0.3F * static_cast<float>(i)}, 55.0F));
  }
  const int threadsBefore = omp_get_max_threads();
  std::vector<std::vector<GuideFrame>> results;
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    results.push_back(test::softGuidesOf(coverages, 2.0F, 1.2F));
  }
  omp_set_num_threads(threadsBefore);
  for (const std::size_t other : {1U, 2U}) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(sameBytes(results[0][i].distance, results[other][i].distance));
      EXPECT_TRUE(sameBytes(results[0][i].coverage, results[other][i].coverage));
      EXPECT_TRUE(sameBytes(results[0][i].flow, results[other][i].flow));
    }
  }
}

}  // namespace
}  // namespace fluidymation
