#include "fluidymation/synthesis/depth_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

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

  /// What becomes of a match at a pixel that is `depthPx` deep, where the target moves by `flow`.
  [[nodiscard]] Match fitted(const Match& match, float depthPx, int reach = kFar,
                             Vec2 flow = {3.0F, 0.0F}) const {
    return fittedIn(finest(), match, depthPx, reach, flow);
  }
  [[nodiscard]] static Match fittedIn(const ExemplarLevel& film, const Match& match, float depthPx,
                                      int reach, Vec2 flow, const ShapeRules& rules = {}) {
    const Size one{1, 1};
    const GuideFrame guides{Mask(one, 1),           Image<float>(one, depthPx),
                            Image<Vec2>(one, flow), Image<Vec2>(one, {1.0F, 0.0F}),
                            Image<Vec2>(one),       Image<Vec2>(one),
                            SolveReport{},          {}};
    const TargetLevel target(finestLevel(guides), kBorderPx, {}, rules);
    NearestNeighborField field(one, match);
    fitDepths(film, target, guides.flow, reach, field);
    return field(0, 0);
  }
  /// The same of a match right of the centre, whose place is rim in the first frames.
  [[nodiscard]] int fittedFrame(int frame, float depthPx, int reach = kFar,
                                Vec2 flow = {3.0F, 0.0F}) const {
    return fitted(besideCentre(frame), depthPx, reach, flow).frame;
  }
  /// A film of discs with these radii, px.
  [[nodiscard]] Exemplar filmOf(const std::vector<int>& radii, const ShapeRules& rules = {}) const {
    Exemplar film(disc_.size, static_cast<int>(radii.size()), 0, kBorderPx, rules);
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const auto frame = static_cast<int>(k);
      film.setColor(frame, test::randomTexture(disc_.size, 3));
      film.setGuides(frame, disc_.guides(radii[k] - 8));
    }
    film.finish();
    return film;
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
  EXPECT_EQ(fittedFrame(4, 1.0F, 2), 2) << "as far as it may";
}

TEST_F(DepthFit, ChangesDepthsNoMoreThanTheTargetMoves) {
  EXPECT_EQ(fittedFrame(9, 3.0F, kFar, {0.0F, 0.0F}), 9) << "a hold";
  EXPECT_EQ(fittedFrame(9, 3.0F, kFar, {1e-4F, 0.0F}), 9) << "hardly moves";
  const auto depthOf = [&](int frame) { return finest().modulationDistancePx(38, 30, frame); };
  const int start = 5;  // a little less deep than the border is wide
  ASSERT_LT(depthOf(start), kBorderPx);
  for (const Vec2 flow : {Vec2{0.5F, 0.0F}, Vec2{0.0F, 0.5F}, Vec2{0.0F, -0.5F}}) {
    const int frame = fittedFrame(start, 0.5F, kFar, flow);
    EXPECT_NE(frame, start);
    EXPECT_LE(std::abs(depthOf(frame) - depthOf(start)), kMostDepthPerMovement * 0.5F);
  }
  EXPECT_LT(fittedFrame(start, 0.5F), fittedFrame(start, 0.5F, kFar, {0.5F, 0.0F}));
}

TEST_F(DepthFit, TakesTheLaterFrameOfTwoAsGood) {
  const Exemplar film = filmOf({20, 12, 20});
  const Match match{32.0F + 10.0F, 30.0F, 1, Rotation{}};
  EXPECT_EQ(fittedIn(film.level(0), match, kBorderPx, kFar, {3.0F, 0.0F}).frame, 2);
}

TEST_F(DepthFit, GoesByDepthsUpToTheBordersWidthWhateverTheModulation) {
  ShapeRules unclamped;
  unclamped.modulation = ModulationDistance::kUnclamped;
  const Exemplar film = filmOf({12, 16, 20, 22}, unclamped);
  ASSERT_GT(film.level(0).modulationDistancePx(32, 30, 3), kBorderPx);
  const auto frameOf = [&](int frame, float depthPx) {
    const Match match{32.0F + 6.0F, 30.0F, frame, Rotation{}};
    return fittedIn(film.level(0), match, depthPx, kFar, {3.0F, 0.0F}, unclamped).frame;
  };
  EXPECT_EQ(frameOf(3, 40.0F), 3) << "both beyond the border";
  EXPECT_EQ(frameOf(1, 40.0F), 1) << "10 px deep is as deep as any";
  EXPECT_EQ(frameOf(0, 40.0F), 1) << "the nearest that is deep enough";
}

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
  // Under the mask, out of it, and deep under it again
  const Exemplar film = filmOf({16, 8, 22});
  const Match atRim{46.0F, 30.0F, 0, Rotation{}};
  EXPECT_EQ(fittedIn(film.level(0), atRim, kBorderPx, kFar, {3.0F, 0.0F}).frame, 0);
  const Exemplar covering = filmOf({16, 15, 22});
  EXPECT_EQ(fittedIn(covering.level(0), atRim, kBorderPx, kFar, {3.0F, 0.0F}).frame, 2);
  const Match beside{-3.0F, 70.0F, 8, Rotation{}};
  EXPECT_EQ(fitted(beside, 5.0F).frame, 8) << "beside the film's image";
  EXPECT_FALSE(fitted(Match{}, 5.0F).exists());
}

/// What `fitDepths` says of one match, frame after frame.
int slowTwin(const ExemplarLevel& film, const Match& match, float wantedPx, float movedPx,
             int reach) {
  const int x = match.nearestX();
  const int y = match.nearestY();
  const auto depth = [&](int k) {
    return std::min(film.modulationDistancePx(x, y, k), film.borderWidthPx());
  };
  const auto isInside = [&](int k) {
    return k >= 0 && k < film.frameCount() && film.segment(x, y, k) != Segment::kOutside;
  };
  const auto isReached = [&](int k) {
    for (int between = std::min(k, match.frame); between <= std::max(k, match.frame); ++between) {
      if (!isInside(between)) return false;
    }
    return true;
  };
  std::vector<int> order{match.frame};
  for (int r = 1; r <= reach; ++r) {
    order.push_back(match.frame + r);
    order.push_back(match.frame - r);
  }
  int best = match.frame;
  for (const int k : order) {
    const float before = std::abs(depth(best) - wantedPx);
    if (before <= kFittingDepthPx) break;
    if (k < 0 || k >= film.frameCount() || !isReached(k)) continue;
    if (std::abs(depth(k) - depth(match.frame)) > kMostDepthPerMovement * movedPx) continue;
    if (std::abs(depth(k) - wantedPx) <= before - kLeastDepthGainPx) best = k;
  }
  return best;
}

TEST_F(DepthFit, IsWhatItsSlowTwinSays) {
  Random random({5, 0, 0, 0, 0, 0});
  std::vector<int> radii(kFrames);  // depths that go up and down
  for (int& radius : radii) radius = 8 + static_cast<int>(random.below(kFrames));
  const Exemplar film = filmOf(radii);
  const GuideFrame guides = disc_.guides(9);
  const TargetLevel target(finestLevel(guides), kBorderPx);
  Image<Vec2> flow(disc_.size);
  for (Vec2& v : flow) v = {0.25F * static_cast<float>(random.below(9)), 0.0F};
  NearestNeighborField field(disc_.size);
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      field(x, y) = {static_cast<float>(16 + random.below(32)),
                     static_cast<float>(14 + random.below(32)),
                     static_cast<std::int32_t>(random.below(kFrames)), Rotation{}};
    }
  }
  const NearestNeighborField before = field.clone();
  constexpr int kReach = 4;
  fitDepths(film.level(0), target, flow, kReach, field);
  int moved = 0;
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      const Match& match = before(x, y);
      const bool stays = !target.inside(x, y) || flow(x, y).x == 0.0F ||
                         film.level(0).segment(match.nearestX(), match.nearestY(), match.frame) ==
                             Segment::kOutside;
      const float wantedPx = std::min(target.modulationDistancePx(x, y), kBorderPx);
      const int expected =
          stays ? match.frame : slowTwin(film.level(0), match, wantedPx, flow(x, y).x, kReach);
      ASSERT_EQ(field(x, y).frame, expected) << x << ", " << y;
      moved += expected != match.frame ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 100) << "too few to tell";
}

}  // namespace
}  // namespace fluidymation
