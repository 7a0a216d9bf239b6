// `fluidymation inspect`, run as users run it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

/// Runs `fluidymation inspect` in the scene's folder, with the scene's options changed by
/// `options`.
ProcessResult inspected(const SmallScene& scene, const ToolOptions& options = {}) {
  ToolOptions all = SmallScene::defaults();
  for (const auto& [name, value] : options) all[name] = value;
  std::vector<std::string> arguments = argumentsOf(all);
  arguments.insert(arguments.begin(), "inspect");
  ProcessSetup setup;
  setup.workingFolder = scene.file(".");
  return runProcess(FLUIDYMATION_PROGRAM, arguments, setup);
}

TEST(EndToEndInspect, ReadsAllFilesAndWritesNone) {
  const SmallScene scene;
  const ProcessResult result = inspected(scene, {{"--dump-guides", "dump"}});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.out.find("files: all 12 can be read"), std::string::npos) << result.out;
  EXPECT_FALSE(std::filesystem::exists(scene.file("out")));
  EXPECT_FALSE(std::filesystem::exists(scene.file("dump")));
}

TEST(EndToEndInspect, TellsSizesAndWritesPictures) {
  const SmallScene scene;
  const ProcessResult result = inspected(scene, {{"--guides", "guides"}});
  EXPECT_EQ(result.exitCode, 0);
  for (const char* part :
       {"exemplar: 24x20, 4 frames (1 to 4), masks black and white\n",
        "animation: 28x22, 4 frames (1 to 4), masks black and white\n", "memory: at most ",
        "time: ", "pictures in guides/exemplar: full intensity is "}) {
    EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
  }
  for (const char* folder : {"guides/exemplar", "guides/animation"}) {
    EXPECT_EQ(scene.names(folder).size(), 4U * 5U) << folder;
  }
}

TEST(EndToEndInspect, PicturesReplaceNoInput) {
  const SmallScene scene;
  std::filesystem::create_directory(scene.file("guides"));
  for (int number = 1; number <= 4; ++number) {
    const std::string name = std::to_string(number) + ".flow.png";
    scene.write("mask/0000" + name, scene.read(SmallScene::frame("mask", number)));
  }
  std::filesystem::rename(scene.file("mask"), scene.file("guides/exemplar"));
  const ToolOptions options = {{"--guides", "guides"},
                               {"--src-mask-path", "guides/exemplar/%05d.flow.png"}};
  EXPECT_TRUE(failedWith(2,
                         "--guides guides: guides/exemplar/00001.flow.png is an input and would be "
                         "overwritten; choose another folder",
                         inspected(scene, quietly(options))));
}

TEST(EndToEndInspect, ListsAllFaultsOfTheFiles) {
  const SmallScene scene;
  scene.write("src/00002.png", {});
  scene.remove("mask/00003.png");
  Bytes damaged = scene.read("target/00004.png");
  damaged.resize(damaged.size() / 2);
  scene.write("target/00004.png", damaged);
  const ProcessResult result = inspected(scene);
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.out, "");
  for (const char* part :
       {"error: src/00002.png: ", "error: --src-mask-path mask/%05d.png: 1 frame",
        "error: target/00004.png: "}) {
    EXPECT_NE(result.err.find(part), std::string::npos) << part << "\n" << result.err;
  }
}

TEST(EndToEndInspect, ChecksTheOutputWhereItIsGiven) {
  const SmallScene scene;
  const ProcessResult result = inspected(scene, {{"--out-path", "target/%05d.png"}});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.err.find("--out-path target/%05d.png: target/00001.png is an input"),
            std::string::npos)
      << result.err;
}

TEST(EndToEndInspect, WrongUsageIsTold) {
  const SmallScene scene;
  EXPECT_TRUE(failedWith(2, "--mask-threshold 0.7: wanted a number in (0, 0.5]",
                         inspected(scene, {{"--mask-threshold", "0.7"}})));
}

}  // namespace
}  // namespace fluidymation::test
