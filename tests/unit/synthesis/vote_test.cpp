#include "fluidymation/synthesis/vote.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fluidymation/core/random.h"
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
