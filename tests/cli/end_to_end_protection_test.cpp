// That the real program overwrites no input, and takes no name that is another file's.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

/// Everything a scene holds, by path; a link counts as what it shows.
std::map<std::string, Bytes> contentOf(const SmallScene& scene) {
  std::map<std::string, Bytes> content;
  for (const auto& entry : fs::recursive_directory_iterator(scene.file(""))) {
    content[entry.path().string()] =
        entry.is_regular_file() ? readBytes(entry.path().string()) : Bytes{};
  }
  return content;
}

/// The tool has to refuse this run as wrong usage, naming the frame, and to leave all as it was.
void expectRefusedUntouched(const SmallScene& scene, const std::string& outPath,
                            const std::string& firstFrame) {
  const auto before = contentOf(scene);
  EXPECT_TRUE(failedWith(2,
                         "--out-path " + outPath + ": " + firstFrame +
                             " is an input and would be overwritten; choose another --out-path",
                         scene.paint(quietly({{"--out-path", outPath}}))));
  EXPECT_TRUE(contentOf(scene) == before) << outPath;
}

TEST(EndToEndOutput, NoSpellingOfAnInputIsOverwritten) {
  const SmallScene scene;
  fs::create_directory(scene.file("elsewhere"));
  fs::create_directory_symlink("../target", scene.file("elsewhere/link"));
  for (const std::string input : {"src", "mask", "target"}) {
    const std::string name = "/%05d.png";
    const std::vector<std::string> folders = {
        input,
        "./" + input,
        "././" + input + "/.",
        input + "//",
        "src/../" + input,
        "mask/./../" + input,
        "elsewhere/link/../" + input,  // a link's parent is not the folder that holds the link
        "fresh/../" + input,           // a folder that would be created on the way
        "fresh/deeper/../../" + input,
        scene.file(input),
        scene.file("fresh/../" + input),
    };
    for (const std::string& folder : folders) {
      expectRefusedUntouched(scene, folder + name, folder + "/00001.png");
    }
    // Also by another spelling of the number.
    expectRefusedUntouched(scene, input + "/0000%d.png", input + "/00001.png");
    expectRefusedUntouched(scene, input + "/%05u.png", input + "/00001.png");
  }
}

TEST(EndToEndOutput, NoLinkLeadsOntoAnInput) {
  const SmallScene scene;
  fs::create_directory_symlink("target", scene.file("link"));
  expectRefusedUntouched(scene, "link/%05d.png", "link/00001.png");
  expectRefusedUntouched(scene, "fresh/../link/%05d.png", "fresh/../link/00001.png");
  // A single frame that is a link to an input.
  fs::create_directory(scene.file("out"));
  fs::create_symlink("../src/00003.png", scene.file("out/00002.png"));
  expectRefusedUntouched(scene, "out/%05d.png", "out/00002.png");
  // An input that is a link.
  const SmallScene linked;
  fs::rename(linked.file("target/00004.png"), linked.file("kept.png"));
  fs::create_symlink("../kept.png", linked.file("target/00004.png"));
  expectRefusedUntouched(linked, "target/%05d.png", "target/00001.png");
}

TEST(EndToEndOutput, FramesOfAnInputThatAreNotUsedAreSafeToo) {
  const SmallScene scene(6);
  const ToolOptions firstTwo = {
      {"--src-frames", "2"}, {"--target-start", "5"}, {"--target-frames", "2"}};
  const auto before = contentOf(scene);
  for (const std::string folder : {"src", "mask", "target"}) {
    // Frames 5 and 6 of the exemplar exist, but nobody reads them; 9 does not even exist.
    ToolOptions options = firstTwo;
    options["--out-path"] = folder + "/%05d.png";
    EXPECT_TRUE(failedWith(2,
                           "--out-path " + folder + "/%05d.png: " + folder +
                               "/00005.png is an input and would be overwritten; choose another "
                               "--out-path",
                           scene.paint(quietly(options))));
    options["--out-path"] = folder + "/0001%d.png";
    EXPECT_TRUE(failedNaming(2, "--out-path " + folder, {folder + "/00015.png is an input"},
                             scene.paint(quietly(options))));
    // Not what the pattern means: five digits.
    options["--out-path"] = folder + "/%06d.png";
    EXPECT_EQ(scene.paint(quietly(options)).exitCode, 0);
    scene.remove(folder + "/000005.png");
    scene.remove(folder + "/000006.png");
    scene.remove(folder + "/fluidymation.json");
    scene.remove(folder + "/.fluidymation");
  }
  EXPECT_TRUE(contentOf(scene) == before);
}

TEST(EndToEndOutput, NoHardLinkLeadsOntoAnInput) {
  const SmallScene scene(6);
  fs::create_directories(scene.file("out"));
  fs::create_hard_link(scene.file("mask/00006.png"), scene.file("out/00002.png"));
  ToolOptions options = {{"--src-frames", "3"}, {"--target-frames", "3"}};
  const auto before = contentOf(scene);
  EXPECT_TRUE(failedWith(2,
                         "--out-path out/%05d.png: out/00002.png is an input and would be "
                         "overwritten; choose another --out-path",
                         scene.paint(quietly(options))));
  EXPECT_TRUE(contentOf(scene) == before);
  // Neither by the dump, by whatever link.
  scene.remove("out");
  options["--dump-guides"] = "dump";
  fs::create_directories(scene.file("dump/target"));
  const std::string dumped = "dump/target/00003.flow.png";
  for (const bool hard : {true, false}) {
    if (hard) {
      fs::create_hard_link(scene.file("src/00005.png"), scene.file(dumped));
    } else {
      fs::create_symlink("../../src/00001.png", scene.file(dumped));
    }
    EXPECT_TRUE(failedWith(2,
                           "--dump-guides dump: " + dumped +
                               " is an input and would be overwritten; choose another folder",
                           scene.paint(quietly(options))));
    scene.remove(dumped);
  }
  EXPECT_EQ(scene.names("out"), kNothing);
}

TEST(EndToEndOutput, TheDumpLeavesNamesOfAnInputPatternAlone) {
  const SmallScene scene;
  // Frame 1 of the target pattern is not there; the dump of the exemplar's frame 1 would become it.
  for (const int number : {2, 3, 4}) {
    scene.write("dump/source/0000" + std::to_string(number) + ".mask.png",
                scene.read(SmallScene::frame("target", number)));
  }
  const ToolOptions options = {{"--target-path", "dump/source/%05d.mask.png"},
                               {"--target-start", "2"},
                               {"--src-frames", "1"},
                               {"--dump-guides", "dump"}};
  const auto before = contentOf(scene);
  EXPECT_TRUE(failedNaming(2, "--dump-guides dump: ", {"/00001.mask.png is an input"},
                           scene.paint(quietly(options))));
  EXPECT_TRUE(contentOf(scene) == before);
}

TEST(EndToEndOutput, WrongUsageAndDamagedFilesLeaveNoFolder) {
  const SmallScene scene;
  const auto before = contentOf(scene);
  const std::vector<ToolOptions> wrong = {
      {{"--out-path", "target/%05d.png"}, {"--dump-guides", "dump"}},
      {{"--out-path", "out/deep/%05d.png"}, {"--dump-guides", "."}, {"--src-scale", "0"}},
      {{"--out-path", "dump/target/%05d.nnf.png"}, {"--dump-guides", "dump"}},
      {{"--out-path", "out/%05d.png"}, {"--src-start", "2000000000"}},
  };
  for (const ToolOptions& options : wrong) {
    EXPECT_EQ(scene.paint(quietly(options)).exitCode, 2);
    EXPECT_TRUE(contentOf(scene) == before);
  }
  for (const std::string input : {"src", "mask", "target"}) {
    const Bytes whole = scene.read(SmallScene::frame(input, 4));
    Bytes damaged = whole;
    damaged.resize(damaged.size() / 2);
    scene.write(SmallScene::frame(input, 4), damaged);
    const auto withDamage = contentOf(scene);
    EXPECT_EQ(scene.paint(quietly({{"--dump-guides", "dump"}})).exitCode, 1);
    EXPECT_TRUE(contentOf(scene) == withDamage) << input;
    scene.write(SmallScene::frame(input, 4), whole);
  }
}

TEST(EndToEndOutput, TheDumpNeverOverwritesAnInputWithANegativeNumber) {
  const SmallScene scene;
  for (const std::string number : {"-00001", "-00002", "-0001", "-0002"}) {
    scene.write("dump/target/" + number + ".mask.png", scene.read("target/00001.png"));
  }
  const auto before = contentOf(scene);
  const ToolOptions backwards = {
      {"--target-start", "-1"}, {"--target-speed", "-1"}, {"--dump-guides", "dump"}};
  // The dump of frame -1 is called -0001, so that only these masks are in its way
  ToolOptions fiveDigits = backwards;
  fiveDigits["--target-path"] = "dump/target/%05d.mask.png";
  EXPECT_TRUE(failedNaming(2, "--dump-guides dump: ", {"-0001.mask.png is an input"},
                           scene.paint(quietly(fiveDigits))));
  EXPECT_EQ(contentOf(scene), before);
  ToolOptions sixDigits = backwards;
  sixDigits["--target-path"] = "dump/target/%06d.mask.png";
  scene.remove("dump/target/-0001.mask.png");
  scene.remove("dump/target/-0002.mask.png");
  EXPECT_EQ(scene.paint(quietly(sixDigits)).exitCode, 0);
  for (const std::string number : {"-00001", "-00002"}) {
    const std::string name = "dump/target/" + number + ".mask.png";
    EXPECT_EQ(scene.read(name), before.at(scene.file(name)));
  }
}

TEST(EndToEndOutput, TheDumpNeverOverwritesAnInput) {
  const SmallScene scene;
  for (const std::string input : {"mask", "target"}) {
    for (const int number : {1, 2, 3, 4}) {
      scene.write((input == "mask" ? "dump/source" : "dump/target") +
                      SmallScene::frame("", number).substr(0, 6) + ".mask.png",
                  scene.read(SmallScene::frame(input, number)));
    }
  }
  const auto before = contentOf(scene);
  for (const std::string folder : {"dump", "./src/../dump", "fresh/../dump"}) {
    for (const auto& [option, sequence] : std::map<std::string, std::string>{
             {"--src-mask-path", "source"}, {"--target-path", "target"}}) {
      const ToolOptions options = {{option, "dump/" + sequence + "/%05d.mask.png"},
                                   {"--dump-guides", folder}};
      EXPECT_TRUE(failedWith(2,
                             "--dump-guides " + folder + ": " + folder + "/" + sequence +
                                 "/00001.mask.png is an input and would be overwritten; choose "
                                 "another folder",
                             scene.paint(quietly(options))));
    }
    EXPECT_TRUE(contentOf(scene) == before) << folder;
  }
}

TEST(EndToEndOutput, TheDumpNeverReplacesAPaintedFrame) {
  const SmallScene scene;
  EXPECT_TRUE(failedWith(2,
                         "--dump-guides dump: dump/target/00001.nnf.png is a painted frame; choose "
                         "another folder",
                         scene.paint(quietly({{"--out-path", "dump/target/%05d.nnf.png"},
                                              {"--dump-guides", "dump"}}))));
  EXPECT_EQ(scene.names("dump"), kNothing);
  // Side by side they do no harm.
  EXPECT_EQ(scene.paint({{"--out-path", "target/frame.%05d.png"}, {"--dump-guides", "."}}).exitCode,
            0);
}

TEST(EndToEndOutput, NoFolderTakesTheNameOfAFrame) {
  const SmallScene scene;
  const auto before = contentOf(scene);
  const auto refused = [&](const std::string& outPath, const std::string& dump) {
    const ProcessResult result =
        scene.paint(quietly({{"--out-path", outPath}, {"--dump-guides", dump}}));
    EXPECT_TRUE(contentOf(scene) == before) << dump;
    return result;
  };
  for (const std::string dump : {"o/2.png", "o/../o/2.png", "o/2.png/deep", "o/2.png/target"}) {
    EXPECT_TRUE(failedWith(
        2, "--dump-guides " + dump + ": o/2.png is a painted frame; choose another folder",
        refused("o/%d.png", dump)));
  }
  EXPECT_TRUE(
      failedWith(2,
                 "--dump-guides o: o/source/00002.mask.png is on the way to the painted frames; "
                 "choose another folder",
                 refused("o/source/00002.mask.png/%d.png", "o")));
  // Numbers that are not there yet count, a later run may find them.
  EXPECT_TRUE(failedNaming(2, "--dump-guides target/00009.png: a folder ",
                           {"/target/00009.png would have the name of an input"},
                           refused("o/%d.png", "target/00009.png")));
  EXPECT_TRUE(failedNaming(2, "--out-path mask/00009.png/%d.png: a folder ",
                           {"/mask/00009.png would have the name of an input"},
                           refused("mask/00009.png/%d.png", "dump")));
  // Other numbers do no harm.
  EXPECT_EQ(scene.paint({{"--out-path", "o/%d.png"}, {"--dump-guides", "o/5.png"}}).exitCode, 0);
}

}  // namespace
}  // namespace fluidymation::test
