// Lines being drawn, through the program itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fluidymation/io/flow_file.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

constexpr int kFrames = 14;
const Size kTarget{60, 22};
const std::string kNote =
    "fluidymation: note: lines being drawn: new material looks fresh, what lies longer older "
    "(--new-material plain turns it off)\n";

Mask line(int number) {
  return maskOf(kTarget,
                [&](int x, int y) { return x >= 4 && x < 9 + 3 * number && y >= 7 && y < 15; });
}

/// A line that grows to the right.
class EndToEndNewMaterial : public ::testing::Test {
 protected:
  EndToEndNewMaterial() {
    for (int number = 1; number <= kFrames; ++number) {
      scene_.write(SmallScene::frame("target", number), maskPng(line(number)));
    }
  }

  /// Without what suits masks that are smoothed.
  [[nodiscard]] static ToolOptions options(const ToolOptions& more) {
    ToolOptions all = {{"--blur-sigma", "0"}, {"--time-blur-sigma", "1"}};
    all.insert(more.begin(), more.end());
    return all;
  }

  [[nodiscard]] Painting paint(const ToolOptions& more) const {
    return scene_.painting(options(more));
  }

  [[nodiscard]] bool noteIsGiven(const ToolOptions& more) const {
    const ProcessResult result = scene_.paint(options(more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const bool given = result.err.find(kNote) != std::string::npos;
    EXPECT_TRUE(given || result.err.find("lines being drawn") == std::string::npos);
    return given;
  }

  SmallScene scene_{kFrames, {24, 20}, kTarget};
};

TEST_F(EndToEndNewMaterial, IsFreshWhereLinesAreDrawnAndTheUserIsTold) {
  EXPECT_TRUE(noteIsGiven({}));
  EXPECT_FALSE(noteIsGiven({{"--new-material", "plain"}}));
  EXPECT_FALSE(noteIsGiven({{"--new-material", "fresh"}})) << "the user knows";
  EXPECT_FALSE(noteIsGiven({{"--preset", "thesis"}}));
  const Painting automatic = paint({});
  EXPECT_TRUE(automatic == paint({{"--new-material", "fresh"}}));
  EXPECT_TRUE(automatic != paint({{"--new-material", "plain"}}));
}

TEST_F(EndToEndNewMaterial, IsPlainInAllOtherAnimations) {
  const SmallScene disc(kFrames, {24, 20}, kTarget);
  EXPECT_TRUE(disc.painting() == disc.painting({{"--new-material", "plain"}}));
  const ToolOptions backwards = {{"--target-start", std::to_string(kFrames)},
                                 {"--target-speed", "-1"}};
  EXPECT_FALSE(noteIsGiven(backwards)) << "a line that vanishes";
  EXPECT_FALSE(noteIsGiven({{"--target-frames", "1"}}));
}

TEST_F(EndToEndNewMaterial, TheNumberOfThreadsDoesNotShow) {
  EXPECT_TRUE(paint({{"--threads", "1"}}) == paint({{"--threads", "3"}}));
}

TEST_F(EndToEndNewMaterial, SingleAndEmptyFramesArePainted) {
  for (const ToolOptions& few :
       {ToolOptions{{"--target-frames", "1"}}, ToolOptions{{"--src-frames", "1"}},
        ToolOptions{{"--src-frames", "1"}, {"--target-frames", "1"}}}) {
    ToolOptions fresh = few;
    fresh["--new-material"] = "fresh";
    scene_.remove("out");
    (void)paint(fresh);
    EXPECT_TRUE(isPaintedExactly(scene_.file("out/00001.png"), line(1)));
  }
  scene_.write("target/00001.png", maskPng(Mask(kTarget)));
  scene_.write("target/00006.png", maskPng(Mask(kTarget)));
  (void)paint({{"--new-material", "fresh"}});
  for (int number = 1; number <= kFrames; ++number) {
    const Mask mask = number == 1 || number == 6 ? Mask(kTarget) : line(number);
    EXPECT_TRUE(isPaintedExactly(scene_.file(SmallScene::frame("out", number)), mask)) << number;
  }
}

TEST_F(EndToEndNewMaterial, IsFoundByTheFlowThatIsGiven) {
  for (int number = 1; number <= kFrames; ++number) {
    const Mask before = line(std::max(1, number - 1));
    Image<Vec2> flow(kTarget);
    for (std::size_t i = 0; i < flow.pixelCount(); ++i) {
      if (before.data()[i] == 0) flow.data()[i] = {3.0F, 0.0F};
    }
    const std::string name = SmallScene::frame("flow", number);
    scene_.write(name, {});
    writeFlow(scene_.file(name.substr(0, name.size() - 3) + "flo"), flow);
  }
  EXPECT_TRUE(noteIsGiven({{"--target-flow-path", "flow/%05d.flo"}}));
}

TEST_F(EndToEndNewMaterial, AgesAreDumpedWhereTheyGuide) {
  (void)paint({{"--dump-guides", "dump"}});
  for (const std::string name : {"source/00001.age.pfm", "target/00014.age.pfm"}) {
    EXPECT_FALSE(scene_.read("dump/" + name).empty()) << name;
  }
  scene_.remove("dump");
  (void)paint({{"--dump-guides", "dump"}, {"--new-material", "plain"}});
  for (const std::string& name : scene_.names("dump/target")) {
    EXPECT_EQ(name.find("age"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace fluidymation::test
