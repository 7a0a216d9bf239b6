// What the real program does not go on with: states, frames and options that do not belong
// together.

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "resumed_scene.h"

namespace fluidymation::test {
namespace {

class RefusedResume : public ResumedScene {};

TEST_F(RefusedResume, NamesTheOptionsAndFilesThatDiffer) {
  leaveState();
  const ToolOptions same = {{"--opt-iterations", "400"}};
  const std::string state = "out/.fluidymation/" + states().front();
  const std::string end = "); --restart discards it and begins anew";
  EXPECT_TRUE(failedWith(
      1, state + ": is the state of another run (--lambda was 2, now 3" + end,
      scene_.paint(quietly(resuming({{"--lambda", "3"}, {"--opt-iterations", "400"}})))));
  EXPECT_TRUE(failedWith(
      1, state + ": is the state of another run (--opt-iterations was 400, now 4,3,2" + end,
      scene_.paint(quietly(resuming()))));
  EXPECT_TRUE(failedWith(
      1, state + ": is the state of another run (--compression-level was 2, now 9" + end,
      scene_.paint(
          quietly(resuming({{"--compression-level", "9"}, {"--opt-iterations", "400"}})))));
  for (const char* input : {"src", "mask", "target"}) {
    const std::string name = SmallScene::frame(input, 6);
    const Bytes before = scene_.read(name);
    scene_.write(name, scene_.read(SmallScene::frame(input, 1)));
    const std::string option = input == std::string("mask") ? "src-mask" : input;
    EXPECT_TRUE(failedWith(
        1,
        state + ": is the state of another run (--" + option + "-path: frame 6 has changed" + end,
        scene_.paint(quietly(resuming(same)))));
    scene_.write(name, before);
  }
  scene_.remove(SmallScene::frame("target", 6));
  EXPECT_TRUE(failedNaming(1, state + ": is the state of another run (--target-frames was 6, now 5",
                           {"--target-path had 6 frames, 1 to 6, now has 5 frames, 1 to 5"},
                           scene_.paint(quietly(resuming(same)))));
}

TEST_F(RefusedResume, WhereTheStateIsDamaged) {
  leaveState();
  const ToolOptions same = {{"--opt-iterations", "400"}};
  const std::string state = "out/.fluidymation/" + states().front();
  const Bytes good = scene_.read(state);
  for (const std::size_t place :
       {std::size_t{0}, std::size_t{9}, good.size() / 2, good.size() - 1}) {
    Bytes bad = good;
    bad[place] = static_cast<std::uint8_t>(bad[place] ^ 1U);
    scene_.write(state, bad);
    EXPECT_TRUE(failedNaming(1, state + ": it is ", {"; --restart discards it and begins anew"},
                             scene_.paint(quietly(resuming(same)))));
  }
  scene_.write(state, Bytes(good.begin(), good.begin() + 100));
  EXPECT_TRUE(
      failedNaming(1, state + ": it is damaged", {}, scene_.paint(quietly(resuming(same)))));
}

TEST_F(RefusedResume, WhereAFrameIsNotAsItWasPainted) {
  leaveState();
  const ToolOptions same = {{"--opt-iterations", "400"}};
  const std::string first = SmallScene::frame("out", 1);
  const Bytes before = scene_.read(first);
  scene_.write(first, bytesOf("retouched"));
  EXPECT_TRUE(failedWith(1, first + ": has changed since it was painted; --restart paints all anew",
                         scene_.paint(quietly(resuming(same)))));
  EXPECT_EQ(scene_.read(first), bytesOf("retouched"));
  scene_.remove(first);
  EXPECT_TRUE(failedWith(1, first + ": is missing since it was painted; --restart paints all anew",
                         scene_.paint(quietly(resuming(same)))));
}

TEST_F(RefusedResume, AStoppedRunIsNeitherGoneOnWithNorDiscardedUnasked) {
  leaveState();
  EXPECT_TRUE(failedNaming(1, "out/.fluidymation: holds the state of a run that ended after ",
                           {" of 6 frames; wanted --resume to go on with it, or --restart to "
                            "discard it"},
                           scene_.paint(quietly(everyFrame({{"--opt-iterations", "400"}})))));
  // With other options it could not be gone on with
  EXPECT_TRUE(failedNaming(1, "out/.fluidymation/state-",
                           {": is the state of another run (--opt-iterations was 400, now 4,3,2); "
                            "--restart discards it and begins anew"},
                           scene_.paint(quietly(everyFrame()))));
  EXPECT_FALSE(states().empty());
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--restart", ""}}))).exitCode, 0);
  EXPECT_TRUE(isComplete());
}

TEST_F(RefusedResume, TogetherWithRestart) {
  EXPECT_TRUE(failedWith(2, "--resume, --restart: wanted one of them at most",
                         scene_.paint(quietly(resuming({{"--restart", ""}})))));
}

TEST_F(RefusedResume, FramesWithOtherNamesAreNotTakenForThese) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame())).exitCode, 0);
  EXPECT_TRUE(
      failedNaming(1, "out/fluidymation.json: is of the frames out/%05d.png, not of out/%04d.png",
                   {"wanted another name or folder"},
                   scene_.paint(quietly(everyFrame({{"--out-path", "out/%04d.png"}})))));
  EXPECT_EQ(scene_.read(kManifest), manifest_);
}

}  // namespace
}  // namespace fluidymation::test
