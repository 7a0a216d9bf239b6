#include "fluidymation/synthesis/painted_vote.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/target_level.h"
#include "fluidymation/synthesis/vote.h"
#include "one_frame_exemplar.h"
#include "support/synthetic_scene.h"
#include "synthesis/seam_blend.h"
#include "vote_tolerance.h"

namespace fluidymation {
namespace {

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
