// That windows painted in both directions of time can be stopped, split and dumped as any frames.

#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

/// Eleven frames painted in windows of eight, in both directions of time.
class ResumeInWindows : public ::testing::Test {
 protected:
  ResumeInWindows() : expected_(scene_.painting(options_)) {
    EXPECT_EQ(expected_.size(), std::size_t{11});
    scene_.remove("out");
  }

  [[nodiscard]] ToolOptions with(ToolOptions more) const {
    more.insert(options_.begin(), options_.end());
    return more;
  }

  /// Paints with these options besides; @return  all that is there then.
  [[nodiscard]] Painting painted(const ToolOptions& more) const {
    const ProcessResult result = scene_.paint(quietly(with(more)));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return filesOf(scene_.file("out"));
  }

  SmallScene scene_{11};
  ToolOptions options_ = {{"--temporal-coherence", "bidirectional"},
                          {"--checkpoint-every", "1"},
                          {"--src-frames", "11"},
                          {"--target-frames", "11"}};
  Painting expected_;
};

TEST_F(ResumeInWindows, AfterAKillGivesTheSameBytes) {
  for (const int frames : {1, 7, 8}) {  // the last three end too soon after one another to be hit
    SCOPED_TRACE(std::to_string(frames) + " frames");
    scene_.remove("out");
    ProcessSetup setup;
    setup.signalAfterOutput = SIGKILL;
    setup.linesBeforeSignal = 2 + frames;  // of memory, and that painting begins
    EXPECT_EQ(scene_.paint(options_, setup).signal, SIGKILL);
    EXPECT_EQ(painted({{"--resume", ""}, {"--threads", frames % 2 == 0 ? "1" : "2"}}), expected_);
  }
}

TEST_F(ResumeInWindows, PartsAreThoseOfTheWhole) {
  Painting first = painted({{"--render-frames", "1-5"}});
  EXPECT_EQ(first.size(), 5U);
  EXPECT_EQ(painted({{"--render-frames", "6-11"}}), expected_);
  scene_.remove("out");
  EXPECT_EQ(painted({{"--render-frames", "1-5"}}), first);
  EXPECT_EQ(painted({{"--resume", ""}}), expected_);
}

TEST_F(ResumeInWindows, DumpsAreThoseOfTheFramesInOrder) {
  EXPECT_EQ(painted({{"--dump-guides", scene_.file("dump")}}), expected_);
  const Painting dump = filesOf(scene_.file("dump/target"));
  scene_.remove("out");
  (void)painted({{"--dump-guides", scene_.file("forward")}, {"--temporal-coherence", "forward"}});
  const Painting forward = filesOf(scene_.file("forward/target"));
  ASSERT_EQ(dump.size(), forward.size());
  for (const auto& [name, bytes] : dump) {
    const bool isOfMatches =
        name.find("nnf") != std::string::npos || name.find("theta") != std::string::npos;
    if (isOfMatches) continue;
    EXPECT_EQ(bytes, forward.at(name)) << name;
  }
  EXPECT_NE(dump.at("00003.nnf.pfm"), forward.at("00003.nnf.pfm"));
  EXPECT_EQ(dump.at("00008.nnf.pfm"), forward.at("00008.nnf.pfm"));
}

}  // namespace
}  // namespace fluidymation::test
