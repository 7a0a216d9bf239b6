#include "fluidymation/synthesis/depth_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/darkening_film.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

using test::edgeAt;
using test::filmOf;
using test::kBorderPx;

class DepthColorsTest : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{72, 64}, {36.0F, 32.0F}, 14.0F, 1.0F, 12};
};

TEST_F(DepthColorsTest, TellTheProfileOfTheFilm) {
  const Exemplar film = filmOf(disc_, 0, [](int) { return 5.0F; });
  const DepthColors colors(film.level(0));
  for (int k = 0; k < disc_.frameCount; ++k) {
    EXPECT_NEAR(colors.mean(k, edgeAt(6.0F)).l, 60.0F, 1.5F) << k;
    EXPECT_NEAR(colors.mean(k, edgeAt(2.0F)).a, 4.0F, 0.6F) << k;
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
  }
}

}  // namespace
}  // namespace fluidymation
