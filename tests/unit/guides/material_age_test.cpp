#include "fluidymation/guides/material_age.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/shapes.h"

namespace fluidymation {
namespace {

/// One row of pixels: '#' is inside.
Mask row(const std::string& text) {
  return test::maskOf(Size{static_cast<int>(text.size()), 1},
                      [&](int x, int) { return text[static_cast<std::size_t>(x)] == '#'; });
}

/// The ages of a row, a digit each; '.' outside.
std::string text(const Mask& mask, const Image<float>& ages) {
  std::string result;
  for (int x = 0; x < mask.width(); ++x) {
    EXPECT_TRUE(mask(x, 0) != 0 || ages(x, 0) == 0.0F);
    result += mask(x, 0) == 0 ? '.' : static_cast<char>('0' + static_cast<int>(ages(x, 0)));
  }
  return result;
}

template <typename Ages>
std::vector<std::string> agesOf(const std::vector<std::string>& rows) {
  Ages ages;
  std::vector<std::string> result;
  for (const std::string& r : rows) {
    const Mask mask = row(r);
    result.push_back(text(mask, ages.next(mask)));
  }
  return result;
}

using Rows = std::vector<std::string>;

TEST(TargetAges, CountTheFramesSinceAPixelWasCovered) {
  EXPECT_EQ(agesOf<TargetAges>({"##...", "###..", "####.", "#####"}),
            (Rows{"00...", "110..", "2210.", "33210"}));
}

TEST(TargetAges, StandStillInAHold) {
  EXPECT_EQ(agesOf<TargetAges>({"#...", "#...", "##..", "##..", "##..", "###."}),
            (Rows{"0...", "0...", "10..", "10..", "10..", "210."}));
}

TEST(TargetAges, BeginAnewWhereAPixelIsCoveredAgain) {
  EXPECT_EQ(agesOf<TargetAges>({"##.", "#.#", "##.", "...", "###"}),
            (Rows{"00.", "1.0", "20.", "...", "000"}));
}

TEST(TargetAges, TellWhetherTheyHaveGrown) {
  TargetAges ages;
  const auto grow = [&](const char* r) {
    static_cast<void>(ages.next(row(r)));
    return ages.haveGrown();
  };
  EXPECT_FALSE(grow("#..")) << "the first frame has none before it";
  EXPECT_TRUE(grow("##."));
  EXPECT_FALSE(grow("##."));
  EXPECT_TRUE(grow("#.."));
}

TEST(FilmAges, AreThoseOfTheDropAlsoWhereItHasJustSpreadTo) {
  EXPECT_EQ(agesOf<FilmAges>({"..#..", ".###.", "#####"}), (Rows{"..0..", ".111.", "22222"}));
}

TEST(FilmAges, AreEachDropsOwnWhereTheyFallOneAfterTheOther) {
  EXPECT_EQ(agesOf<FilmAges>({"#......", "##.....", "##...#.", "###.###"}),
            (Rows{"0......", "11.....", "22...0.", "333.111"}));
}

TEST(FilmAges, StayWhereDropsMergeAndWhatIsNewBelongsToTheOlderOne) {
  EXPECT_EQ(agesOf<FilmAges>({"#.....", "#....#", "##..##", "######"}),
            (Rows{"0.....", "1....0", "22..11", "333322"}));
}

TEST(FilmAges, BeginAnewWhereAPixelIsCoveredAgain) {
  EXPECT_EQ(agesOf<FilmAges>({"#..#", "#...", "#..#", "....", "##.#"}),
            (Rows{"0..0", "1...", "2..0", "....", "00.0"}));
}

TEST(FilmAges, CountAllFramesForAFilmDriesWhileItLiesStill) {
  EXPECT_EQ(agesOf<FilmAges>({"...", "##.", "##.", "##."}), (Rows{"...", "00.", "11.", "22."}));
}

TEST(FilmAges, TakeCornersForConnected) {
  const Size size{3, 3};
  FilmAges ages;
  static_cast<void>(ages.next(test::maskOf(size, [](int x, int y) { return x == 0 && y == 0; })));
  const Image<float> next =
      ages.next(test::maskOf(size, [](int x, int y) { return x == y && x < 2; }));
  EXPECT_EQ(next(1, 1), 1.0F);
}

}  // namespace
}  // namespace fluidymation
