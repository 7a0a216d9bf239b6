// Shots in layers, painted by the real program.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include "support/sanitizers.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

constexpr int kFrames = 3;

/// A small scene in two layers: a disc that moves, and over it one that moves back, in red.
class LayeredShotTest : public ::testing::Test {
 protected:
  LayeredShotTest() : scene_(kFrames) {
    for (int number = 1; number <= kFrames; ++number) {
      scene_.write(SmallScene::frame("back", number),
                   maskPng(scene_.targetMask(kFrames + 1 - number)));
    }
    writeShot("");
  }

  /// @param more    lines of the upper layer.
  /// @param shared  lines above the layers.
  void writeShot(const std::string& more, const std::string& shared = "",
                 const std::string& background = "exemplar") const {
    scene_.write("shot.toml", bytesOf(shared +
                                      "out-path = \"shot/%05d.png\"\n"
                                      "background = \"" +
                                      background +
                                      "\"\n"
                                      "src-path = \"src/%05d.png\"\n"
                                      "src-mask-path = \"mask/%05d.png\"\n"
                                      "blur-sigma = 1\n"
                                      "border-width = 3\n"
                                      "checkpoint-every = 1\n"
                                      "[layer.low]\n"
                                      "target-path = \"target/%05d.png\"\n"
                                      "[layer.high]\n"
                                      "target-path = \"back/%05d.png\"\n"
                                      "recolor = \"#c01010\"\n" +
                                      more));
  }

  [[nodiscard]] ProcessResult run(const std::vector<std::string>& more = {},
                                  ProcessSetup setup = {}) const {
    setup.workingFolder = scene_.file("");
    std::vector<std::string> arguments = {"layers", "shot.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProcess(FLUIDYMATION_PROGRAM, arguments, setup);
  }

  /// Goes on, until it gets that signal just before so many calls to the disk.
  [[nodiscard]] ProcessResult runToCall(int call, int signal) const {
    ProcessSetup setup;
    setup.environment = {{"LD_PRELOAD", FLUIDYMATION_KILL_AT_CALL},
                         {"FLUIDYMATION_KILL_AT", std::to_string(call)},
                         {"FLUIDYMATION_KILL_SIGNAL", std::to_string(signal)}};
    return run({"--quiet", "--resume"}, setup);
  }

  using Painting = SmallScene::Painting;

  /// The frames of the shot and of both layers, with their manifests.
  [[nodiscard]] std::vector<Painting> painted() const {
    std::vector<Painting> all;
    for (const char* folder : {"shot", "shot/layers/low", "shot/layers/high"}) {
      all.push_back(filesOf(scene_.file(folder)));
      all.back()["manifest"] = scene_.read(std::string(folder) + "/fluidymation.json");
    }
    return all;
  }

  SmallScene scene_;
};

TEST_F(LayeredShotTest, GivesTheSameBytesOnAnyNumberOfThreads) {
  std::vector<Painting> first;
  for (const char* threads : {"1", "2", "3"}) {
    scene_.remove("shot");
    const ProcessResult result = run({"--quiet", "--threads", threads});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    if (first.empty()) first = painted();
    EXPECT_TRUE(painted() == first) << threads;
  }
  EXPECT_EQ(first[0].size(), std::size_t{kFrames + 1});
}

TEST_F(LayeredShotTest, PaintsEachLayerAsARunOfItsOwn) {
  ASSERT_EQ(run({"--quiet"}).exitCode, 0);
  const ProcessResult alone = scene_.paintWithoutDefaults({{"--src-path", "src/%05d.png"},
                                                           {"--src-mask-path", "mask/%05d.png"},
                                                           {"--target-path", "back/%05d.png"},
                                                           {"--blur-sigma", "1"},
                                                           {"--border-width", "3"},
                                                           {"--recolor", "#c01010"},
                                                           {"--out-path", "alone/%05d.png"},
                                                           {"--quiet", ""}});
  ASSERT_EQ(alone.exitCode, 0) << alone.err;
  EXPECT_TRUE(filesOf(scene_.file("alone")) == filesOf(scene_.file("shot/layers/high")));
}

TEST_F(LayeredShotTest, SaysWhichLayerIsPainted) {
  const ProcessResult result = run();
  ASSERT_EQ(result.exitCode, 0) << result.err;
  std::size_t place = 0;
  for (const char* line :
       {"layer low (1 of 2): painting 3 frames ...\n", "layer low (1 of 2): frame 3 of 3  ",
        "layer high (2 of 2): painting 3 frames ...\n", "layer high (2 of 2): frame 3 of 3  ",
        "composite: frame 3 of 3  "}) {
    const std::size_t found = result.err.find(line, place);
    ASSERT_NE(found, std::string::npos) << line << result.err;
    place = found;
  }
}

TEST_F(LayeredShotTest, TellsHumansWhereTheCommandLineSaysSoAndTheFileElse) {
  writeShot("", "progress = \"json\"\n");
  const ProcessResult asFile = run();
  ASSERT_EQ(asFile.exitCode, 0) << asFile.err;
  EXPECT_EQ(asFile.out.find("{"), 0U) << asFile.out;
  const ProcessResult told = run({"--progress", "human"});
  ASSERT_EQ(told.exitCode, 0) << told.err;
  EXPECT_EQ(told.out, "");
  EXPECT_NE(told.err.find("composite: frame 3 of 3  "), std::string::npos) << told.err;
}

TEST_F(LayeredShotTest, AfterAKillAnywhereGoesOnToTheSameBytes) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's runtime has to be loaded first";
  ASSERT_EQ(run({"--quiet"}).exitCode, 0);
  const std::vector<Painting> whole = painted();
  constexpr int kStep = 11;  // calls to the disk between the places where it is killed
  bool killed = true;
  int kills = 0;
  for (int call = 1; killed; call += kStep) {
    SCOPED_TRACE("killed at call " + std::to_string(call));
    scene_.remove("shot");
    ProcessSetup setup;
    setup.environment = {{"LD_PRELOAD", FLUIDYMATION_KILL_AT_CALL},
                         {"FLUIDYMATION_KILL_AT", std::to_string(call)}};
    killed = run({"--quiet"}, setup).signal == SIGKILL;
    kills += killed ? 1 : 0;
    const ProcessResult result = run({"--quiet", "--resume"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    ASSERT_TRUE(painted() == whole);
  }
  EXPECT_GT(kills, kFrames);
}

TEST_F(LayeredShotTest, StoppedInTheSecondLayerSaysHowToGoOn) {
  writeShot("opt-iterations = 200\n");
  ProcessSetup setup;
  setup.signalAfterOutput = SIGINT;
  setup.linesBeforeSignal = 8;  // low: memory, begin, 3 frames, end; high: memory, begin
  const ProcessResult stopped = run({}, setup);
  EXPECT_EQ(stopped.exitCode, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("fluidymation: layer high: interrupted; "), std::string::npos)
      << stopped.err;
  EXPECT_NE(stopped.err.find("go on with: "), std::string::npos) << stopped.err;
  EXPECT_NE(stopped.err.find("layers shot.toml --resume\n"), std::string::npos) << stopped.err;
  const ProcessResult result = run({"--resume"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_NE(result.err.find("layer low (1 of 2): all frames are painted already"),
            std::string::npos);
  const std::vector<Painting> resumed = painted();
  scene_.remove("shot");
  ASSERT_EQ(run({"--quiet"}).exitCode, 0);
  EXPECT_TRUE(painted() == resumed);
}

TEST_F(LayeredShotTest, ResumedAfterAChangePaintsWhatHasChangedOnly) {
  ASSERT_EQ(run({"--quiet"}).exitCode, 0);
  const std::vector<Painting> before = painted();
  writeShot("seed = 4\n");
  const ProcessResult result = run({"--resume"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_NE(result.err.find("layer low (1 of 2): all frames are painted already"),
            std::string::npos);
  EXPECT_TRUE(painted()[1] == before[1]);
  EXPECT_FALSE(painted()[2] == before[2]);
  EXPECT_FALSE(painted()[0] == before[0]);
}

TEST_F(LayeredShotTest, OffersNoWayOutThatLayersLack) {
  ASSERT_EQ(run({"--quiet"}).exitCode, 0);
  for (const char* folder : {"shot", "shot/layers/low"}) {
    const std::string frame = SmallScene::frame(folder, 2);
    const Bytes painted = scene_.read(frame);
    scene_.write(frame, scene_.read(SmallScene::frame("target", 2)));
    const ProcessResult result = run({"--quiet"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find(frame +
                              ": is there already, and not as a run that is recorded there "
                              "has painted it; wanted --overwrite to replace, or another out-path "
                              "above the first layer\n"),
              std::string::npos)
        << result.err;
    scene_.write(frame, painted);
  }
}

TEST_F(LayeredShotTest, StoppedInTheCompositeAfterAChangeGoesOn) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's runtime has to be loaded first";
  writeShot("", "", "#204060");
  ASSERT_EQ(run({"--quiet"}).exitCode, 0);
  const std::vector<Painting> whole = painted();
  for (const int signal : {SIGINT, SIGKILL}) {
    bool ended = true;
    int stops = 0;
    for (int call = 1; ended; call += 4) {
      SCOPED_TRACE("signal " + std::to_string(signal) + " at call " + std::to_string(call));
      writeShot("");
      ASSERT_EQ(run({"--quiet", "--resume"}).exitCode, 0);
      ASSERT_FALSE(painted()[0] == whole[0]);
      writeShot("", "", "#204060");
      const ProcessResult stopped = runToCall(call, signal);
      ended = stopped.exitCode != 0;
      stops += ended ? 1 : 0;
      const ProcessResult result = run({"--quiet", "--resume"});
      ASSERT_EQ(result.exitCode, 0) << result.err;
      ASSERT_TRUE(painted() == whole);
      ASSERT_EQ(scene_.names("shot/.fluidymation"), std::vector<std::string>{"times.json"});
    }
    EXPECT_GE(stops, kFrames);
  }
}

TEST_F(LayeredShotTest, DoesNotReplaceACompositeThatWasRetouchedMeanwhile) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's runtime has to be loaded first";
  ASSERT_EQ(run({"--quiet"}).exitCode, 0);
  const Painting before = painted()[0];
  writeShot("", "", "#204060");
  for (int call = 1; filesOf(scene_.file("shot")).at("00001.png") == before.at("00001.png");
       ++call) {
    ASSERT_EQ(runToCall(call, SIGKILL).signal, SIGKILL);
  }
  EXPECT_EQ(scene_.read("shot/00003.png"), before.at("00003.png"));
  scene_.write("shot/00003.png", bytesOf("retouched"));
  const Painting stopped = filesOf(scene_.file("shot"));
  writeShot("seed = 5\n", "", "#204060");
  scene_.remove("shot/layers/high");
  EXPECT_TRUE(failedNaming(1, "shot/00003.png: is there already, and not as a run",
                           {"wanted --overwrite"}, run({"--quiet", "--resume"})));
  EXPECT_TRUE(filesOf(scene_.file("shot")) == stopped);
  EXPECT_TRUE(scene_.names("shot/layers/high").empty());  // before any layer is painted
}

TEST_F(LayeredShotTest, PaintsNothingWhereAnyLayerIsWrong) {
  scene_.remove("back");
  const ProcessResult result = run({"--quiet"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.err.find("error: layer high: back/00001.png: "), std::string::npos)
      << result.err;
  EXPECT_TRUE(scene_.names("shot").empty());
}

TEST_F(LayeredShotTest, WantsOneFile) {
  const auto fault = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result = runProcess(FLUIDYMATION_PROGRAM, arguments);
    EXPECT_EQ(result.exitCode, 2);
    return result.err;
  };
  EXPECT_EQ(fault({"layers"}),
            "fluidymation: error: SHOT.toml: the file is missing (see --help)\n");
  EXPECT_NE(fault({"layers", "a.toml", "b.toml"}).find("error: argument b.toml: belongs to no"),
            std::string::npos);
  EXPECT_NE(fault({"layers", "a.toml", "--seed", "3"}).find("error: option --seed: there is no"),
            std::string::npos);
}

}  // namespace
}  // namespace fluidymation::test
