#include "layers/shot_frames.h"

#include <gtest/gtest.h>

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

TEST(ShotFrames, SayWhichLayersAreShorter) {
  EXPECT_EQ(notesOnLengths({{"a", {1, 2, 3}}, {"b", {3, 2}}, {"c", {3}}}, {1, 2, 3}),
            (std::vector<std::string>{
                "layer b: frames 2 to 3 of the shot's 1 to 3; it is not seen in the others",
                "layer c: frames 3 of the shot's 1 to 3; it is not seen in the others"}));
}

}  // namespace
}  // namespace fluidymation
