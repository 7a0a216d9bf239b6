#include "inspect/rim_profile.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr Size kSize{120, 120};
constexpr float kBorderWidthPx = 10.0F;

/// A disc whose lightness is `light(distance)`.
template <typename Light>
RimProfile profileOf(const Light& light) {
  std::vector<Mask> masks;
  masks.push_back(test::disc(kSize, {60.0F, 60.0F}, 50.0F));
  const GuideFrame frame = std::move(test::guidesOf(masks, 0.0F).front());
  Image<Lab> picture(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) picture(x, y).l = light(frame.distance(x, y));
  }
  RimProfile profile;
  profile.add(frame, picture);
  return profile;
}

TEST(RimProfile, FindsTheWidthOfADarkRim) {
  for (const float width : {4.0F, 7.0F, 15.0F}) {
    const auto rim = profileOf([&](float distance) {
                       return distance < width ? 20.0F : 60.0F;
                     }).rimWidthPx(kBorderWidthPx);
    ASSERT_TRUE(rim.has_value());
    EXPECT_NEAR(*rim, width, 1.0F);
  }
}

TEST(RimProfile, APlainMediumHasNone) {
  EXPECT_FALSE(profileOf([](float) { return 40.0F; }).rimWidthPx(kBorderWidthPx).has_value());
  EXPECT_FALSE(profileOf([](float distance) { return distance < 5.0F ? 40.0F : 41.0F; })
                   .rimWidthPx(kBorderWidthPx)
                   .has_value());
}

TEST(RimProfile, MasksWithoutEdgeTellNothing) {
  std::vector<Mask> masks;
  masks.push_back(test::maskOf(kSize, [](int, int) { return true; }));
  RimProfile profile;
  profile.add(test::guidesOf(masks, 0.0F).front(), Image<Lab>(kSize));
  EXPECT_FALSE(profile.rimWidthPx(kBorderWidthPx).has_value());
  EXPECT_FALSE(RimProfile().rimWidthPx(kBorderWidthPx).has_value());
}

}  // namespace
}  // namespace fluidymation
