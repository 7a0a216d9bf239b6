#include "fluidymation/synthesis/vote.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "fluidymation/core/random.h"
#include "one_frame_exemplar.h"
#include "support/synthetic_scene.h"
#include "vote_tolerance.h"

namespace fluidymation {
namespace {

void expectSame(FixedLab actual, FixedLab expected) {
  EXPECT_EQ(actual.l, expected.l);
  EXPECT_EQ(actual.a, expected.a);
  EXPECT_EQ(actual.b, expected.b);
  EXPECT_EQ(actual.weight, expected.weight);
}

TEST(Vote, TheIdentityFieldReproducesTheExemplar) {
  const Image<Lab> color = test::randomTexture({20, 16}, 3);
  const ExemplarLevel exemplar = oneFrame(color);
  NearestNeighborField nnf(color.size());
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 20; ++x) {
      nnf(x, y) = {static_cast<float>(x), static_cast<float>(y), 0, Rotation{}};
    }
  }
  const Image<FixedLab> picture =
      vote(exemplar, Image<Segment>(color.size(), Segment::kBorder), nnf, 0.0F);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 20; ++x) expectSame(picture(x, y), FixedLab::of(color(x, y)));
  }
}

TEST(Vote, AFieldThatTurnsByARightAngleTurnsThePicture) {
  const Image<Lab> color = test::randomTexture({16, 16}, 4);
  const ExemplarLevel exemplar = oneFrame(color);
  const Rotation quarter{0.0F, 1.0F};  // source right becomes target down
  NearestNeighborField nnf(color.size());
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      nnf(x, y) = {static_cast<float>(y), static_cast<float>(15 - x), 0, quarter};
    }
  }
  const Image<FixedLab> picture =
      vote(exemplar, Image<Segment>(color.size(), Segment::kBorder), nnf, 0.0F);
  for (int y = 2; y < 14; ++y) {
    for (int x = 2; x < 14; ++x) expectSame(picture(x, y), FixedLab::of(color(y, 15 - x)));
  }
}

TEST(Vote, AConstantExemplarVotesItsConstant) {
  const ExemplarLevel exemplar = oneFrame(Image<Lab>(Size{12, 12}, Lab{40.0F, 5.0F, -7.0F}));
  NearestNeighborField nnf(Size{9, 9});
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 9; ++x) {
      Random random({1, 0, 0, 0, x, y});
      const auto angle = static_cast<float>(random.uniform(0, 6));
      nnf(x, y) = {static_cast<float>(random.uniform(0, 11)),
                   static_cast<float>(random.uniform(0, 11)),
                   0,
                   {std::cos(angle), std::sin(angle)}};
    }
  }
  for (const float sigmaPx : {0.0F, 0.5F, 100.0F}) {
    const Image<FixedLab> picture =
        vote(exemplar, Image<Segment>(nnf.size(), Segment::kBorder), nnf, sigmaPx);
    for (const FixedLab color : picture) expectSame(color, FixedLab::of({40.0F, 5.0F, -7.0F}));
  }
}

TEST(Vote, StaysWithinTheExemplarsExtremes) {
  const Image<Lab> color = test::randomTexture({24, 24}, 5);
  const ExemplarLevel exemplar = oneFrame(color);
  const auto [low, high] = std::minmax_element(
      color.begin(), color.end(), [](const Lab& a, const Lab& b) { return a.l < b.l; });
  NearestNeighborField nnf(Size{10, 10});
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      Random random({2, 0, 0, 0, x, y});
      nnf(x, y) = {static_cast<float>(random.uniform(0, 23)),
                   static_cast<float>(random.uniform(0, 23)),
                   0,
                   {0.6F, 0.8F}};
    }
  }
  for (const float sigmaPx : {0.0F, 0.5F, 100.0F}) {
    const Image<FixedLab> picture =
        vote(exemplar, Image<Segment>(nnf.size(), Segment::kBorder), nnf, sigmaPx);
    for (const FixedLab voted : picture) {
      EXPECT_GE(voted.l, FixedLab::of(*low).l);
      EXPECT_LE(voted.l, FixedLab::of(*high).l);
    }
  }
}

TEST(Vote, PixelsThatNoWindowCoversDoNotExist) {
  const ExemplarLevel exemplar = oneFrame(Image<Lab>(Size{12, 12}));
  NearestNeighborField nnf(Size{12, 1});
  nnf(0, 0) = {5.0F, 5.0F, 0, Rotation{}};
  Image<Segment> inside(Size{12, 1}, Segment::kBorder);
  inside(1, 0) = Segment::kOutside;
  const Image<FixedLab> picture = vote(exemplar, inside, nnf, 0.0F);
  EXPECT_TRUE(picture(0, 0).exists());
  EXPECT_FALSE(picture(1, 0).exists());  // covered, but outside the mask
  EXPECT_TRUE(picture(2, 0).exists());
  EXPECT_FALSE(picture(3, 0).exists());
}

/// A field of sub-pixel matches that agree on nothing, some missing and some outside the exemplar,
/// for a picture of several bands of rows.
class TallVote : public ::testing::Test {
 protected:
  const Size size_{37, 83};  // two bands of 32 rows and a part
  const Size exemplarSize_{24, 20};
  ExemplarLevel exemplar_ = oneFrame(test::randomTexture(exemplarSize_, 6));
  Image<Segment> segment_{size_, Segment::kBorder};
  NearestNeighborField nnf_{size_};

  TallVote() {
    for (int y = 0; y < size_.height; ++y) {
      for (int x = 0; x < size_.width; ++x) {
        Random random({7, 0, 0, 0, x, y});
        if (random.uniform(0, 9) == 0) segment_(x, y) = Segment::kOutside;
        if (random.uniform(0, 3) == 0) continue;
        const auto coordinate = [&random](int length) {
          return static_cast<float>(random.uniform(-300, 100 * length + 300)) / 100.0F;
        };
        const float sx = coordinate(exemplarSize_.width);
        const float sy = coordinate(exemplarSize_.height);
        const float angle = kTwoPi * static_cast<float>(random.uniform(0, 999)) / 1000.0F;
        nnf_(x, y) = {sx, sy, 0, {std::cos(angle), std::sin(angle)}};
      }
    }
    // A hole that no window covers
    for (int y = 28; y < 36; ++y) {
      for (int x = 10; x < 20; ++x) nnf_(x, y) = Match{};
    }
  }

  /// The mean at (x, y) over the windows that cover it, weighted by a Gaussian of their centres'
  /// distance in whole 256ths, sigma 0: all alike; a match outside the exemplar stands for the
  /// nearest place whose nearest pixel is inside. @return  false where there are none.
  [[nodiscard]] bool slowVote(int x, int y, double sigmaPx,
                              std::array<double, kColorChannels>& mean) const {
    mean = {};
    double weights = 0.0;
    for (int ny = y - kPatchRadius; ny <= y + kPatchRadius; ++ny) {
      for (int nx = x - kPatchRadius; nx <= x + kPatchRadius; ++nx) {
        if (!nnf_.contains(nx, ny) || !nnf_(nx, ny).exists()) continue;
        const Match& match = nnf_(nx, ny);
        const double dx = x - nx;
        const double dy = y - ny;
        const double weight =
            sigmaPx > 0.0 ? std::round(256.0 * std::exp(-0.5 * (dx / sigmaPx * (dx / sigmaPx) +
                                                                dy / sigmaPx * (dy / sigmaPx))))
                          : 1.0;
        const double c = match.rotation.cosine;
        const double s = match.rotation.sine;
        const double centreX =
            std::clamp(static_cast<double>(match.x), -0.5, exemplarSize_.width - 0.5);
        const double centreY =
            std::clamp(static_cast<double>(match.y), -0.5, exemplarSize_.height - 0.5);
        for (const Channel channel : {kLightness, kGreenRed, kBlueYellow}) {
          mean[static_cast<std::size_t>(channel)] +=
              weight * test::slowSample(exemplar_, 0, centreX + c * dx + s * dy,
                                        centreY + c * dy - s * dx, channel);
        }
        weights += weight;
      }
    }
    for (double& m : mean) m /= std::max(weights, 1.0);
    return weights > 0.0;
  }
};

TEST_F(TallVote, EqualsASlowDoublePrecisionTwin) {
  for (const float sigmaPx : {0.0F, 1e-30F, 0.35F, 0.5F, 1.0F, 100.0F}) {
    SCOPED_TRACE(sigmaPx);
    const Image<FixedLab> picture = vote(exemplar_, segment_, nnf_, sigmaPx);
    ASSERT_EQ(picture.size(), size_);
    int uncovered = 0;
    for (int y = 0; y < size_.height; ++y) {
      for (int x = 0; x < size_.width; ++x) {
        std::array<double, kColorChannels> mean{};
        const bool covered = slowVote(x, y, sigmaPx, mean);
        const bool wanted = segment_(x, y) != Segment::kOutside;
        uncovered += wanted && !covered ? 1 : 0;
        ASSERT_EQ(picture(x, y).exists(), wanted && covered) << x << ", " << y;
        if (!picture(x, y).exists()) continue;
        ASSERT_EQ(picture(x, y).weight, 1);
        const Lab voted = picture(x, y).lab();
        ASSERT_NEAR(voted.l, mean[kLightness], kVoteTolerance) << x << ", " << y;
        ASSERT_NEAR(voted.a, mean[kGreenRed], kVoteTolerance) << x << ", " << y;
        ASSERT_NEAR(voted.b, mean[kBlueYellow], kVoteTolerance) << x << ", " << y;
      }
    }
    EXPECT_GT(uncovered, 0);
  }
}

bool sameBytes(const Image<FixedLab>& a, const Image<FixedLab>& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(FixedLab)) == 0;
}

TEST_F(TallVote, IsTheSameForAnyNumberOfThreads) {
  const int defaultThreads = omp_get_max_threads();
  for (const float sigmaPx : {0.0F, 0.5F}) {
    omp_set_num_threads(1);
    const Image<FixedLab> one = vote(exemplar_, segment_, nnf_, sigmaPx);
    for (const int threads : {2, 3, 7}) {
      omp_set_num_threads(threads);
      EXPECT_TRUE(sameBytes(vote(exemplar_, segment_, nnf_, sigmaPx), one)) << threads;
    }
  }
  omp_set_num_threads(defaultThreads);
}

TEST_F(TallVote, DoesNotDependOnWhereItsBandsAreCut) {
  // Without its first rows the picture is cut elsewhere
  const Image<FixedLab> whole = vote(exemplar_, segment_, nnf_, 0.5F);
  for (const int above : {1, 5, 16, 31}) {
    const Size size{size_.width, size_.height - above};
    Image<Segment> segment(size);
    NearestNeighborField nnf(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        segment(x, y) = segment_(x, y + above);
        nnf(x, y) = nnf_(x, y + above);
      }
    }
    const Image<FixedLab> part = vote(exemplar_, segment, nnf, 0.5F);
    for (int y = kPatchRadius; y < size.height; ++y) {
      ASSERT_EQ(std::memcmp(part.row(y), whole.row(y + above),
                            static_cast<std::size_t>(size.width) * sizeof(FixedLab)),
                0)
          << "row " << y << " below " << above;
    }
  }
}

TEST(Vote, AMatchOutsideTheExemplarStandsForTheNearestPlaceInside) {
  const ExemplarLevel exemplar = oneFrame(test::randomTexture({12, 10}, 8));
  const Image<Segment> segment(Size{5, 5}, Segment::kBorder);
  const auto voted = [&](float x, float y) {
    NearestNeighborField nnf(segment.size());
    nnf(2, 2) = {x, y, 0, {0.6F, 0.8F}};
    return vote(exemplar, segment, nnf, 0.0F);
  };
  const float right = std::nextafter(11.5F, 0.0F);
  const float bottom = std::nextafter(9.5F, 0.0F);
  EXPECT_TRUE(sameBytes(voted(-7.25F, 4.0F), voted(-0.5F, 4.0F)));
  EXPECT_TRUE(sameBytes(voted(1e6F, 4.0F), voted(right, 4.0F)));
  EXPECT_TRUE(sameBytes(voted(3.0F, -100.0F), voted(3.0F, -0.5F)));
  EXPECT_TRUE(sameBytes(voted(3.0F, 9.5F), voted(3.0F, bottom)));
  EXPECT_TRUE(sameBytes(voted(-1.0F, 20.0F), voted(-0.5F, bottom)));
  EXPECT_FALSE(sameBytes(voted(-1.0F, 20.0F), voted(0.5F, bottom)));
}

}  // namespace
}  // namespace fluidymation
