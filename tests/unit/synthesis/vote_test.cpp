#include "fluidymation/synthesis/vote.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/sampling.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

ExemplarLevel oneFrame(const Image<Lab>& color) {
  ExemplarLevel level(color.size(), 1, 5.0F);
  const test::GrowingDisc all{color.size(), {0.0F, 0.0F}, 1000.0F, 0.0F, 1};
  level.setColor(0, color);
  level.setGuides(0, finestLevel(all.guides(0)));
  level.finish();
  return level;
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
  const VotedPicture picture = vote(exemplar, Image<Segment>(color.size(), Segment::kBorder), nnf);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 20; ++x) EXPECT_NEAR(picture.color(x, y).l, color(x, y).l, 1e-4F);
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
  const VotedPicture picture = vote(exemplar, Image<Segment>(color.size(), Segment::kBorder), nnf);
  for (int y = 2; y < 14; ++y) {
    for (int x = 2; x < 14; ++x) EXPECT_NEAR(picture.color(x, y).l, color(y, 15 - x).l, 1e-3F);
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

TEST(PaintedVote, WithTheThesisOptionsIsTheVote) {
  const ExemplarLevel exemplar = oneFrame(test::randomTexture({20, 16}, 3));
  const Image<Segment> segment(Size{14, 12}, Segment::kBorder);
  const NearestNeighborField nnf = scattered(segment.size(), exemplar.size());
  const VotedPicture plain = vote(exemplar, segment, nnf);
  const VotedPicture painted =
      paintedVote(exemplar, Mask(nnf.size(), 1), nnf, VoteOptions{0.0F, {}});
  EXPECT_EQ(
      std::memcmp(plain.color.data(), painted.color.data(), plain.color.pixelCount() * sizeof(Lab)),
      0);
}

TEST(PaintedVote, ANarrowWeightLeavesEachPixelItsOwnMatch) {
  const ExemplarLevel exemplar = oneFrame(test::randomTexture({20, 16}, 3));
  const NearestNeighborField nnf = scattered({14, 12}, exemplar.size());
  for (const Interpolation interpolation :
       {Interpolation::kBilinear, Interpolation::kCubic, Interpolation::kLanczos}) {
    const VotedPicture picture =
        paintedVote(exemplar, Mask(nnf.size(), 1), nnf, {0.05F, interpolation});
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 14; ++x) {
        const float own = exemplar.pixel(nnf(x, y).nearestX(), nnf(x, y).nearestY(), 0)[kLightness];
        EXPECT_NEAR(picture.color(x, y).l, own, 1e-3F);
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
    const VotedPicture picture =
        paintedVote(exemplar, Mask(nnf.size(), 1), nnf, {sigmaPx, Interpolation::kCubic});
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 14; ++x) {
        const bool reached = x < 7 + kPatchRadius;
        EXPECT_EQ(picture.exists(x, y) != 0, reached) << x << ", sigma " << sigmaPx;
        EXPECT_NEAR(picture.color(x, y).l, reached ? paint.l : 0.0F, 1e-2F);
        EXPECT_NEAR(picture.color(x, y).b, reached ? paint.b : 0.0F, 1e-2F);
      }
    }
  }
}

TEST(PaintedVote, AWiderWeightLiesBetween) {
  const ExemplarLevel exemplar = oneFrame(test::randomTexture({20, 16}, 3));
  const NearestNeighborField nnf = scattered({14, 12}, exemplar.size());
  const auto spread = [&](float sigmaPx) {
    const Image<Lab> color =
        paintedVote(exemplar, Mask(nnf.size(), 1), nnf, {sigmaPx, Interpolation::kBilinear}).color;
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

TEST(CubicSampling, ReproducesQuadraticsAndPassesThroughThePixels) {
  const Size size{12, 10};
  std::vector<Lanes> frame;
  const auto value = [](float x, float y) { return 0.3F * x * x - 0.2F * x * y + y - 2.0F; };
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Lanes lanes;
      lanes.low = Float4{value(static_cast<float>(x), static_cast<float>(y)), 0, 0, 0};
      frame.push_back(lanes);
    }
  }
  for (const auto& [x, y] : {std::pair{1.0F, 1.0F}, {3.25F, 4.5F}, {9.9F, 7.75F}, {5.0F, 2.5F}}) {
    EXPECT_NEAR(sampleCubic(frame.data(), size, x, y)[0], value(x, y), 1e-4F) << x << ", " << y;
  }
  // Past the image the edge repeats
  EXPECT_EQ(sampleCubic(frame.data(), size, -3.0F, -3.0F)[0],
            sampleCubic(frame.data(), size, 0.0F, 0.0F)[0]);
}

constexpr float kPi = 3.14159265F;

/// A row of pixels of a wave with this many periods per px.
std::vector<Lanes> wave(int width, float frequency) {
  std::vector<Lanes> pixels(static_cast<std::size_t>(width));
  for (std::size_t x = 0; x < pixels.size(); ++x) {
    pixels[x].low[0] = std::cos(2.0F * kPi * frequency * static_cast<float>(x));
  }
  return pixels;
}

/// Largest error between the pixels of a row, away from its ends.
template <typename Sample>
float errorOn(float frequency, const Sample& sample) {
  const Size size{64, 1};
  const std::vector<Lanes> pixels = wave(size.width, frequency);
  float worst = 0.0F;
  for (float x = 20.0F; x < 44.0F; x += 0.125F) {
    const float truth = std::cos(2.0F * kPi * frequency * x);
    worst = std::max(worst, std::abs(sample(pixels.data(), size, x)[0] - truth));
  }
  return worst;
}

TEST(LanczosSampling, KeepsFineDetailBetterThanCubic) {
  const LanczosKernel kernel;
  const auto lanczos = [&](const Lanes* frame, Size size, float x) {
    return sampleLanczos(kernel, frame, size, x, 0.0F);
  };
  const auto cubic = [](const Lanes* frame, Size size, float x) {
    return sampleCubic(frame, size, x, 0.0F);
  };
  for (const float frequency : {0.2F, 0.25F, 0.3F, 0.35F}) {
    EXPECT_LT(errorOn(frequency, lanczos), 0.7F * errorOn(frequency, cubic)) << frequency;
  }
  EXPECT_LT(errorOn(0.25F, lanczos), 0.06F);
  EXPECT_LT(errorOn(0.0F, lanczos), 1e-6F);
}

TEST(LanczosSampling, PassesThroughThePixelsAndRepeatsTheEdge) {
  const LanczosKernel kernel;
  const Size size{12, 10};
  const Image<Lab> texture = test::randomTexture(size, 5);
  const ExemplarLevel exemplar = oneFrame(texture.clone());
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      EXPECT_NEAR(sampleLanczos(kernel, exemplar.frame(0), size, static_cast<float>(x),
                                static_cast<float>(y))[0],
                  texture(x, y).l, 1e-4F);
    }
  }
  EXPECT_EQ(sampleLanczos(kernel, exemplar.frame(0), size, -3.0F, 20.0F)[0],
            sampleLanczos(kernel, exemplar.frame(0), size, 0.0F, 9.0F)[0]);
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
  const VotedPicture picture = vote(exemplar, Image<Segment>(nnf.size(), Segment::kBorder), nnf);
  for (const Lab& lab : picture.color) {
    EXPECT_NEAR(lab.l, 40.0F, 1e-3F);
    EXPECT_NEAR(lab.a, 5.0F, 1e-3F);
    EXPECT_NEAR(lab.b, -7.0F, 1e-3F);
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
  const VotedPicture picture = vote(exemplar, Image<Segment>(nnf.size(), Segment::kBorder), nnf);
  for (const Lab& lab : picture.color) {
    EXPECT_GE(lab.l, low->l - 1e-3F);
    EXPECT_LE(lab.l, high->l + 1e-3F);
  }
}

TEST(Vote, PixelsThatNoWindowCoversDoNotExist) {
  const ExemplarLevel exemplar = oneFrame(Image<Lab>(Size{12, 12}));
  NearestNeighborField nnf(Size{12, 1});
  nnf(0, 0) = {5.0F, 5.0F, 0, Rotation{}};
  Image<Segment> inside(Size{12, 1}, Segment::kBorder);
  inside(1, 0) = Segment::kOutside;
  const VotedPicture picture = vote(exemplar, inside, nnf);
  EXPECT_EQ(picture.exists(0, 0), 1);
  EXPECT_EQ(picture.exists(1, 0), 0);  // covered, but outside the mask
  EXPECT_EQ(picture.exists(2, 0), 1);
  EXPECT_EQ(picture.exists(3, 0), 0);
}

}  // namespace
}  // namespace fluidymation
