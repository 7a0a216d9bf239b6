#include "fluidymation/core/recoloring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fluidymation {
namespace {

constexpr Lab kPaper{92.0F, 1.0F, 6.0F};
constexpr Lab kBlue{52.0F, 4.0F, -30.0F};
constexpr Lab kInk{20.0F, 0.0F, 0.0F};
constexpr float kRounding = 1e-4F;

float chromaOf(Lab color) { return std::hypot(color.a, color.b); }

/// Of paper and paint, `amount` of it.
Lab mixed(Lab paper, Lab paint, float amount) {
  const auto between = [amount](float a, float b) { return a + amount * (b - a); };
  return {between(paper.l, paint.l), between(paper.a, paint.a), between(paper.b, paint.b)};
}

void expectNear(Lab found, Lab expected, float tolerance = kRounding) {
  EXPECT_NEAR(found.l, expected.l, tolerance);
  EXPECT_NEAR(found.a, expected.a, tolerance);
  EXPECT_NEAR(found.b, expected.b, tolerance);
}

const Lab kRed = toLab(Rgb{0.75F, 0.15F, 0.15F});

TEST(Recoloring, LeavesThePaperAsItIs) {
  for (const Lab wanted : {kRed, Lab{50.0F, 0.0F, 0.0F}, Lab{90.0F, -60.0F, 60.0F}}) {
    expectNear(Recoloring(kPaper, kBlue, wanted)(kPaper), kPaper);
    expectNear(Recoloring(kPaper, kInk, wanted)(kPaper), kPaper);
  }
}

TEST(Recoloring, ChangesNothingWhereTheColourIsTheMediumsOwn) {
  const Recoloring same(kPaper, kBlue, kBlue);
  for (float l = 10.0F; l < 90.0F; l += 7.0F) {
    for (const float a : {-9.0F, 0.0F, 8.0F}) {
      for (const float b : {-16.0F, 0.0F, 11.0F}) {
        const Lab color{l, a, b};
        if (!isInGamut(color)) continue;
        expectNear(same(color), color);
      }
    }
  }
}

TEST(Recoloring, GivesTheMediumTheWantedHueAndChromaAndKeepsItsLightness) {
  for (const Lab medium : {kBlue, Lab{52.0F, 0.0F, 0.0F}}) {
    const Lab found = Recoloring(kPaper, medium, kRed)(medium);
    expectNear(found, {medium.l, kRed.a, kRed.b});
  }
}

TEST(Recoloring, KeepsTheLightnessOfEveryPixel) {
  const Recoloring recoloring(kPaper, kBlue, kRed);
  for (float l = 0.0F; l <= 100.0F; l += 5.0F) {
    for (float b = -60.0F; b <= 60.0F; b += 20.0F) {
      const Lab found = recoloring({l, 10.0F, b});
      EXPECT_EQ(found.l, l);
      EXPECT_TRUE(isInGamut(found)) << l << " " << b;
    }
  }
}

TEST(Recoloring, StaysOnTheGrayAxisWhereAllIsGray) {
  const Recoloring recoloring({95.0F, 0.0F, 0.0F}, kInk, {60.0F, 0.0F, 0.0F});
  for (float l = 0.0F; l <= 100.0F; l += 10.0F) {
    expectNear(recoloring({l, 0.0F, 0.0F}), {l, 0.0F, 0.0F}, 0.0F);
  }
}

TEST(Recoloring, TakesAllColourOfAMediumThatIsToBeGray) {
  const Recoloring recoloring({95.0F, 0.0F, 0.0F}, kBlue, {60.0F, 0.0F, 0.0F});
  const Lab darker = mixed({95.0F, 0.0F, 0.0F}, kBlue, 1.2F);
  expectNear(recoloring({darker.l, darker.a + 9.0F, darker.b - 8.0F}), {darker.l, 0.0F, 0.0F});
}

TEST(Recoloring, GivesMoreChromaToMorePaint) {
  for (const Lab medium : {kBlue, kInk}) {
    const Recoloring recoloring(kPaper, medium, {50.0F, 20.0F, -8.0F});
    float before = -1.0F;
    for (float amount = 0.0F; amount <= 1.0F; amount += 0.05F) {
      const Lab found = recoloring(mixed(kPaper, medium, amount));
      const float moved = std::hypot(found.a - kPaper.a, found.b - kPaper.b);
      EXPECT_GT(moved, before) << amount;
      before = moved;
    }
  }
}

TEST(Recoloring, TurnsSmallDifferencesWithTheHueAndEnlargesNone) {
  const Lab white{95.0F, 0.0F, 0.0F};
  const Lab blue{50.0F, 0.0F, -40.0F};
  const Recoloring toRed(white, blue, {50.0F, 40.0F, 0.0F});
  expectNear(toRed({50.0F, 4.0F, -40.0F}), {50.0F, 40.0F, 4.0F});
  const Recoloring toVivid(white, blue, {50.0F, 60.0F, 0.0F});
  const Lab found = toVivid({50.0F, 4.0F, -40.0F});
  EXPECT_NEAR(found.a, 60.0F, kRounding);
  EXPECT_NEAR(found.b, 4.0F * 40.0F / 60.0F, kRounding);
}

TEST(Recoloring, LeavesWhatIsLighterThanThePaperAsItIs) {
  const Recoloring recoloring(kPaper, kInk, kRed);
  const Lab glint{94.0F, kPaper.a, kPaper.b};
  expectNear(recoloring(glint), glint);  // no opposite hue
}

TEST(WithinGamut, KeepsWhatSrgbHas) {
  for (const Rgb color : {Rgb{1.0F, 0.0F, 0.0F}, Rgb{0.0F, 0.0F, 1.0F}, Rgb{1.0F, 1.0F, 1.0F},
                          Rgb{0.0F, 0.0F, 0.0F}, Rgb{0.2F, 0.7F, 0.4F}}) {
    expectNear(withinGamut(toLab(color)), toLab(color), 0.0F);
  }
}

TEST(WithinGamut, TakesChromaUntilTheColourFitsAndNoMore) {
  const Lab vivid{40.0F, 90.0F, -20.0F};
  const Lab found = withinGamut(vivid);
  EXPECT_EQ(found.l, vivid.l);
  EXPECT_NEAR(std::atan2(found.b, found.a), std::atan2(vivid.b, vivid.a), 1e-5F);
  EXPECT_LT(chromaOf(found), chromaOf(vivid));
  constexpr float kMore = 1.01F;
  EXPECT_FALSE(isInGamut({found.l, kMore * found.a, kMore * found.b}));
}

TEST(WithinGamut, MakesWhatIsBeyondBlackAndWhiteGray) {
  for (const float l : {-3.0F, 104.0F}) {
    const Lab found = withinGamut({l, 30.0F, -40.0F});
    EXPECT_EQ(found.l, l);
    EXPECT_LT(chromaOf(found), 0.02F) << l;
  }
}

}  // namespace
}  // namespace fluidymation
