#include "fluidymation/synthesis/change_blend.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "fluidymation/synthesis/painted_vote.h"
#include "support/synthetic_scene.h"
#include "synthesizer_fixture.h"

namespace fluidymation {
namespace {

constexpr int kNow = 2;     ///< the film's frame that new matches show
constexpr int kBefore = 5;  ///< that old ones show

/// Films of a growing disc, and a target that is the disc as large as in frame kNow.
class ChangeBlend : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{64, 60}, {32.0F, 30.0F}, 16.0F, 1.0F, 8};
  GuideFrame guides_ = disc_.guides(kNow);
  TargetLevel target_{finestLevel(guides_), kBorderWidthPx, {}, {}};
  VoteOptions votes_;
  /// Every frame has one colour.
  Exemplar plain_ = [this] {
    Exemplar film(disc_.size, disc_.frameCount, 0, kBorderWidthPx);
    for (int k = 0; k < disc_.frameCount; ++k) {
      film.setColor(k, Image<Lab>(disc_.size, colorOf(k)));
      film.setGuides(k, disc_.guides(k));
    }
    film.finish();
    return film;
  }();

  static Lab colorOf(int frame) { return {10.0F * static_cast<float>(frame), 8.0F, -6.0F}; }

  /// Every pixel of the target shows its own place in a frame of the film.
  [[nodiscard]] NearestNeighborField placesIn(int frame) const {
    NearestNeighborField nnf(disc_.size);
    for (int y = 0; y < disc_.size.height; ++y) {
      for (int x = 0; x < disc_.size.width; ++x) {
        if (target_.inside(x, y)) {
          nnf(x, y) = {static_cast<float>(x), static_cast<float>(y), frame, Rotation{}};
        }
      }
    }
    return nnf;
  }
  [[nodiscard]] Image<Lab> voted(const Exemplar& film, const NearestNeighborField& nnf) const {
    return paintedVote(film.level(0), guides_.mask, nnf, votes_, &target_.guides);
  }
  [[nodiscard]] Image<Lab> blended(const Exemplar& film, const NearestNeighborField& previous,
                                   const NearestNeighborField& nnf, float share) const {
    Image<Lab> picture = voted(film, nnf);
    blendChanges(film.level(0), target_, previous, nnf, share, votes_, picture);
    return picture;
  }
};

TEST_F(ChangeBlend, TheOldPieceKeepsItsShareWhereItLiesAsDeep) {
  const Image<Lab> picture = blended(plain_, placesIn(kBefore), placesIn(kNow), 0.25F);
  const Lab& middle = picture(32, 30);
  EXPECT_NEAR(middle.l, 0.75F * colorOf(kNow).l + 0.25F * colorOf(kBefore).l, 1e-2F);
  EXPECT_NEAR(middle.a, 8.0F, 1e-2F);
  EXPECT_NEAR(middle.b, -6.0F, 1e-2F);
}

TEST_F(ChangeBlend, TheOldPieceCountsLessWhereItLiesDeeperOrNot) {
  // From frame kNow to the next one the edge moves by a pixel, which is the sigma.
  ASSERT_EQ(kChangeDepthSigmaWidths * kBorderWidthPx, disc_.speedPx);
  constexpr float kShare = 0.5F;
  const auto x = static_cast<int>(32.0F + disc_.radiusPx(kNow) - 2.0F);  // 2 px deep
  const auto weightOf = [&](int frame) {
    const Image<Lab> picture = blended(plain_, placesIn(frame), placesIn(kNow), kShare);
    return (picture(x, 30).l - colorOf(kNow).l) / (colorOf(frame).l - colorOf(kNow).l);
  };
  EXPECT_NEAR(weightOf(kNow + 1), kShare * std::exp(-0.5F), 0.02F);
  EXPECT_NEAR(weightOf(kNow + 2), kShare * std::exp(-2.0F), 0.02F);
  EXPECT_NEAR(weightOf(kNow - 1), kShare * std::exp(-0.5F), 0.02F);
}

TEST_F(ChangeBlend, OfAllItsShareIsThePictureOfTheOldMatches) {
  const Exemplar film = test::discExemplar(disc_, 0, kBorderWidthPx, 4);
  NearestNeighborField previous = placesIn(kNow);
  for (Match& match : previous) {
    if (match.exists()) match.x += 0.75F;  // elsewhere, and nearly as deep
  }
  const Image<Lab> expected = voted(film, previous);
  const Image<Lab> asNow = voted(film, placesIn(kNow));
  const Image<Lab> picture = blended(film, previous, placesIn(kNow), 1.0F);
  int differing = 0;
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      if (guides_.distance(x, y) < kBorderWidthPx + 2.0F) continue;  // all as deep
      EXPECT_NEAR(picture(x, y).l, expected(x, y).l, 1e-3F);
      EXPECT_NEAR(picture(x, y).b, expected(x, y).b, 1e-3F);
      differing += std::abs(asNow(x, y).l - expected(x, y).l) > 0.1F ? 1 : 0;
    }
  }
  EXPECT_GT(differing, 100);
}

TEST_F(ChangeBlend, WhatKeepsItsMatchAndWhatHasNoneStays) {
  constexpr int kBegin = 30;  // columns whose matches change
  constexpr int kEnd = 35;
  votes_.depthSigmaPx = 0.0F;  // else neighbours that lie deeper or less deep are not heard
  const NearestNeighborField nnf = placesIn(kNow);
  NearestNeighborField previous = placesIn(kBefore);
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      if (x < kBegin) previous(x, y) = nnf(x, y);
      if (x >= kEnd) previous(x, y) = Match{};
    }
  }
  const Image<Lab> before = voted(plain_, nnf);
  const Image<Lab> after = blended(plain_, previous, nnf, 0.5F);
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      const bool changes = target_.inside(x, y) && x >= kBegin && x < kEnd;
      const bool same = before(x, y).l == after(x, y).l && before(x, y).a == after(x, y).a &&
                        before(x, y).b == after(x, y).b;
      EXPECT_EQ(same, !changes) << x << ", " << y;
    }
  }
}

TEST_F(ChangeBlend, WithoutAShareOrAFrameBeforeNothingChanges) {
  const NearestNeighborField nnf = placesIn(kNow);
  const Image<Lab> picture = voted(plain_, nnf);
  EXPECT_TRUE(sameBytes(blended(plain_, placesIn(kBefore), nnf, 0.0F), picture));
  EXPECT_TRUE(sameBytes(blended(plain_, {}, nnf, 0.5F), picture));
  EXPECT_TRUE(sameBytes(blended(plain_, NearestNeighborField(nnf.size()), nnf, 0.5F), picture));
}

TEST_F(ChangeBlend, IsTheSameAtAnyNumberOfThreads) {
  const Exemplar film = test::discExemplar(disc_, 0, kBorderWidthPx, 4);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Image<Lab> expected = blended(film, placesIn(kBefore), placesIn(kNow), 0.4F);
  for (const int threads : {2, 3, 7}) {
    omp_set_num_threads(threads);
    EXPECT_TRUE(sameBytes(blended(film, placesIn(kBefore), placesIn(kNow), 0.4F), expected));
  }
  omp_set_num_threads(before);
}

TEST_F(SynthesizerTest, TheSearchKnowsNothingOfBlendedChanges) {
  const Exemplar exemplar = test::discExemplar(disc_, 2, kBorderWidthPx, 3);
  SynthesisOptions options;
  options.changeBlending = 0.0F;
  Synthesizer without(exemplar, options);
  options.changeBlending = 0.4F;
  Synthesizer with(exemplar, options);
  for (int j = 0; j < other_.frameCount; ++j) {
    const bool alike = sameBytes(with.paint(other_.guides(j)), without.paint(other_.guides(j)));
    EXPECT_EQ(alike, j == 0) << j;
    EXPECT_TRUE(sameBytes(with.nnf(), without.nnf())) << j;
  }
}

}  // namespace
}  // namespace fluidymation
