#include "footage/film_findings.h"

#include <gtest/gtest.h>

namespace fluidymation::test {
namespace {

/// A film of 10 frames of 100x50, each painted to a tenth, without any fault.
[[nodiscard]] FilmFindings faultless() {
  FilmFindings film;
  film.size = {100, 50};
  film.threshold = 12.0F;
  film.smallestHolePx = 10;
  for (int i = 1; i <= 10; ++i) {
    FrameFindings frame;
    frame.number = i;
    frame.inside = 500;
    frame.offsetPx = Vec2{0.1F, -0.1F};
    frame.lightDrift = Lab{0.2F, 0.0F, 0.0F};
    film.frames.push_back(frame);
  }
  return film;
}

[[nodiscard]] std::vector<std::string> warningsOf(const FilmFindings& film) {
  return filmWarnings(film, Mask(film.size));
}

[[nodiscard]] ::testing::AssertionResult warnsOnlyOf(const FilmFindings& film,
                                                     const std::string& beginning) {
  const std::vector<std::string> warnings = warningsOf(film);
  if (warnings.size() == 1 && warnings[0].compare(0, beginning.size(), beginning) == 0) {
    return ::testing::AssertionSuccess();
  }
  ::testing::AssertionResult failure = ::testing::AssertionFailure();
  for (const std::string& warning : warnings) failure << warning << "\n";
  return failure;
}

TEST(FilmFindings, AFaultlessFilmWarnsOfNothing) { EXPECT_TRUE(warningsOf(faultless()).empty()); }

TEST(FilmFindings, NamesFramesAndFiguresOfShakeAndLight) {
  FilmFindings film = faultless();
  film.frames[3].offsetPx = Vec2{0.9F, -0.9F};
  film.frames[4].offsetPx = Vec2{3.0F, -4.25F};
  EXPECT_TRUE(warnsOnlyOf(film,
                          "camera: moved by more than 1 px in frames 4 to 5, in frame 5 by "
                          "3.0,-4.2 px since the bare surface was taken; "));
  film = faultless();
  film.frames[9].lightDrift = Lab{-3.0F, 0.0F, 0.0F};
  EXPECT_TRUE(
      warnsOnlyOf(film,
                  "light: in frame 10 the unpainted surface has another colour, in frame 10 "
                  "by 3.0 (lightness -3.0) of the threshold's 12.0; "));
  film.frames[9].lightDrift.reset();
  film.frames[9].offsetPx.reset();
  EXPECT_TRUE(warningsOf(film).empty());
}

TEST(FilmFindings, WarnsOfNothingAllAndTheBorder) {
  FilmFindings film = faultless();
  film.frames[0].inside = film.frames[1].inside = 0;  // the film begins before the paint
  EXPECT_TRUE(warningsOf(film).empty());
  EXPECT_EQ(filmReport(film).back(), "paint begins in frame 3: paint with --src-start 3");
  film.frames[6].inside = 0;
  EXPECT_TRUE(warnsOnlyOf(film, "nothing found in frame 7, though "));
  for (FrameFindings& frame : film.frames) frame.inside = 0;
  EXPECT_TRUE(warnsOnlyOf(film, "nothing found: no frame differs from the bare surface by 12.0 "));
  film = faultless();
  film.frames[8].inside = 4990;
  film.frames[8].touchesBorder = true;
  EXPECT_TRUE(warnsOnlyOf(film, "all is inside in frame 9: "));
  film.frames[8].inside = 600;
  EXPECT_TRUE(warnsOnlyOf(film, "the mask touches the picture's border in frame 9: "));
}

TEST(FilmFindings, PaintOfTheFirstFrameShowsAsAnIsland) {
  FilmFindings film = faultless();
  Mask painted(film.size);
  for (int y = 10; y < 30; ++y) {
    for (int x = 20; x < 60; ++x) painted(x, y) = x >= 30 && x < 40 && y >= 15 && y < 20 ? 0 : 1;
  }
  const std::vector<std::string> warnings = filmWarnings(film, painted);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].find("bare surface: 50 px within the paint are never painted, the largest "
                             "part of them from 30,15 down; "),
            0U)
      << warnings[0];
  film.smallestHolePx = 51;
  EXPECT_TRUE(filmWarnings(film, painted).empty());
  film.smallestHolePx = 10;
  film.surfaceIsFirstFrame = false;
  EXPECT_TRUE(filmWarnings(film, painted).empty());
}

TEST(FilmFindings, WarnsOfWhatNoMatteGives) {
  FilmFindings film = faultless();
  for (FrameFindings& frame : film.frames) frame.lighterPixels = 4;
  EXPECT_TRUE(warningsOf(film).empty());
  for (FrameFindings& frame : film.frames) frame.lighterPixels = 25;
  EXPECT_TRUE(warnsOnlyOf(film, "matte: 5.0 % of the paint is lighter than the bare surface, "));
}

TEST(FilmFindings, ListsFramesInRunsAndCutsLongLists) {
  EXPECT_EQ(frameListText({3}), "frame 3");
  EXPECT_EQ(frameListText({3, 4, 5, 9}), "frames 3 to 5, 9");
  EXPECT_EQ(frameListText({-1, 0}), "frames -1 to 0");
  std::vector<int> odd;
  for (int i = 1; i < 40; i += 2) odd.push_back(i);
  EXPECT_EQ(frameListText(odd), "frames 1, 3, 5, 7, 9, 11 and 14 more");
}

}  // namespace
}  // namespace fluidymation::test
