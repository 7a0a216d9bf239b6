#include "footage/camera_tracker.h"

#include <gtest/gtest.h>

#include "support/synthetic_film.h"

namespace fluidymation::test {
namespace {

TEST(CameraTracker, FindsMovementsOfPartsOfPixels) {
  const CameraTracker camera(toLab(filmed(paper({200, 160}))));
  for (const Vec2 moved :
       {Vec2{0.0F, 0.0F}, Vec2{3.0F, -2.0F}, Vec2{0.5F, 1.25F}, Vec2{-9.0F, 8.0F}}) {
    Shot shot = stained({200, 160}, {100.0F, 80.0F}, 40.0F);
    shot.cameraPx = moved;
    shot.grain = 0.01F;
    const auto found = camera.offsetOf(toLab(filmed(shot)));
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->x, moved.x, 0.2F);
    EXPECT_NEAR(found->y, moved.y, 0.2F);
  }
}

TEST(CameraTracker, PaintThatGrowsIsNoMovement) {
  const CameraTracker camera(toLab(filmed(stained({200, 160}, {100.0F, 80.0F}, 20.0F))));
  for (const float radius : {24.0F, 32.0F, 60.0F}) {
    const auto found = camera.offsetOf(toLab(filmed(stained({200, 160}, {100.0F, 80.0F}, radius))));
    EXPECT_LT(length(found.value_or(Vec2{})), 0.2F) << radius;
    EXPECT_TRUE(found.has_value() || radius > 50.0F) << radius;  // little is left to tell by
  }
}

TEST(CameraTracker, LightIsNoMovement) {
  const CameraTracker camera(toLab(filmed(paper({200, 160}))));
  Shot darker = paper({200, 160});
  darker.light = 0.8F;
  const auto found = camera.offsetOf(toLab(filmed(darker)));
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(length(*found), 0.1F);
}

TEST(CameraTracker, SaysNothingOfEvenSurfacesAndSmallPictures) {
  const CameraTracker even(Image<Lab>(Size{200, 160}, Lab{80.0F, 0.0F, 0.0F}));
  EXPECT_FALSE(even.offsetOf(toLab(filmed(paper({200, 160})))).has_value());
  const Image<Lab> small = toLab(filmed(paper({40, 30})));
  EXPECT_FALSE(CameraTracker(small).offsetOf(small).has_value());
}

TEST(CameraTracker, SaysNothingOfMovementsBeyondItsReach) {
  const CameraTracker camera(toLab(filmed(paper({200, 160}))));
  Shot far = paper({200, 160});
  far.cameraPx = {40.0F, 30.0F};
  EXPECT_FALSE(camera.offsetOf(toLab(filmed(far))).has_value());
}

}  // namespace
}  // namespace fluidymation::test
