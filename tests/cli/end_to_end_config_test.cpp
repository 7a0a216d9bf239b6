// Options from files, folders and ranges, with the real program.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

ToolOptions changed(const ToolOptions& options) {
  ToolOptions all = SmallScene::defaults();
  for (const auto& [name, value] : options) all[name] = value;
  return all;
}

TEST(EndToEndConfig, AManifestIsReplayedToTheSameBytes) {
  for (const char* preset : {"standard", "paper"}) {
    const SmallScene scene;
    const SmallScene::Painting painting =
        scene.painting({{"--preset", preset}, {"--seed", "5"}, {"--lambda", "1"}});
    const std::string manifest = scene.file("out/fluidymation.json");
    const ProcessResult result = scene.paintWithoutDefaults(
        {{"--config", manifest}, {"--out-path", "again/%05d.png"}, {"--quiet", ""}});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(filesOf(scene.file("again")), painting);
    EXPECT_NE(scene.painting(), painting);
  }
}

TEST(EndToEndConfig, APipeIsReadToItsEndAndNeverWaitedForInVain) {
  const SmallScene scene;
  const std::string pipe = scene.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto painting = [&pipe](const ToolOptions& more) {
    ToolOptions options = changed({{"--config", pipe}, {"--quiet", ""}});
    options.insert(more.begin(), more.end());
    return argumentsOf(options);
  };
  ProcessSetup setup;
  setup.workingFolder = scene.file(".");
  EXPECT_TRUE(failedWith(1, pipe + ": is a pipe that nobody writes into; wanted a config file",
                         runProcess(FLUIDYMATION_PROGRAM, painting({}), setup)));

  // A writer that says nothing is waited for, until a signal comes
  const int silent = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(silent, 0);
  std::vector<std::string> arguments = {"--preserve-status", "--signal=TERM", "0.5",
                                        FLUIDYMATION_PROGRAM};
  for (const std::string& argument : painting({})) arguments.push_back(argument);
  const ProcessResult stopped = runProcess("/usr/bin/timeout", arguments, setup);
  close(silent);
  EXPECT_EQ(stopped.exitCode, 143) << stopped.err;
  EXPECT_EQ(stopped.err, "fluidymation: interrupted while " + pipe + " was read\n");
  EXPECT_LT(stopped.seconds, 10.0);

  // One that takes its time is heard out, also where the shell names the pipe
  const std::string slowly = "(sleep 0.3; echo 'seed = 5'; sleep 0.3; echo 'lambda = 1')";
  std::string command = slowly + " | " + FLUIDYMATION_PROGRAM;
  for (const std::string& argument :
       argumentsOf(changed({{"--config", "/dev/stdin"}, {"--quiet", ""}}))) {
    command += " '" + argument + "'";
  }
  const ProcessResult result = runProcess("/bin/sh", {"-c", command}, setup);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(filesOf(scene.file("out")), scene.painting({{"--seed", "5"}, {"--lambda", "1"}}));
}

TEST(EndToEndConfig, WhatIsNeitherAFileNorAPipeIsRefused) {
  const SmallScene scene;
  EXPECT_TRUE(failedWith(1, "/dev/zero: is no regular file; wanted a config file",
                         scene.paint({{"--config", "/dev/zero"}})));
  EXPECT_TRUE(
      failedWith(1, "src: is a folder; wanted a config file", scene.paint({{"--config", "src"}})));
}

TEST(EndToEndConfig, WhatIsPrintedPaintsTheSame) {
  const SmallScene scene;
  const SmallScene::Painting painting = scene.painting({{"--seed", "5"}});
  const ToolOptions wanted =
      changed({{"--seed", "5"}, {"--out-path", "again/%05d.png"}, {"--print-config", ""}});
  const ProcessResult printed = scene.paintWithoutDefaults(wanted);
  EXPECT_EQ(printed.exitCode, 0) << printed.err;
  EXPECT_EQ(printed.err, "");
  EXPECT_FALSE(fs::exists(scene.file("again")));
  scene.write("shot.toml", bytesOf(printed.out));
  const ProcessResult result =
      scene.paintWithoutDefaults({{"--config", "shot.toml"}, {"--quiet", ""}});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(filesOf(scene.file("again")), painting);
}

TEST(EndToEndConfig, AFaultOfTheFileIsWrongUsage) {
  const SmallScene scene;
  scene.write("shot.toml", bytesOf("# a shot\nlamda = 3\n"));
  EXPECT_TRUE(failedWith(2,
                         "shot.toml: line 2: lamda: there is no such option; did you mean lambda?",
                         scene.paint({{"--config", "shot.toml"}})));
}

TEST(EndToEndConfig, FoldersAndHashesPaintAsPatternsDo) {
  const SmallScene scene;
  const SmallScene::Painting painting = scene.painting();
  EXPECT_EQ(scene.painting({{"--src-path", "src"},
                            {"--src-mask-path", "mask/"},
                            {"--target-path", "target/#####.png"},
                            {"--out-path", "folder"}}),
            SmallScene::Painting());  // none is painted into out
  EXPECT_EQ(filesOf(scene.file("folder")), painting);
}

TEST(EndToEndConfig, ARangePaintsWhatItNames) {
  const SmallScene scene(6);
  scene.write("x.toml", bytesOf("target-range = 2-6x2\n"));
  ToolOptions options = quietly(changed({{"--config", "x.toml"}}));
  options.erase("--target-frames");
  EXPECT_EQ(scene.paintWithoutDefaults(options).exitCode, 0);
  EXPECT_EQ(scene.names("out"), (std::vector<std::string>{"00002.png", "00004.png", "00006.png"}));
  options["--target-range"] = "2-10x2";
  options["--out-path"] = "more/%05d.png";
  EXPECT_TRUE(failedWith(1,
                         "--target-path target/%05d.png: 2 frames are missing: 8-10; frames 2 to "
                         "10 in steps of 2 were asked for",
                         scene.paintWithoutDefaults(options)));
}

TEST(EndToEndConfig, FaultsOfAllSequencesAreListedAtOnce) {
  const SmallScene scene;
  scene.remove("src/00002.png");
  scene.remove("mask/00003.png");
  scene.write("target/00002.png", maskPng(Mask(Size{13, 11}, 1)));
  scene.write("target/00004.png", bytesOf("no picture"));
  const ProcessResult result =
      scene.paint({{"--target-flow-path", "flow/%d.flo"}, {"--quiet", ""}});
  EXPECT_EQ(result.exitCode, 1);
  for (const char* fault :
       {"error: --src-path src/%05d.png: 1 frame is missing although later ones exist: 2;",
        "error: --src-mask-path mask/%05d.png: 1 frame is missing although later ones exist: 3;",
        "error: target/00002.png: size 13x11, but target/00001.png is ",
        "error: target/00004.png: is no PNG file"}) {
    EXPECT_NE(result.err.find("fluidymation: " + std::string(fault)), std::string::npos)
        << fault << "\n"
        << result.err;
  }
  EXPECT_EQ(scene.names("out"), kNothing);
}

}  // namespace
}  // namespace fluidymation::test
