#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fluidymation/synthesis/depth_colors.h"
#include "fluidymation/synthesis/previous_picture.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "support/darkening_film.h"
#include "support/synthetic_scene.h"
#include "synthesis/color_drift.h"

namespace fluidymation {
namespace {

using test::edgeAt;
using test::filmOf;
using test::kBorderPx;

/// A film whose medium gets darker inwards, and what setPrevious makes of its colours.
class RememberedColors : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{72, 64}, {36.0F, 32.0F}, 14.0F, 1.0F, 12};
};

/// What a frame remembers of the one before where a target moves by `speedPx` a frame: at a pixel
/// whose match was rim and that lies inside now, and at one that always lay inside.
TargetLevel twoRemembered(const Exemplar& film, float speedPx, const PreviousRules& rules) {
  const test::GrowingDisc disc{Size{72, 64}, {36.0F, 32.0F}, 20.0F, speedPx, 1};
  NearestNeighborField field(disc.size);
  // In frame 6 the film's disc has a radius of 20 px: these lie 2 and 12 px deep there
  field(36 + 10, 32) = {36.0F + 18.0F, 32.0F, 6, Rotation{}};
  field(36 - 8, 32) = {36.0F - 8.0F, 32.0F, 6, Rotation{}};
  TargetLevel target(finestLevel(disc.guides(0)), kBorderPx);
  setPrevious(film.level(0), kBorderPx, rules, field, target);
  return target;
}

TEST_F(RememberedColors, ThePreviousPictureFollowsTheDepthAsFarAsTheTargetMoves) {
  const Exemplar film = filmOf(disc_, 0, [](int) { return 5.0F; });
  const DepthColors colors(film.level(0));
  const PreviousRules asItIs{{8.0F, 2.0F}};
  PreviousRules once = asItIs;
  once.filmColors = &colors;
  once.deepening = 1.0F;
  const auto lightness = [](const TargetLevel& level, int x) {
    return level.previous(x, 32).lab().l;
  };
  const TargetLevel kept = twoRemembered(film, kBorderPx, asItIs);
  EXPECT_NEAR(lightness(kept, 46), 80.0F, 1.0F);
  EXPECT_EQ(lightness(twoRemembered(film, 0.0F, once), 46), lightness(kept, 46)) << "at rest";
  EXPECT_NEAR(lightness(twoRemembered(film, kBorderPx / 2, once), 46), 65.0F, 1.5F);
  for (const float speedPx : {kBorderPx, 3.0F * kBorderPx}) {
    const TargetLevel deepened = twoRemembered(film, speedPx, once);
    EXPECT_NEAR(lightness(deepened, 46), 50.0F, 2.0F) << "10 px deep now: dark as the interior";
    EXPECT_EQ(lightness(deepened, 28), lightness(kept, 28)) << "interior before and after";
    EXPECT_EQ(deepened.modulation(46, 32), kept.modulation(46, 32));
  }
}

/// A body whose every pixel is remembered as pale as the film is 2 px deep, but for the one in the
/// middle, on a border that is as in the film.
class Drifted : public RememberedColors {
 protected:
  /// @param atRest  columns to the left of this one do not move.
  [[nodiscard]] TargetLevel remembered(float speedPx, const PreviousRules& rules,
                                       int atRest = 0) const {
    const test::GrowingDisc disc{Size{72, 64}, {36.0F, 32.0F}, 20.0F, speedPx, 1};
    TargetLevel target(finestLevel(disc.guides(0)), kBorderPx);
    for (int y = 0; y < target.size().height; ++y) {
      for (int x = 0; x < atRest; ++x) target.speed(x, y) = 0.0F;
    }
    setPrevious(film_.level(0), kBorderPx, rules, field_, target);
    return target;
  }

  /// In frame 6 the film's disc is as large as the target's. Columns of odd numbers lie in frame 5,
  /// whose disc is smaller by a pixel.
  [[nodiscard]] static NearestNeighborField paleBody() {
    const test::GrowingDisc disc{Size{72, 64}, {36.0F, 32.0F}, 20.0F, 0.0F, 1};
    const GuideFrame guides = disc.guides(0);
    NearestNeighborField field(disc.size);
    for (int y = 0; y < disc.size.height; ++y) {
      for (int x = 0; x < disc.size.width; ++x) {
        if (guides.mask(x, y) == 0) continue;
        const Vec2 out{static_cast<float>(x) - 36.0F, static_cast<float>(y) - 32.0F};
        const float from = std::max(length(out), 0.5F);
        const bool inBody = guides.distance(x, y) >= kBorderPx;
        const int frame = x % 2 == 1 && inBody ? 5 : 6;
        const float at = inBody ? radiusPx(frame) - 2.0F : from;
        field(x, y) = {36.0F + out.x * at / from, 32.0F + out.y * at / from, frame, Rotation{}};
      }
    }
    return field;
  }
  [[nodiscard]] static float radiusPx(int frame) { return 14.0F + static_cast<float>(frame); }

  [[nodiscard]] PreviousRules correcting(float share) const {
    PreviousRules rules{{8.0F, 2.0F}};
    rules.filmColors = &colors_;
    rules.colorCorrection = share;
    return rules;
  }

  /// Mean and standard deviation of the body's lightness.
  [[nodiscard]] static std::pair<double, double> bodyOf(const TargetLevel& target) {
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;
    for (int y = 0; y < target.size().height; ++y) {
      for (int x = 0; x < target.size().width; ++x) {
        if (!target.inside(x, y) || target.guides(x, y).edge < edgeAt(kBorderPx)) continue;
        const double l = target.previous(x, y).lab().l;
        sum += l;
        squares += l * l;
        ++count;
      }
    }
    const double mean = sum / count;
    return {mean, std::sqrt(squares / count - mean * mean)};
  }

  /// Frame 5 is darker than frame 6.
  Exemplar film_ = filmOf(
      disc_, 0, [](int k) { return k < 6 ? 6.0F : 5.0F; }, 8.0F);
  DepthColors colors_{film_.level(0)};
  NearestNeighborField field_ = paleBody();
};

TEST_F(Drifted, ColoursComeBackAllAlikeByTheShareThatIsWanted) {
  const double wanted = 0.5 * static_cast<double>(colors_.mean(5, edgeAt(kBorderPx)).l +
                                                  colors_.mean(6, edgeAt(kBorderPx)).l);
  const auto [kept, keptSpread] = bodyOf(remembered(1.0F, correcting(0.0F)));
  ASSERT_GT(kept - wanted, 20.0) << "paler than the film's body";
  ASSERT_GT(keptSpread, 2.0) << "grain";
  for (const float share : {0.5F, 1.0F}) {
    const auto [mean, spread] = bodyOf(remembered(1.0F, correcting(share)));
    EXPECT_NEAR(mean - wanted, (1.0 - static_cast<double>(share)) * (kept - wanted), 3.0) << share;
    EXPECT_NEAR(spread, keptSpread, 0.05) << "the grain stays, " << share;
  }
}

/// Which pixels are counted, what is wanted of them, and by how much each of them changes.
TEST_F(Drifted, EveryPixelChangesByWhatItsDepthIsOff) {
  constexpr float kShare = 0.5F;
  field_(36, 30) = Match{};  // it reads the windows round it, and belongs to no frame
  for (const int atRest : {0, 30}) {
    for (const float speedPx : {0.0F, 0.0625F, 0.25F, 3.0F}) {
      const TargetLevel kept = remembered(speedPx, correcting(0.0F), atRest);
      const TargetLevel corrected = remembered(speedPx, correcting(kShare), atRest);
      ASSERT_TRUE(kept.previous(36, 30).exists());
      DriftSums sums;
      const auto forAll = [&](const auto& visit) {
        for (int y = 0; y < kept.size().height; ++y) {
          for (int x = 0; x < kept.size().width; ++x) {
            if (kept.inside(x, y)) visit(x, y, kept.guides(x, y).edge, kept.previous(x, y).lab());
          }
        }
      };
      forAll([&](int x, int y, int edge, const Lab& color) {
        if (x < atRest || !field_(x, y).exists()) return;
        const Lab film = colors_.mean(field_(x, y).frame, edge);
        sums.add(edge, {color.l - film.l, color.a - film.a, color.b - film.b}, speedPx);
      });
      const ColorDrift drift(sums);
      double mostChanged = 0.0;
      forAll([&](int x, int y, int edge, const Lab& color) {
        const Lab now = corrected.previous(x, y).lab();
        const Lab off = drift.at(edge);
        const float share = x < atRest ? 0.0F : kShare * std::min(speedPx / 0.25F, 1.0F);
        ASSERT_NEAR(now.l, color.l - share * off.l, 0.01F) << x << ", " << y;
        ASSERT_NEAR(now.a, color.a - share * off.a, 0.01F) << x << ", " << y;
        ASSERT_EQ(corrected.modulation(x, y), kept.modulation(x, y));
        mostChanged = std::max(mostChanged, std::abs(static_cast<double>(now.l) - color.l));
      });
      if (speedPx == 0.0F) {
        EXPECT_EQ(mostChanged, 0.0) << "at rest";
      } else {
        EXPECT_GT(mostChanged, 2.0) << speedPx;
      }
    }
  }
}

/// Deepened by as much as the film is darker inside, they are not off any more.
TEST_F(Drifted, WhatIsDeepenedIsNotCorrectedOnceMore) {
  PreviousRules rules = correcting(0.0F);
  rules.deepening = 1.0F;
  const double deepened = bodyOf(remembered(kBorderPx, rules)).first;
  rules.colorCorrection = 1.0F;
  EXPECT_NEAR(bodyOf(remembered(kBorderPx, rules)).first, deepened, 3.0);
}

TEST_F(Drifted, BothNeighborsAreCorrectedBeforeTheyAreMixed) {
  const test::GrowingDisc disc{Size{72, 64}, {36.0F, 32.0F}, 20.0F, 1.0F, 1};
  const PreviousRules rules = correcting(0.5F);
  const TargetLevel kept = remembered(1.0F, correcting(0.0F));
  const TargetLevel alone = remembered(1.0F, rules);
  const NearestNeighborField none(disc.size);
  const std::array<std::pair<const NearestNeighborField*, const NearestNeighborField*>, 3> cases{
      {{&field_, &none}, {&none, &field_}, {&field_, &field_}}};
  for (const auto& [before, after] : cases) {
    TargetLevel between(finestLevel(disc.guides(0)), kBorderPx);
    setBothNeighbors(film_.level(0), kBorderPx, rules, *before, *after, between);
    for (const int x : {28, 34, 40}) {
      ASSERT_GT(std::abs(alone.previous(x, 32).lab().l - kept.previous(x, 32).lab().l), 5.0F);
      EXPECT_EQ(between.previous(x, 32).l, alone.previous(x, 32).l);
      EXPECT_EQ(between.previous(x, 32).a, alone.previous(x, 32).a);
    }
  }
}

/// By how much what lies inside is lighter than in the film, in the last frame of a disc that
/// travels by twice its own width.
double palerThanTheFilm(const Exemplar& film, double filmsInterior, float deepening,
                        int depthReachFrames = 0, float colorCorrection = 0.0F) {
  SynthesisOptions options;       // the standard look
  options.optVoteSigmaPx = 0.0F;  // narrow votes make this film fade less by themselves
  options.prevDeepening = deepening;
  options.prevDepthReachFrames = depthReachFrames;
  options.prevColorCorrection = colorCorrection;
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

TEST_F(RememberedColors, AShapeThatTravelsKeepsItsBodyColour) {
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
  const double corrected =
      palerThanTheFilm(film, kFilmsInterior, 0.0F, 0, standard.prevColorCorrection);
  EXPECT_LT(std::abs(corrected), 0.75 * kept) << "all together, by half of it in each frame";
  const double all = palerThanTheFilm(film, kFilmsInterior, standard.prevDeepening,
                                      standard.prevDepthReachFrames, standard.prevColorCorrection);
  EXPECT_LT(std::abs(all), 0.5 * kept);
}

}  // namespace
}  // namespace fluidymation
