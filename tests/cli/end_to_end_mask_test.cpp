// `fluidymation mask`, run as users run it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "fluidymation/io/png.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

/// Runs `fluidymation mask` in the scene's folder.
ProcessResult masked(const SmallScene& scene, const ToolOptions& options) {
  std::vector<std::string> arguments = argumentsOf(options);
  arguments.insert(arguments.begin(), "mask");
  ProcessSetup setup;
  setup.workingFolder = scene.file(".");
  return runProcess(FLUIDYMATION_PROGRAM, arguments, setup);
}

/// The scene's own disc is there from the first frame on.
[[nodiscard]] ToolOptions withDisc(ToolOptions options = {}) {
  options.insert({{"--src-path", "src/%05d.png"},
                  {"--out-path", "made/%05d.png"},
                  {"--bare-paint", "mask/00001.png"}});
  return options;
}

TEST(EndToEndMask, WritesMasksAndSaysWhatItDid) {
  const SmallScene scene;
  const ProcessResult result = masked(scene, withDisc({{"--sheet", "sheet.png"},
                                                       {"--matte", "multiply"},
                                                       {"--matte-path", "matte/%05d.png"}}));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(scene.names("made"), kFourFrames);
  EXPECT_EQ(scene.names("matte"), kFourFrames);
  EXPECT_TRUE(std::filesystem::exists(scene.file("sheet.png")));
  EXPECT_EQ(result.out.find("film: 24x20, 4 frames\nbare surface: frame 1, filled in under "
                            "mask/00001.png\nthreshold: "),
            0U)
      << result.out;
  const Mask wanted = scene.sourceMask(4);
  const Image<float> made = readCoverage(scene.file("made/00004.png"), MaskChannel::kBrightness);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < made.pixelCount(); ++i) {
    differing += (made.data()[i] >= 0.5F) != (wanted.data()[i] != 0) ? 1 : 0;
  }
  EXPECT_LT(differing, countInside(wanted) / 3);  // of a disc a few pixels wide
}

TEST(EndToEndMask, WarnsOnStandardErrorUnlessQuiet) {
  const SmallScene scene;
  const ToolOptions options = withDisc({{"--threshold", "250"}});
  EXPECT_EQ(masked(scene, options).err.find("fluidymation: warning: nothing found: "), 0U);
  EXPECT_TRUE(failedNaming(1, "made/00001.png: is there already; so are 3 more; wanted --overwrite",
                           {}, masked(scene, options)));
  ToolOptions again = quietly(options);
  again["--overwrite"] = "";
  const ProcessResult quiet = masked(scene, again);
  EXPECT_EQ(quiet.exitCode, 0);
  EXPECT_EQ(quiet.err + quiet.out, "");
}

TEST(EndToEndMask, RefusesWrongOptions) {
  const SmallScene scene;
  const auto refused = [&](const ToolOptions& options, const std::string& message) {
    EXPECT_TRUE(failedWith(2, message, masked(scene, withDisc(options))));
    EXPECT_FALSE(std::filesystem::exists(scene.file("made")));
  };
  refused({{"--threshold", "much"}}, "--threshold much: wanted a number in (0, 260]");
  refused({{"--bare-frames", "0"}}, "--bare-frames 0: wanted a whole number in [1, 25]");
  refused({{"--smallest-part", "-1"}},
          "--smallest-part -1: wanted a whole number in [0, 120000000]");
  refused({{"--matte", "screen"}}, "--matte screen: wanted multiply");
  refused({{"--matte", "multiply"}}, "--matte, --matte-path: wanted both or neither");
  refused({{"--out-path", "src/%05d.png"}},
          "--out-path src/%05d.png: src/00001.png is an input and would be overwritten; choose "
          "another name");
  EXPECT_TRUE(failedWith(2, "--src-path, --out-path: required, but not given (see --help)",
                         masked(scene, {{"--soft", ""}})));
}

TEST(EndToEndMask, OptionsReachTheMasks) {
  const SmallScene scene;
  const auto made = [&](const ToolOptions& options) {
    ToolOptions all = withDisc(quietly(options));
    all["--overwrite"] = "";
    EXPECT_EQ(masked(scene, all).exitCode, 0);
    return filesOf(scene.file("made"));
  };
  const SmallScene::Painting plain = made({});
  EXPECT_EQ(made({{"--threshold", "auto"}, {"--threads", "3"}}), plain);
  for (const ToolOptions& option :
       {ToolOptions{{"--threshold", "60"}}, ToolOptions{{"--grain-sigma", "3"}},
        ToolOptions{{"--soft", ""}}, ToolOptions{{"--smallest-part", "400"}},
        ToolOptions{{"--smallest-hole", "400"}}}) {
    EXPECT_NE(made(option), plain) << option.begin()->first;
  }
  std::filesystem::remove_all(scene.file("made"));
  EXPECT_EQ(made({{"--src-start", "2"}, {"--src-frames", "2"}}).size(), 2U);
  std::filesystem::remove_all(scene.file("made"));
  EXPECT_EQ(made({{"--src-range", "1-3"}}).size(), 3U);
  std::filesystem::remove_all(scene.file("made"));
  EXPECT_EQ(made({{"--src-path", "src"}, {"--out-path", "made"}}), plain);
}

TEST(EndToEndMask, HelpTellsAllOptions) {
  const SmallScene scene;
  const ProcessResult help = masked(scene, {{"--help", ""}});
  EXPECT_EQ(help.exitCode, 0);
  for (const char* option : {"--src-path", "--out-path", "--src-start", "--src-frames",
                             "--overwrite", "--sheet", "--bare ", "--bare-frames", "--bare-paint",
                             "--threshold", "--grain-sigma", "--smallest-part", "--smallest-hole",
                             "--soft", "--matte ", "--matte-path", "--threads", "--quiet"}) {
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  }
}

}  // namespace
}  // namespace fluidymation::test
