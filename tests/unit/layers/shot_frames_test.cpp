#include "layers/shot_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using Numbers = std::vector<int>;

TEST(ShotFrames, AreThoseOfAllLayersAscending) {
  EXPECT_EQ(shotFrames({{"a", {3, 4, 5}}}), (Numbers{3, 4, 5}));
  EXPECT_EQ(shotFrames({{"a", {5, 4, 3}}, {"b", {4, 5, 6}}}), (Numbers{3, 4, 5, 6}));
  EXPECT_EQ(shotFrames({{"a", {1, 2}}, {"b", {7, 8}}}), (Numbers{1, 2, 7, 8}));
}

TEST(ShotFrames, RefuseALayerThatIsMissingInBetween) {
  const std::string fault = test::messageOf<Error>([] {
    (void)shotFrames({{"a", {1, 2, 3, 4}}, {"b", {1, 3}}});
  });
  EXPECT_EQ(fault,
            "layer b: has frames 1 to 3 but no frame 2, which layer a has; wanted the same steps, "
            "see --target-speed and --target-range");
}

TEST(ShotFrames, MayHaveStepsWhereAllLayersDo) {
  EXPECT_EQ(shotFrames({{"a", {1, 3, 5}}, {"b", {3, 5, 7}}}), (Numbers{1, 3, 5, 7}));
}

TEST(ShotFrames, ShowALayerFromItsFirstFrameToItsLast) {
  for (const LayerFrames& layer : {LayerFrames{"a", {3, 5, 7}}, LayerFrames{"b", {7, 5, 3}}}) {
    for (const int number : {3, 5, 7}) EXPECT_TRUE(isSeen(layer, number));
    for (const int number : {1, 9, -5}) EXPECT_FALSE(isSeen(layer, number));
  }
  EXPECT_TRUE(isSeen({"c", {4}}, 4));
  EXPECT_FALSE(isSeen({"c", {4}}, 5));
}

/// Looking through a layer for each frame would take hours.
TEST(ShotFrames, MayBeAMillion) {
  LayerFrames layer{"a", Numbers(1'000'000)};
  std::iota(layer.numbers.begin(), layer.numbers.end(), 1);
  const LayerFrames late{"b", {900'001, 900'002}};
  const Numbers shot = shotFrames({layer, late});
  const auto seen = [&shot](const LayerFrames& frames) {
    return std::count_if(shot.begin(), shot.end(), [&](int n) { return isSeen(frames, n); });
  };
  EXPECT_EQ(seen(layer), 1'000'000);
  EXPECT_EQ(seen(late), 2);
}

TEST(ShotFrames, SayWhichLayersAreShorter) {
  EXPECT_EQ(notesOnLengths({{"a", {1, 2, 3}}, {"b", {3, 2}}, {"c", {3}}}, {1, 2, 3}),
            (std::vector<std::string>{
                "layer b: frames 2 to 3 of the shot's 1 to 3; it is not seen in the others",
                "layer c: frames 3 of the shot's 1 to 3; it is not seen in the others"}));
}

}  // namespace
}  // namespace fluidymation
