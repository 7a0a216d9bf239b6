#include "fluidymation/synthesis/depth_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/previous_picture.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderPx = 8.0F;

/// Lightness of a medium that gets darker by `perPx` up to the border width, and grain on it.
Image<Lab> darkeningInwards(const GuideFrame& guides, float perPx, float grain = 0.0F) {
  Image<Lab> picture(guides.mask.size());
  const Image<Lab> texture = test::randomTexture(picture.size(), 5);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const float speck = grain * (texture(x, y).l - 50.0F) / 20.0F;
      const float depth = std::min(guides.distance(x, y), kBorderPx);
      picture(x, y) = {90.0F - perPx * depth + speck, 2.0F * depth, 0.0F};
    }
  }
  return picture;
}

/// A film of a growing disc; frame k gets darker by `perPx(k)`.
template <typename PerPx>
Exemplar filmOf(const test::GrowingDisc& disc, int coarsest, const PerPx& perPx,
                float grain = 0.0F) {
  Exemplar film(disc.size, disc.frameCount, coarsest, kBorderPx);
  for (int k = 0; k < disc.frameCount; ++k) {
    const GuideFrame guides = disc.guides(k);
    film.setColor(k, darkeningInwards(guides, perPx(k), grain));
    film.setGuides(k, guides);
  }
  film.finish();
  return film;
}

/// The edge guide at a depth, as it is kept.
int edgeAt(float depthPx) { return toFixed(edgeChannel(depthPx, kBorderPx), kEdgeSteps); }

class DepthColorsTest : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{72, 64}, {36.0F, 32.0F}, 14.0F, 1.0F, 12};
};

TEST_F(DepthColorsTest, TellTheProfileOfTheFilm) {
  const Exemplar film = filmOf(disc_, 0, [](int) { return 5.0F; });
  const DepthColors colors(film.level(0));
  for (int k = 0; k < disc_.frameCount; ++k) {
    EXPECT_NEAR(colors.change(k, edgeAt(2.0F), edgeAt(6.0F)).l, -20.0F, 1.5F) << k;
    EXPECT_NEAR(colors.change(k, edgeAt(6.0F), edgeAt(3.0F)).l, 15.0F, 1.5F) << k;
    EXPECT_NEAR(colors.change(k, edgeAt(2.0F), edgeAt(6.0F)).a, 8.0F, 0.6F) << k;
    EXPECT_EQ(colors.change(k, edgeAt(2.0F), edgeAt(6.0F)).b, 0.0F) << k;
  }
}

/// Against means over every pixel of the medium, where frames are alike and there is no grain, so
/// that averaging over frames and near distances changes nothing.
TEST_F(DepthColorsTest, AreMeansOverAllPixelsOfADistance) {
  const test::GrowingDisc still{disc_.size, disc_.centre, 18.0F, 0.0F, 3};
  const Exemplar film = filmOf(
      still, 0, [](int) { return 5.0F; }, 12.0F);
  const ExemplarLevel& level = film.level(0);
  const DepthColors colors(level);
  const auto meanAt = [&](float fromPx, float toPx) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < still.size.height; ++y) {
      for (int x = 0; x < still.size.width; ++x) {
        const int edge = level.texel(x, y, 1).guides.edge;
        if (level.segment(x, y, 1) == Segment::kOutside || edge < edgeAt(fromPx)) continue;
        if (edge > edgeAt(toPx)) continue;
        sum += static_cast<double>(level.texel(x, y, 1).color.lab().l);
        ++count;
      }
    }
    return sum / count;
  };
  const double interior = meanAt(kBorderPx, kBorderPx);
  for (const float depth : {2.0F, 3.5F, 5.0F, 6.5F}) {
    const double there = meanAt(depth - 0.75F, depth + 0.75F);
    EXPECT_NEAR(colors.change(1, edgeAt(depth), edgeAt(kBorderPx)).l, interior - there, 1.0);
  }
  for (const int deeper : {edgeAt(kBorderPx), 30000}) {
    EXPECT_EQ(colors.change(1, edgeAt(kBorderPx), deeper).l, 0.0F) << "deep inside all is alike";
  }
}

/// A strong colour outside, which must not show, however wide the border and whatever tells depths.
TEST_F(DepthColorsTest, TheSurfaceDoesNotCount) {
  for (const float borderPx : {0.1F, 8.0F, 100.0F, 10000.0F}) {
    for (const ShapeGuide guide : {ShapeGuide::kEdgeDistance, ShapeGuide::kBlurredMask}) {
      ShapeRules rules;
      rules.guide = guide;
      Exemplar film(disc_.size, disc_.frameCount, 1, borderPx, rules);
      for (int k = 0; k < disc_.frameCount; ++k) {
        GuideFrame guides = disc_.guides(k);
        Image<Lab> picture(disc_.size, Lab{20.0F, 100.0F, -100.0F});
        guides.shape = Image<float>(disc_.size);
        for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
          if (guides.mask.data()[i] == 0) continue;
          picture.data()[i] = {70.0F, 0.0F, 0.0F};
          guides.shape.data()[i] = std::min(0.5F + 0.05F * guides.distance.data()[i], 1.0F);
        }
        film.setColor(k, picture);
        film.setGuides(k, guides);
      }
      film.finish();
      const DepthColors colors(film.level(0));
      for (int edge = -20000; edge < 20000; edge += 97) {
        const Lab change = colors.change(5, edge, edgeAt(kBorderPx));
        ASSERT_EQ(change.l, 0.0F) << borderPx << " px, edge " << edge;
        ASSERT_EQ(change.a, 0.0F);
      }
    }
  }
}

TEST_F(DepthColorsTest, FramesHaveProfilesOfTheirOwn) {
  const Exemplar film = filmOf(disc_, 0, [](int k) { return k < 6 ? 2.0F : 6.0F; });
  const DepthColors colors(film.level(0));
  EXPECT_NEAR(colors.change(1, edgeAt(2.0F), edgeAt(6.0F)).l, -8.0F, 2.0F);
  EXPECT_NEAR(colors.change(11, edgeAt(2.0F), edgeAt(6.0F)).l, -24.0F, 3.0F);
}

/// Of a level of few pixels, where most distances have none.
TEST_F(DepthColorsTest, DistancesWithoutPixelsHaveTheColoursOfTheirNeighbours) {
  const Exemplar film = filmOf(disc_, 3, [](int) { return 5.0F; });
  for (int l = 0; l < film.levelCount(); ++l) {
    const DepthColors colors(film.level(l));
    for (int k = 0; k < disc_.frameCount; ++k) {
      for (int edge = edgeAt(-3.0F); edge <= edgeAt(kBorderPx); edge += 3) {
        const float change = colors.change(k, edge, edgeAt(kBorderPx)).l;
        ASSERT_TRUE(std::isfinite(change));
        ASSERT_LT(std::abs(change), 60.0F) << "level " << l << " frame " << k << " edge " << edge;
      }
    }
  }
}

TEST_F(DepthColorsTest, AFilmWithoutMediumChangesNothing) {
  Exemplar film(disc_.size, 2, 1, kBorderPx);
  for (int k = 0; k < 2; ++k) {
    GuideFrame guides = disc_.guides(k);
    guides.mask = Mask(disc_.size);
    guides.distance = Image<float>(disc_.size, -136.0F);  // as a distance field says it
    film.setColor(k, test::randomTexture(disc_.size, 3));
    film.setGuides(k, guides);
  }
  film.finish();
  for (int l = 0; l < film.levelCount(); ++l) {
    const DepthColors colors(film.level(l));
    EXPECT_EQ(colors.change(0, edgeAt(1.0F), edgeAt(5.0F)).l, 0.0F);
    EXPECT_EQ(colors.deviations(0, edgeAt(5.0F), {3.0F, 4.0F, 0.0F}), 5.0F)
        << "of 1 dE, from black";
  }
}

/// What a frame remembers of the one before where a target moves by `speedPx` a frame: at a pixel
/// whose match was rim and that lies inside now, and at one that always lay inside.
TargetLevel remembering(const Exemplar& film, float speedPx, const PreviousRules& rules) {
  const test::GrowingDisc disc{Size{72, 64}, {36.0F, 32.0F}, 20.0F, speedPx, 1};
  NearestNeighborField field(disc.size);
  // In frame 6 the film's disc has a radius of 20 px: these lie 2 and 12 px deep there
  field(36 + 10, 32) = {36.0F + 18.0F, 32.0F, 6, Rotation{}};
  field(36 - 8, 32) = {36.0F - 8.0F, 32.0F, 6, Rotation{}};
  TargetLevel target(finestLevel(disc.guides(0)), kBorderPx);
  setPrevious(film.level(0), kBorderPx, rules, field, target);
  return target;
}

TEST_F(DepthColorsTest, ThePreviousPictureFollowsTheDepthAsFarAsTheTargetMoves) {
  const Exemplar film = filmOf(disc_, 0, [](int) { return 5.0F; });
  const DepthColors colors(film.level(0));
  const PreviousRules asItIs{{8.0F, 2.0F}};
  PreviousRules once = asItIs;
  once.filmColors = &colors;
  once.deepening = 1.0F;
  const auto lightness = [](const TargetLevel& level, int x) {
    return level.previous(x, 32).lab().l;
  };
  const TargetLevel kept = remembering(film, kBorderPx, asItIs);
  EXPECT_NEAR(lightness(kept, 46), 80.0F, 1.0F);
  EXPECT_EQ(lightness(remembering(film, 0.0F, once), 46), lightness(kept, 46)) << "at rest";
  EXPECT_NEAR(lightness(remembering(film, kBorderPx / 2, once), 46), 65.0F, 1.5F);
  for (const float speedPx : {kBorderPx, 3.0F * kBorderPx}) {
    const TargetLevel deepened = remembering(film, speedPx, once);
    EXPECT_NEAR(lightness(deepened, 46), 50.0F, 2.0F) << "10 px deep now: dark as the interior";
    EXPECT_EQ(lightness(deepened, 28), lightness(kept, 28)) << "interior before and after";
    EXPECT_EQ(deepened.modulation(46, 32), kept.modulation(46, 32));
  }
}

/// Two standard deviations count in full, and nothing is deepened.
PreviousRules doubtingRules(const DepthColors& colors) {
  PreviousRules rules{{8.0F, 2.0F}};
  rules.filmColors = &colors;
  rules.outlierSigmas = 2.0F;
  return rules;
}

TEST_F(DepthColorsTest, AColourThatTheFilmHardlyHasCountsLessWhereTheTargetMoves) {
  const Exemplar film = filmOf(
      disc_, 0, [](int) { return 5.0F; }, 8.0F);
  const DepthColors colors(film.level(0));
  const PreviousRules trusting{{8.0F, 2.0F}};
  const PreviousRules doubting = doubtingRules(colors);
  const auto modulation = [](const TargetLevel& level, int x) { return level.modulation(x, 32); };
  const TargetLevel trusted = remembering(film, 1.0F, trusting);
  const TargetLevel doubted = remembering(film, 1.0F, doubting);
  const auto expected = [&](int x) {
    const float z = colors.deviations(6, trusted.guides(x, 32).edge, trusted.previous(x, 32).lab());
    const float beyond = std::max(z - doubting.outlierSigmas, 0.0F);
    return trusted.modulation(x, 32) * std::exp(-0.5F * beyond * beyond);
  };
  // As pale as 2 px deep, 10 px deep; and what always lay inside
  ASSERT_GT(modulation(trusted, 46), 0.1F);
  EXPECT_LT(modulation(doubted, 46), 0.2F * modulation(trusted, 46));
  EXPECT_EQ(modulation(doubted, 28), modulation(trusted, 28));
  for (const int x : {28, 46}) EXPECT_NEAR(modulation(doubted, x), expected(x), 1e-5F) << x;
  const auto shareAt = [&](float speedPx) {
    return modulation(remembering(film, speedPx, doubting), 46) /
           modulation(remembering(film, speedPx, trusting), 46);
  };
  EXPECT_EQ(shareAt(0.0F), 1.0F) << "at rest";
  for (const float speedPx : {0.01F, 0.02F}) {
    EXPECT_NEAR(shareAt(speedPx), std::pow(shareAt(0.25F), speedPx / 0.25F), 0.01F)
        << "slow movement forgets slowly";
  }
  EXPECT_GT(shareAt(0.01F), 0.2F);
  EXPECT_LT(shareAt(0.25F), 0.01F);
  EXPECT_FLOAT_EQ(shareAt(0.25F), shareAt(1.0F));
  EXPECT_EQ(doubted.previous(46, 32).l, trusted.previous(46, 32).l) << "it is not changed";
}

TEST_F(DepthColorsTest, OutliersAreWhatTheFilmHasNotAfterDeepening) {
  const Exemplar film = filmOf(
      disc_, 0, [](int) { return 5.0F; }, 8.0F);
  const DepthColors colors(film.level(0));
  PreviousRules rules = doubtingRules(colors);
  const TargetLevel doubted = remembering(film, kBorderPx, rules);
  rules.deepening = 1.0F;
  const TargetLevel deepened = remembering(film, kBorderPx, rules);
  EXPECT_GT(deepened.modulation(46, 32), 3.0F * doubted.modulation(46, 32));
}

TEST_F(DepthColorsTest, BothNeighborsAreDoubtedAlike) {
  const Exemplar film = filmOf(
      disc_, 0, [](int) { return 5.0F; }, 8.0F);
  const DepthColors colors(film.level(0));
  const PreviousRules rules = doubtingRules(colors);
  const test::GrowingDisc disc{Size{72, 64}, {36.0F, 32.0F}, 20.0F, 1.0F, 1};
  NearestNeighborField field(disc.size);
  field(46, 32) = {54.0F, 32.0F, 6, Rotation{}};
  const NearestNeighborField none(disc.size);
  TargetLevel alone(finestLevel(disc.guides(0)), kBorderPx);
  setPrevious(film.level(0), kBorderPx, rules, field, alone);
  ASSERT_GT(alone.modulation(46, 32), 0.0F);
  for (const bool isBefore : {false, true}) {
    TargetLevel between(finestLevel(disc.guides(0)), kBorderPx);
    setBothNeighbors(film.level(0), kBorderPx, rules, isBefore ? field : none,
                     isBefore ? none : field, between);
    EXPECT_EQ(between.modulation(46, 32), alone.modulation(46, 32)) << isBefore;
    EXPECT_EQ(between.previous(46, 32).l, alone.previous(46, 32).l) << isBefore;
  }
}

TEST_F(DepthColorsTest, DeviationsAreThoseOfTheFilmAtThatDepth) {
  constexpr float kGrain = 12.0F;
  const Exemplar film = filmOf(
      disc_, 0, [](int k) { return 4.0F + 0.1F * static_cast<float>(k); }, kGrain);
  const DepthColors colors(film.level(0));
  const ExemplarLevel& level = film.level(0);
  // The interior is one depth: its colours in all frames, from each frame's mean
  double squares = 0.0;
  int count = 0;
  std::vector<double> means;
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < disc_.frameCount; ++k) {
      double sum = 0.0;
      int ofFrame = 0;
      for (int y = 0; y < disc_.size.height; ++y) {
        for (int x = 0; x < disc_.size.width; ++x) {
          if (level.segment(x, y, k) == Segment::kOutside) continue;
          if (level.texel(x, y, k).guides.edge < edgeAt(kBorderPx)) continue;
          const double l = level.texel(x, y, k).color.lab().l;
          sum += l;
          ++ofFrame;
          if (pass == 0) continue;
          const double off = l - means[static_cast<std::size_t>(k)];
          squares += off * off;
          ++count;
        }
      }
      if (pass == 0) means.push_back(sum / ofFrame);
    }
  }
  const double deviation = std::sqrt(squares / count);
  ASSERT_GT(deviation, 2.0);
  for (const int k : {3, 8}) {
    const auto mean = static_cast<float>(means[static_cast<std::size_t>(k)]);
    const Lab twelveOff{mean + 12.0F, 2.0F * kBorderPx, 0.0F};
    const float z = colors.deviations(k, edgeAt(kBorderPx), twelveOff);
    // Means are those of a few frames together
    EXPECT_NEAR(z, 12.0 / deviation, 0.15 * 12.0 / deviation) << k;
  }
}

TEST_F(DepthColorsTest, AFilmWithoutGrainHasADeviationOfOne) {
  const Exemplar film = filmOf(disc_, 0, [](int) { return 0.0F; });
  const DepthColors colors(film.level(0));
  const Lab there = film.level(0).texel(36, 32, 5).color.lab();
  EXPECT_NEAR(colors.deviations(5, edgeAt(kBorderPx), there), 0.0F, 0.1F);
  EXPECT_NEAR(colors.deviations(5, edgeAt(kBorderPx), {there.l - 3.0F, there.a, there.b}), 3.0F,
              0.1F)
      << "at least 1 dE";
}

/// By how much what lies inside is lighter than in the film, in the last frame of a disc that
/// travels by twice its own width.
double palerThanTheFilm(const Exemplar& film, double filmsInterior, float deepening,
                        int depthReachFrames = 0, float outlierSigmas = 0.0F) {
  SynthesisOptions options;       // the standard look
  options.optVoteSigmaPx = 0.0F;  // narrow votes make this film fade less by themselves
  options.prevDeepening = deepening;
  options.prevDepthReachFrames = depthReachFrames;
  options.prevOutlierSigmas = outlierSigmas;
  Synthesizer synthesizer(film, options);
  double sum = 0.0;
  int count = 0;
  constexpr int kFrames = 16;
  for (int j = 0; j < kFrames; ++j) {
    const float x = 20.0F + 3.0F * static_cast<float>(j);
    const test::GrowingDisc target{Size{84, 40}, {x, 20.0F}, 12.0F, 3.0F, 1};
    const GuideFrame guides = target.guides(0);
    const Image<Lab> picture = synthesizer.paint(guides);
    if (j + 1 < kFrames) continue;
    for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
      if (guides.distance.data()[i] < kBorderPx) continue;
      sum += picture.data()[i].l;
      ++count;
    }
  }
  return sum / count - filmsInterior;
}

TEST_F(DepthColorsTest, AShapeThatTravelsKeepsItsBodyColour) {
  const Exemplar film = filmOf(
      disc_, 2, [](int) { return 6.0F; }, 30.0F);
  constexpr double kFilmsInterior = 90.0 - 6.0 * kBorderPx;
  const double kept = palerThanTheFilm(film, kFilmsInterior, 0.0F);
  const double deepened = palerThanTheFilm(film, kFilmsInterior, SynthesisOptions{}.prevDeepening);
  EXPECT_GT(kept, 8.0) << "the film is too plain to tell";
  EXPECT_LT(std::abs(deepened), 0.5 * kept);
  const double fitted =
      palerThanTheFilm(film, kFilmsInterior, 0.0F, SynthesisOptions{}.prevDepthReachFrames);
  EXPECT_LT(std::abs(fitted), 0.5 * kept) << "by the film's own frames";
  const SynthesisOptions standard;
  const double doubted =
      palerThanTheFilm(film, kFilmsInterior, 0.0F, 0, standard.prevOutlierSigmas);
  EXPECT_LT(std::abs(doubted), 0.5 * kept) << "without what the film has not";
  const double all = palerThanTheFilm(film, kFilmsInterior, standard.prevDeepening,
                                      standard.prevDepthReachFrames, standard.prevOutlierSigmas);
  EXPECT_LT(std::abs(all), 0.5 * kept);
}

}  // namespace
}  // namespace fluidymation
