#include "pipeline/film_window.h"

#include <gtest/gtest.h>

#include <tuple>

#include "fluidymation/synthesis/bidirectional_painter.h"

namespace fluidymation {
namespace {

FilmWindow window(int held, int film, int target,
                  TemporalCoherence coherence = TemporalCoherence::kForward) {
  Options options;
  options.sourceWindowFrames = held;
  options.synthesis.temporalCoherence = coherence;
  return {options, film, target};
}

TEST(FilmWindow, HoldsTheWholeFilmUnlessItHasMoreFrames) {
  for (const int held : {0, 30, 31, 1000}) {
    EXPECT_TRUE(window(held, 30, 50).isWhole()) << held;
    EXPECT_EQ(window(held, 30, 50).heldFrames(), 30) << held;
    EXPECT_EQ(window(held, 30, 50).beginFor(49), 0) << held;
  }
  EXPECT_FALSE(window(29, 30, 50).isWhole());
  EXPECT_EQ(window(29, 30, 50).heldFrames(), 29);
}

TEST(FilmWindow, GoesFromTheFilmsBeginToItsEndInEvenSteps) {
  for (const auto& [held, film, target] :
       {std::tuple{10, 30, 50}, {10, 30, 5}, {2, 1000, 3}, {29, 30, 1000}, {10, 30, 2}}) {
    const FilmWindow tested = window(held, film, target);
    EXPECT_EQ(tested.beginFor(0), 0);
    EXPECT_EQ(tested.beginFor(target - 1), film - held);
    const double step = static_cast<double>(film - held) / (target - 1);
    for (int j = 0; j < target; ++j) EXPECT_NEAR(tested.beginFor(j), step * j, 0.5);
  }
  EXPECT_EQ(window(10, 30, 1).beginFor(0), 0);
}

TEST(FilmWindow, FramesThatAreRevisedTogetherHoldTheSame) {
  const FilmWindow tested = window(10, 30, 50, TemporalCoherence::kBidirectional);
  for (int j = 0; j < 50; ++j) {
    EXPECT_EQ(tested.beginFor(j), tested.beginFor(j / kWindowFrames * kWindowFrames)) << j;
  }
  EXPECT_EQ(tested.beginFor(0), 0);
  EXPECT_GT(tested.beginFor(kWindowFrames), 0);
  EXPECT_EQ(tested.beginFor(49), 20);
}

}  // namespace
}  // namespace fluidymation
