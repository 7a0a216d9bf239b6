#include "fluidymation/guides/rim_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fluidymation {
namespace {

constexpr Size kSize{160, 160};
constexpr int kStepPx = 5;
constexpr int kBands = 25;

struct Film {
  Image<Lab> picture{kSize};
  Mask mask{kSize};
};

/// A disc whose lightness, as a function of the distance to its edge in px, is `lightnessAt`.
template <typename Function>
Film disc(float radiusPx, Function lightnessAt) {
  Film film;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const float depth =
          radiusPx - std::hypot(static_cast<float>(x) - 80.0F, static_cast<float>(y) - 80.0F);
      film.mask(x, y) = depth > 0.0F ? 1 : 0;
      film.picture(x, y) = {depth > 0.0F ? lightnessAt(depth) : 95.0F, 10.0F, -5.0F};
    }
  }
  return film;
}

std::optional<float> widthOf(const Film& film) {
  RimProfile profile(kBands);
  profile.add(film.picture, film.mask);
  return profile.widthPx(kStepPx);
}

TEST(RimProfile, FindsTheWidthOfADarkRim) {
  for (const float rim : {4.0F, 8.0F, 12.0F, 16.0F}) {
    const Film film = disc(60.0F, [&](float d) { return d < rim ? 30.0F : 60.0F; });
    const auto width = widthOf(film);
    ASSERT_TRUE(width);
    EXPECT_NEAR(*width, rim, 1.5F);
  }
}

TEST(RimProfile, FindsWhereASlopeEnds) {
  for (const float rim : {6.0F, 12.0F, 18.0F}) {
    const Film film = disc(60.0F, [&](float d) { return 30.0F + 30.0F * std::min(1.0F, d / rim); });
    // The last tenth of the change counts as none.
    EXPECT_NEAR(widthOf(film).value_or(0.0F), 0.9F * rim, 2.0F);
  }
}

TEST(RimProfile, GoesTogetherOverFramesOfOtherBrightnessAndSize) {
  RimProfile profile(kBands);
  for (const float radius : {5.0F, 20.0F, 40.0F, 70.0F}) {  // the first ones have no interior
    const Film film =
        disc(radius, [&](float d) { return (d < 9.0F ? 20.0F : 45.0F) + 0.3F * radius; });
    profile.add(film.picture, film.mask);
  }
  EXPECT_NEAR(profile.widthPx(kStepPx).value_or(0.0F), 9.0F, 1.5F);
}

TEST(RimProfile, IsNotMisledByTexture) {
  const Film smooth = disc(60.0F, [](float d) { return d < 10.0F ? 30.0F : 60.0F; });
  Film rough = disc(60.0F, [](float) { return 0.0F; });
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      rough.picture(x, y) = smooth.picture(x, y);
      rough.picture(x, y).l += (x * 7 + y * 13) % 11 < 5 ? -8.0F : 8.0F;
    }
  }
  EXPECT_NEAR(widthOf(rough).value_or(0.0F), 10.0F, 1.5F);
}

TEST(RimProfile, OfOneColourIsAsNarrowAsCanBe) {
  EXPECT_EQ(widthOf(disc(60.0F, [](float) { return 50.0F; })), 1.0F);
}

TEST(RimProfile, TellsNothingWhereThereIsNoEdge) {
  Film film;
  EXPECT_FALSE(widthOf(film));
  film.mask = Mask(kSize, 1);
  EXPECT_FALSE(widthOf(film));
}

}  // namespace
}  // namespace fluidymation
