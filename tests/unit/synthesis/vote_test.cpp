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
#include "fluidymation/synthesis/target_level.h"
#include "one_frame_exemplar.h"
#include "support/fixed_point.h"
#include "support/synthetic_scene.h"
#include "synthesis/seam_blend.h"

namespace fluidymation {
namespace {

void expectSame(FixedLab actual, FixedLab expected) {
  EXPECT_EQ(actual.l, expected.l);
  EXPECT_EQ(actual.a, expected.a);
  EXPECT_EQ(actual.b, expected.b);
  EXPECT_EQ(actual.weight, expected.weight);
}

/// How far a mean in fixed point lies from the exact one, units of CIELAB, at most: each sample by
/// the error of its interpolation, and the mean is rounded to the nearest step once more; its
/// division in single precision may turn a tie. No two colours of `randomTexture` are farther apart
/// than 40.
constexpr double kTextureRange = 40.0 * kColorSteps;
constexpr double kVoteTolerance =
    (test::interpolationError(kTextureRange) + 0.5 + 0x1p-8) / kColorSteps;

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

/// A field of matches that agree on nothing.
NearestNeighborField scattered(Size size, Size exemplar) {
  NearestNeighborField nnf(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Random random({5, 0, 0, 0, x, y});
      const float angle = 0.1F * static_cast<float>(random.uniform(0, 62));
      nnf(x, y) = {static_cast<float>(random.uniform(4, exemplar.width - 5)),
                   static_cast<float>(random.uniform(4, exemplar.height - 5)),
                   0,
                   {std::cos(angle), std::sin(angle)}};
    }
  }
  return nnf;
}

/// Windows weighted by nothing but their distance, and seams left as they are.
VoteOptions plainVote(float sigmaPx, Interpolation interpolation) {
  return {sigmaPx, interpolation, 0.0F, 0.0F};
}

TEST(PaintedVote, WithTheThesisOptionsIsTheVoteToItsFixedPoint) {
  const ExemplarLevel exemplar = oneFrame(test::randomTexture({20, 16}, 3));
  const Image<Segment> segment(Size{14, 12}, Segment::kBorder);
  const NearestNeighborField nnf = scattered(segment.size(), exemplar.size());
  const Image<FixedLab> plain = vote(exemplar, segment, nnf, 0.0F);
  const Image<Lab> painted = paintedVote(exemplar, Mask(nnf.size(), 1), nnf, plainVote(0.0F, {}));
  for (std::size_t i = 0; i < plain.pixelCount(); ++i) {
    ASSERT_TRUE(plain.data()[i].exists());
    const Lab voted = plain.data()[i].lab();
    const Lab mean = painted.data()[i];
    EXPECT_NEAR(voted.l, mean.l, kVoteTolerance);
    EXPECT_NEAR(voted.a, mean.a, kVoteTolerance);
    EXPECT_NEAR(voted.b, mean.b, kVoteTolerance);
  }
}

TEST(PaintedVote, ANarrowWeightLeavesEachPixelItsOwnMatch) {
  const ExemplarLevel exemplar = oneFrame(test::randomTexture({20, 16}, 3));
  const NearestNeighborField nnf = scattered({14, 12}, exemplar.size());
  for (const Interpolation interpolation :
       {Interpolation::kBilinear, Interpolation::kCubic, Interpolation::kLanczos}) {
    const Image<Lab> picture =
        paintedVote(exemplar, Mask(nnf.size(), 1), nnf, plainVote(0.05F, interpolation));
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 14; ++x) {
        const float own =
            test::channelAt(exemplar, nnf(x, y).nearestX(), nnf(x, y).nearestY(), 0, kLightness);
        EXPECT_NEAR(picture(x, y).l, own, 1e-3F);
      }
    }
  }
}

TEST(PaintedVote, PixelsNextToTheMaskAreSeenByTheWindowsOfTheirNeighbours) {
  // Half of the pixels have a match; the others get a colour as far as windows reach, also where a
  // narrow Gaussian leaves those no weight
  const Lab paint{40.0F, 20.0F, -10.0F};
  const ExemplarLevel exemplar = oneFrame(Image<Lab>({20, 16}, paint));
  NearestNeighborField nnf(Size{14, 12});
  const NearestNeighborField all = scattered(nnf.size(), exemplar.size());
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 7; ++x) nnf(x, y) = all(x, y);
  }
  for (const float sigmaPx : {0.0F, 0.01F, 0.1F, 0.5F, 2.0F}) {
    const Image<Lab> picture =
        paintedVote(exemplar, Mask(nnf.size(), 1), nnf, plainVote(sigmaPx, Interpolation::kCubic));
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 14; ++x) {
        const bool reached = x < 7 + kPatchRadius;
        EXPECT_NEAR(picture(x, y).l, reached ? paint.l : 0.0F, 1e-2F) << x << ", " << sigmaPx;
        EXPECT_NEAR(picture(x, y).b, reached ? paint.b : 0.0F, 1e-2F);
      }
    }
  }
}

TEST(PaintedVote, AWindowThatHasThePixelAtAnotherDepthIsNotTrusted) {
  const test::GrowingDisc disc{Size{48, 40}, {24.0F, 20.0F}, 16.0F, 0.0F, 1};
  constexpr float kBorderPx = 10.0F;
  const Exemplar exemplar = test::discExemplar(disc, 0, kBorderPx, 1);
  const TargetLevel target(finestLevel(disc.guides(0)), kBorderPx);
  NearestNeighborField nnf(disc.size);
  for (int y = 0; y < nnf.height(); ++y) {
    for (int x = 0; x < nnf.width(); ++x) {
      if (!target.inside(x, y)) continue;
      nnf(x, y) = {static_cast<float>(x), static_cast<float>(y), 0, Rotation{}};
    }
  }
  nnf(24, 10) = {24.0F, 5.0F, 0, Rotation{}};  // 6 px deep, and painted from the rim
  const auto painted = [&](float depthSigmaPx, float seamWeight = 0.0F) {
    const VoteOptions options{0.05F, Interpolation::kBilinear, depthSigmaPx, seamWeight};
    return paintedVote(exemplar.level(0), Mask(nnf.size(), 1), nnf, options, &target.guides);
  };
  const auto colorAt = [&](int x, int y) {
    return test::channelAt(exemplar.level(0), x, y, 0, kLightness);
  };
  ASSERT_GT(std::abs(colorAt(24, 5) - colorAt(24, 10)), 1.0F);
  EXPECT_NEAR(painted(0.0F)(24, 10).l, colorAt(24, 5), 1e-2F);
  EXPECT_NEAR(painted(0.5F)(24, 10).l, colorAt(24, 10), 1e-2F);
  EXPECT_NEAR(painted(0.5F)(20, 12).l, colorAt(20, 12), 1e-2F);
  // Nor are its steps, however large
  EXPECT_NEAR(painted(0.5F, 1.0F)(24, 10).l, colorAt(24, 10), 0.1F);
  EXPECT_NEAR(painted(0.5F, 1.0F)(23, 10).l, colorAt(23, 10), 0.1F);
  EXPECT_GT(std::abs(painted(0.0F, 1.0F)(23, 10).l - colorAt(23, 10)), 0.2F);
}

TEST(PaintedVote, AWiderWeightLiesBetween) {
  const ExemplarLevel exemplar = oneFrame(test::randomTexture({20, 16}, 3));
  const NearestNeighborField nnf = scattered({14, 12}, exemplar.size());
  const auto spread = [&](float sigmaPx) {
    const Image<Lab> color = paintedVote(exemplar, Mask(nnf.size(), 1), nnf,
                                         plainVote(sigmaPx, Interpolation::kBilinear));
    double sum = 0.0;
    double squares = 0.0;
    for (const Lab& c : color) {
      sum += c.l;
      squares += c.l * c.l;
    }
    const auto count = static_cast<double>(color.pixelCount());
    return squares / count - sum / count * (sum / count);
  };
  // What does not agree is averaged away, the more the more windows count
  EXPECT_GT(spread(0.4F), 1.2 * spread(0.8F));
  EXPECT_GT(spread(0.8F), 1.2 * spread(0.0F));
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

/// Two pieces of an exemplar that meet in the middle: one is `lighter` than the other, both have
/// the same texture.
class Seam : public ::testing::Test {
 protected:
  Seam() {
    const Image<Lab> texture = test::randomTexture({20, 16}, 3);
    Image<Lab> color({40, 16});
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 40; ++x) {
        color(x, y) = texture(x % 20, y);
        if (x >= 20) color(x, y).l += kLighter;
      }
    }
    exemplar_ = oneFrame(color);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 20; ++x) {
        nnf_(x, y) = {static_cast<float>(x < 10 ? x : x + 20), static_cast<float>(y), 0, {}};
      }
    }
  }

  [[nodiscard]] Image<Lab> painted(float seamWeight) const {
    return paintedVote(exemplar_, Mask(nnf_.size(), 1), nnf_,
                       {0.05F, Interpolation::kBilinear, 0.0F, seamWeight});
  }

  static constexpr float kLighter = 10.0F;
  ExemplarLevel exemplar_ = oneFrame(Image<Lab>(Size{1, 1}));
  NearestNeighborField nnf_{Size{20, 16}};
};

TEST_F(Seam, BecomesASlopeThatKeepsTheTexture) {
  const Image<Lab> asSeam = painted(0.0F);
  for (const float weight : {0.3F, 1.0F, 4.0F}) {
    const Image<Lab> blended = painted(weight);
    // Along an axis across the seam the changes are geometric series on either side
    const double kept = 1.0 + 0.5 / weight - std::sqrt(0.25 / (weight * weight) + 1.0 / weight);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 20; ++x) {
        const double side = x < 10 ? 1.0 : -1.0;
        const int fromSeam = x < 10 ? 9 - x : x - 10;
        const double atSeam = 0.5 * kLighter * (1.0 - (1.0 - kept) / (1.0 + kept));
        const double change = side * atSeam * std::pow(kept, fromSeam);
        // The picture's sides cut the series off, and the solver stops
        EXPECT_NEAR(blended(x, y).l - asSeam(x, y).l, change, 0.02 * kLighter)
            << x << ", " << y << ", " << weight;
      }
    }
  }
}

TEST_F(Seam, WithinAPieceNothingChanges) {
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 20; ++x) {
      nnf_(x, y) = {static_cast<float>(x) + 3.25F, static_cast<float>(y), 0, {}};
    }
  }
  const Image<Lab> asSeam = painted(0.0F);
  const Image<Lab> blended = painted(1.0F);
  EXPECT_EQ(std::memcmp(asSeam.data(), blended.data(), asSeam.pixelCount() * sizeof(Lab)), 0);
}

TEST_F(Seam, PixelsWithoutAMatchGoAlongWithTheirNeighbours) {
  // As those of a soft outline, which the windows beside them paint
  for (int y = 0; y < 16; ++y) nnf_(9, y) = Match{};
  const Image<Lab> asSeam = painted(0.0F);
  const Image<Lab> blended = painted(1.0F);
  for (int y = 0; y < 16; ++y) {
    EXPECT_EQ(blended(9, y).l, asSeam(9, y).l) << "no step is known to be wrong";
  }
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 20; ++x) {
      nnf_(x, y) = {static_cast<float>(x < 10 ? x : x + 20), static_cast<float>(y), 0, {}};
      if (x > 11) nnf_(x, y) = Match{};
    }
  }
  const Image<Lab> rim = painted(0.0F);
  const Image<Lab> blendedRim = painted(1.0F);
  const float atSeam = blendedRim(11, 8).l - rim(11, 8).l;
  const float beyond = blendedRim(12, 8).l - rim(12, 8).l;
  EXPECT_LT(atSeam, -0.5F);
  EXPECT_LT(beyond, 0.3F * atSeam);
  EXPECT_GT(beyond, 1.1F * atSeam);
}

/// Matches that agree on nothing, and a picture with a hole.
class ScatteredSeams : public ::testing::Test {
 protected:
  using Color = std::array<double, kColorChannels>;

  ScatteredSeams() {
    for (int y = 4; y < 7; ++y) {
      for (int x = 5; x < 9; ++x) wanted_(x, y) = 0;
    }
  }

  [[nodiscard]] Image<Lab> painted(float seamWeight) const {
    return paintedVote(exemplar_, wanted_, nnf_,
                       {0.05F, Interpolation::kBilinear, 0.0F, seamWeight});
  }

  /// What the window at `centre` shows at `pixel`.
  [[nodiscard]] Color shown(Pixel centre, Pixel pixel) const {
    const Match& match = nnf_(centre.x, centre.y);
    const double dx = pixel.x - centre.x;
    const double dy = pixel.y - centre.y;
    const double c = match.rotation.cosine;
    const double s = match.rotation.sine;
    Color color{};
    for (const Channel channel : {kLightness, kGreenRed, kBlueYellow}) {
      color[static_cast<std::size_t>(channel)] = test::slowSample(
          exemplar_, 0, match.x + c * dx + s * dy, match.y + c * dy - s * dx, channel);
    }
    return color;
  }

  /// By definition: the larger of both windows' steps, less the one that is there.
  [[nodiscard]] Float4 wantedStep(Pixel from, Pixel to) const {
    if (wanted_(from.x, from.y) == 0 || wanted_(to.x, to.y) == 0) return Float4{};
    Color inOwn{};
    Color inOther{};
    double ofOwn = 0.0;
    double ofOther = 0.0;
    for (std::size_t c = 0; c < kColorChannels; ++c) {
      inOwn[c] = shown(from, to)[c] - shown(from, from)[c];
      inOther[c] = shown(to, to)[c] - shown(to, from)[c];
      ofOwn += inOwn[c] * inOwn[c];
      ofOther += inOther[c] * inOther[c];
    }
    Float4 step{0.0F, 0.0F, 0.0F, 1.0F};
    for (std::size_t c = 0; c < kColorChannels; ++c) {
      const double there = shown(to, to)[c] - shown(from, from)[c];
      step[c] = static_cast<float>((ofOwn >= ofOther ? inOwn[c] : inOther[c]) - there);
    }
    return step;
  }

  ExemplarLevel exemplar_ = oneFrame(test::randomTexture({20, 16}, 3));
  NearestNeighborField nnf_ = scattered({14, 12}, {20, 16});
  Mask wanted_{Size{14, 12}, 1};
};

TEST_F(ScatteredSeams, AreBlendedTowardsTheLargerOfBothWindowsSteps) {
  const Size size = nnf_.size();
  WantedSteps steps(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (x + 1 < size.width) steps.right(x, y) = wantedStep({x, y}, {x + 1, y});
      if (y + 1 < size.height) steps.down(x, y) = wantedStep({x, y}, {x, y + 1});
    }
  }
  const Image<Float4> changes = seamChanges(steps, 1.0F);
  const Image<Lab> before = painted(0.0F);
  const Image<Lab> after = painted(1.0F);
  double largest = 0.0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Float4 change = wanted_(x, y) != 0 ? changes(x, y) : Float4{};
      largest = std::max(largest, std::abs(static_cast<double>(change[0])));
      EXPECT_NEAR(after(x, y).l - before(x, y).l, change[0], 0.05F) << x << ", " << y;
      EXPECT_NEAR(after(x, y).a - before(x, y).a, change[1], 0.05F);
      EXPECT_NEAR(after(x, y).b - before(x, y).b, change[2], 0.05F);
    }
  }
  EXPECT_GT(largest, 3.0);
}

TEST_F(ScatteredSeams, AreBlendedAlikeByAnyNumberOfThreads) {
  const int defaultThreads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Image<Lab> one = painted(1.0F);
  for (const int threads : {2, 3, 7}) {
    omp_set_num_threads(threads);
    const Image<Lab> many = painted(1.0F);
    EXPECT_EQ(std::memcmp(one.data(), many.data(), one.pixelCount() * sizeof(Lab)), 0) << threads;
  }
  omp_set_num_threads(defaultThreads);
}

}  // namespace
}  // namespace fluidymation
