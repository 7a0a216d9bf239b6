#include "footage/light_meter.h"

#include <gtest/gtest.h>

#include "support/shapes.h"
#include "support/synthetic_film.h"

namespace fluidymation::test {
namespace {

TEST(LightMeter, SeesTheLightAndNotThePaint) {
  LightMeter light(toLab(filmed(paper())));
  light.add(toLab(filmed(Shot())));
  Shot darker;
  darker.light = 0.9F;
  light.add(toLab(filmed(darker)));
  const std::vector<Lab> drift = light.drift(disc({160, 120}, {80.0F, 60.0F}, 31.0F));
  ASSERT_EQ(drift.size(), 2U);
  EXPECT_NEAR(drift[0].l, 0.0F, 1e-3F);
  // Of paper between 0.8 and 0.92
  const auto lightness = [](float gray) { return toLab(Rgb{gray, gray, gray}).l; };
  EXPECT_NEAR(drift[1].l, lightness(0.86F * 0.9F) - lightness(0.86F), 0.3F);
  // A mask that is too small lets paint in
  EXPECT_LT(light.drift(disc({160, 120}, {80.0F, 60.0F}, 2.0F))[0].l, -0.5F);
}

TEST(LightMeter, SaysNothingWhereNothingStaysBare) {
  LightMeter light(toLab(filmed(Shot())));
  light.add(toLab(filmed(Shot())));
  EXPECT_TRUE(light.drift(Mask(Size{160, 120}, 1)).empty());
  LightMeter tiny(Image<Lab>(Size{3, 2}));
  tiny.add(Image<Lab>(Size{3, 2}));
  EXPECT_TRUE(tiny.drift(Mask(Size{3, 2})).empty());
}

}  // namespace
}  // namespace fluidymation::test
