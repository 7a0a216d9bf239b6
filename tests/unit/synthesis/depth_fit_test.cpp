#include "fluidymation/synthesis/depth_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/shape_rules.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderPx = 8.0F;
constexpr int kFrames = 16;
constexpr int kFar = 100;  ///< a reach beyond the film's ends

/// A film of a disc that grows by a pixel a frame, and targets of one depth everywhere.
class DepthFit : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{64, 60}, {32.0F, 30.0F}, 8.0F, 1.0F, kFrames};
  Exemplar film_ = test::discExemplar(disc_, 0, kBorderPx, 1);

  [[nodiscard]] const ExemplarLevel& finest() const { return film_.level(0); }

  /// What becomes of a match at a pixel that is `depthPx` deep, where the target moves by `flowPx`.
  [[nodiscard]] Match fitted(const Match& match, float depthPx, int reach = kFar,
                             float flowPx = 1.0F) const {
    const Size one{1, 1};
    GuideFrame guides = disc_.guides(0);
    guides = {Mask(one, 1),
              Image<float>(one, depthPx),
              Image<Vec2>(one, {flowPx, 0.0F}),
              Image<Vec2>(one, {1.0F, 0.0F}),
              Image<Vec2>(one),
              Image<Vec2>(one),
              SolveReport{},
              {}};
    const TargetLevel target(finestLevel(guides), kBorderPx);
    NearestNeighborField field(one, match);
    fitDepths(finest(), target, guides.flow, reach, field);
    return field(0, 0);
  }
  /// The same of a match right of the centre, whose place is rim in the first frames.
  [[nodiscard]] int fittedFrame(int frame, float depthPx, int reach = kFar,
                                float flowPx = 1.0F) const {
    return fitted(besideCentre(frame), depthPx, reach, flowPx).frame;
  }
  [[nodiscard]] static Match besideCentre(int frame) { return {38.0F, 30.0F, frame, Rotation{}}; }

  [[nodiscard]] float differencePx(const Match& match, float depthPx) const {
    return modulationDifference(
        depthPx, finest().modulationDistancePx(match.nearestX(), match.nearestY(), match.frame),
        kBorderPx);
  }
};

TEST_F(DepthFit, GoesToTheFrameInWhichThePlaceIsAsDeepAsThePixel) {
  for (const float depthPx : {3.0F, 5.0F, 7.0F}) {
    for (const int start : {0, 2, 5, 9, 15}) {
      const Match match{38.0F, 30.0F, fittedFrame(start, depthPx), Rotation{}};
      EXPECT_LE(differencePx(match, depthPx), kFittingDepthPx) << depthPx << " from " << start;
    }
  }
}

TEST_F(DepthFit, KeepsTheFrameWhereDepthsAgree) {
  for (int frame = 0; frame < kFrames; ++frame) {
    const float depthPx = finest().modulationDistancePx(38, 30, frame);
    EXPECT_EQ(fittedFrame(frame, depthPx), frame);
    EXPECT_EQ(fittedFrame(frame, depthPx + 0.9F * kFittingDepthPx), frame);
  }
  // All that is deeper than the border is wide counts as equally deep
  EXPECT_EQ(fittedFrame(kFrames - 1, 50.0F), kFrames - 1);
}

TEST_F(DepthFit, ChangesTheFrameAlone) {
  const Match match{38.3F, 29.6F, 9, Rotation{0.6F, 0.8F}};
  const Match moved = fitted(match, 3.0F);
  EXPECT_NE(moved.frame, match.frame);
  EXPECT_EQ(moved.x, match.x);
  EXPECT_EQ(moved.y, match.y);
  EXPECT_EQ(moved.rotation.cosine, match.rotation.cosine);
  EXPECT_EQ(moved.rotation.sine, match.rotation.sine);
}

TEST_F(DepthFit, GoesNoFurtherThanItsReach) {
  EXPECT_EQ(fittedFrame(9, 3.0F, 0), 9);
  const int free = fittedFrame(9, 3.0F);
  ASSERT_LT(free, 9 - 2);
  EXPECT_EQ(fittedFrame(9, 3.0F, 9 - free), free);
  // At depths beyond the border's width no frame is better than another until the rim comes near
  const int shallowest = fittedFrame(4, 1.0F, 2);
  EXPECT_EQ(shallowest, 2) << "as far as it may";
}

TEST_F(DepthFit, ChangesNothingAtRest) { EXPECT_EQ(fittedFrame(9, 3.0F, kFar, 0.0F), 9); }

TEST_F(DepthFit, LeavesAgesAlone) {
  Exemplar film(disc_.size, kFrames, 0, kBorderPx);
  for (int k = 0; k < kFrames; ++k) {
    GuideFrame guides = disc_.guides(k);
    guides.age = Image<float>(disc_.size, static_cast<float>(k));
    film.setColor(k, test::randomTexture(disc_.size, 3));
    film.setGuides(k, guides);
  }
  film.finish();
  ASSERT_TRUE(film.comparesAges());
  GuideFrame guides = disc_.guides(0);
  guides.age = Image<float>(disc_.size, 3.0F);
  const TargetLevel target(finestLevel(guides), kBorderPx, film.extentScale());
  NearestNeighborField field(disc_.size, besideCentre(9));
  fitDepths(film.level(0), target, Image<Vec2>(disc_.size, {1.0F, 0.0F}), kFar, field);
  for (const Match& match : field) ASSERT_EQ(match.frame, 9);
}

TEST_F(DepthFit, StaysWithinTheFilmsMask) {
  // 14 px from the centre: outside until the disc's radius of 8 px has grown by 6
  const Match outside{46.0F, 30.0F, 3, Rotation{}};
  EXPECT_EQ(fitted(outside, 5.0F).frame, 3) << "no place of the medium: left to the repair";
  const Match atRim{46.0F, 30.0F, 8, Rotation{}};
  const Match moved = fitted(atRim, 0.0F);
  EXPECT_NE(finest().segment(46, 30, moved.frame), Segment::kOutside);
  const Match beside{-3.0F, 70.0F, 8, Rotation{}};
  EXPECT_EQ(fitted(beside, 5.0F).frame, 8) << "beside the film's image";
  EXPECT_FALSE(fitted(Match{}, 5.0F).exists());
}

TEST_F(DepthFit, NeverFitsWorseThanBefore) {
  // On a film whose depths go up and down: the disc's frames in another order
  Exemplar film(disc_.size, kFrames, 0, kBorderPx);
  Random random({5, 0, 0, 0, 0, 0});
  for (int k = 0; k < kFrames; ++k) {
    film.setColor(k, test::randomTexture(disc_.size, 3));
    film.setGuides(k, disc_.guides(static_cast<int>(random.below(kFrames))));
  }
  film.finish();
  const ExemplarLevel& finest = film.level(0);
  const GuideFrame guides = disc_.guides(6);
  const TargetLevel target(finestLevel(guides), kBorderPx);
  const Image<Vec2> flow(disc_.size, {1.0F, 0.0F});
  NearestNeighborField field(disc_.size);
  for (Match& match : field) {
    match = {static_cast<float>(random.below(64)), static_cast<float>(random.below(60)),
             static_cast<std::int32_t>(random.below(kFrames)), Rotation{}};
  }
  const NearestNeighborField before = field.clone();
  fitDepths(finest, target, flow, 4, field);
  int moved = 0;
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      const Match& a = before(x, y);
      const Match& b = field(x, y);
      if (a.frame == b.frame) continue;
      ++moved;
      ASSERT_TRUE(target.inside(x, y));
      ASSERT_LE(std::abs(a.frame - b.frame), 4);
      const auto away = [&](const Match& m) {
        return modulationDifference(
            target.modulationDistancePx(x, y),
            finest.modulationDistancePx(m.nearestX(), m.nearestY(), m.frame), kBorderPx);
      };
      ASSERT_LE(away(b), away(a) - kLeastDepthGainPx);
      const int step = b.frame > a.frame ? 1 : -1;
      for (int k = a.frame; k != b.frame + step; k += step) {
        ASSERT_NE(finest.segment(a.nearestX(), a.nearestY(), k), Segment::kOutside);
      }
    }
  }
  EXPECT_GT(moved, 40) << "too few to tell";
}

}  // namespace
}  // namespace fluidymation
