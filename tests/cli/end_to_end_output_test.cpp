// Where the real program writes, where it must not, and what it says.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kNothing;
const std::vector<std::string> kFourFrames = {"00001.png", "00002.png", "00003.png", "00004.png"};

ToolOptions quietly(ToolOptions options) {
  options["--quiet"] = "";
  return options;
}

/// Everything a scene holds, by path; a link counts as what it shows.
std::map<std::string, Bytes> contentOf(const SmallScene& scene) {
  std::map<std::string, Bytes> content;
  for (const auto& entry : fs::recursive_directory_iterator(scene.file(""))) {
    content[entry.path().string()] =
        entry.is_regular_file() ? readBytes(entry.path().string()) : Bytes{};
  }
  return content;
}

// ---------------------------------------------------------------------------------------------
// Inputs are never overwritten

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
    const ToolOptions masks = {{"--src-mask-path", "dump/source/%05d.mask.png"},
                               {"--dump-guides", folder}};
    EXPECT_TRUE(failedWith(2,
                           "--dump-guides " + folder + ": " + folder +
                               "/source/00001.mask.png is an input and would be overwritten; "
                               "choose another folder",
                           scene.paint(quietly(masks))));
    const ToolOptions target = {{"--target-path", "dump/target/%05d.mask.png"},
                                {"--dump-guides", folder}};
    EXPECT_TRUE(failedWith(2,
                           "--dump-guides " + folder + ": " + folder +
                               "/target/00001.mask.png is an input and would be overwritten; "
                               "choose another folder",
                           scene.paint(quietly(target))));
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

TEST(EndToEndOutput, OlderFramesAreReplaced) {
  const SmallScene scene;
  const SmallScene::Painting expected = scene.painting();
  for (const std::string& name : kFourFrames) scene.write("out/" + name, bytesOf("older"));
  scene.write("out/00005.png", bytesOf("not ours"));
  EXPECT_EQ(scene.paint().exitCode, 0);
  SmallScene::Painting after = filesOf(scene.file("out"));
  EXPECT_TRUE(after["00005.png"] == bytesOf("not ours"));
  after.erase("00005.png");
  EXPECT_TRUE(after == expected);
}

// ---------------------------------------------------------------------------------------------
// Folders and full disks

TEST(EndToEndOutput, FoldersAreCreated) {
  const SmallScene scene;
  const SmallScene::Painting expected = scene.painting();
  ASSERT_EQ(scene.names("out"), kFourFrames);
  EXPECT_EQ(scene.paint({{"--out-path", "a/b c/d/%05d.png"}}).exitCode, 0);
  EXPECT_TRUE(filesOf(scene.file("a/b c/d")) == expected);
  EXPECT_EQ(scene.paint({{"--out-path", "here%05d.png"}}).exitCode, 0);
  EXPECT_TRUE(readBytes(scene.file("here00003.png")) == expected.at("00003.png"));
}

TEST(EndToEndOutput, SaysWhyAFolderCannotBeCreated) {
  const SmallScene scene;
  scene.write("occupied", bytesOf("a file"));
  EXPECT_TRUE(failedWith(1, "occupied/deep: the folder cannot be created (Not a directory)",
                         scene.paint(quietly({{"--out-path", "occupied/deep/%05d.png"}}))));
  EXPECT_TRUE(failedNaming(1, "occupied: the folder cannot be created (", {},
                           scene.paint(quietly({{"--out-path", "occupied/%05d.png"}}))));
  EXPECT_TRUE(scene.read("occupied") == bytesOf("a file"));
  // Neither that of the dump; and before a frame is painted.
  EXPECT_TRUE(failedWith(1, "occupied/source: the folder cannot be created (Not a directory)",
                         scene.paint(quietly({{"--dump-guides", "occupied"}}))));
  EXPECT_EQ(scene.names("out"), kNothing);
}

TEST(EndToEndOutput, SaysWhyAFolderCannotBeWritten) {
  const SmallScene scene;
  if (fs::is_directory("/proc/self")) {  // where not even root can create a file
    EXPECT_TRUE(failedNaming(1, "/proc/self: files cannot be created in this folder (", {},
                             scene.paint(quietly({{"--out-path", "/proc/self/%05d.png"}}))));
  }
  const auto readOnly = fs::perms::owner_read | fs::perms::owner_exec;
  fs::create_directories(scene.file("shut"));
  fs::permissions(scene.file("shut"), readOnly);
  const ProcessResult within = scene.paintUnprivileged(quietly({{"--out-path", "shut/%05d.png"}}));
  const ProcessResult below = scene.paintUnprivileged(quietly({{"--out-path", "shut/a/%05d.png"}}));
  const ProcessResult dump = scene.paintUnprivileged(quietly({{"--dump-guides", "shut/dump"}}));
  fs::permissions(scene.file("shut"), fs::perms::owner_all);
  EXPECT_TRUE(
      failedWith(1, "shut: files cannot be created in this folder (Permission denied)", within));
  EXPECT_TRUE(failedWith(1, "shut/a: the folder cannot be created (Permission denied)", below));
  EXPECT_TRUE(failedNaming(1, "shut/dump/source: the folder cannot be created (", {}, dump));
  EXPECT_EQ(scene.names("shut"), kNothing);
  EXPECT_EQ(scene.names("out"), kNothing);
}

TEST(EndToEndOutput, ChecksEveryFramesNameBeforeTheFirstIsPainted) {
  const SmallScene scene;
  fs::create_directories(scene.file("out/00004.png"));
  EXPECT_TRUE(
      failedWith(1, "out/00004.png: cannot be written (it is a folder)", scene.paint(quietly({}))));
  EXPECT_EQ(scene.names("out"), std::vector<std::string>{"00004.png"});
  const std::string longName = std::string(252, 'n') + "%d.png";
  EXPECT_TRUE(failedNaming(1, "wide/" + std::string(252, 'n') + "1.png: cannot be written (",
                           {"File name too long"},
                           scene.paint(quietly({{"--out-path", "wide/" + longName}}))));
  EXPECT_EQ(scene.names("wide"), kNothing);
}

TEST(EndToEndOutput, ChecksTheDumpsNamesBeforeTheFirstFrameIsPainted) {
  const SmallScene scene;
  fs::create_directories(scene.file("dump/target/00003.mask.png"));
  EXPECT_TRUE(failedWith(1, "dump/target/00003.mask.png: cannot be written (it is a folder)",
                         scene.paint(quietly({{"--dump-guides", "dump"}}))));
  EXPECT_EQ(scene.names("out"), kNothing);
  EXPECT_EQ(scene.names("dump"), std::vector<std::string>{"target"});
}

TEST(EndToEndOutput, TheDumpsOfExemplarAndTargetDoNotShareAFolder) {
  const SmallScene scene;
  fs::create_directories(scene.file("dump/target"));
  fs::create_directory_symlink("target", scene.file("dump/source"));
  EXPECT_TRUE(failedWith(2,
                         "--dump-guides dump: dump/source and dump/target are one folder; choose "
                         "another folder",
                         scene.paint(quietly({{"--dump-guides", "dump"}}))));
  EXPECT_EQ(scene.names("out"), kNothing);
}

TEST(EndToEndOutput, AFullDiskLeavesWholeFramesOnly) {
  const SmallScene scene;
  // An empty frame packs into less than a hundred bytes, a painted one does not.
  scene.write("target/00001.png", maskPng(Mask(Size{28, 22})));
  scene.write("target/00002.png", maskPng(Mask(Size{28, 22})));
  const SmallScene::Painting expected = scene.painting();
  scene.remove("out");
  scene.write("out/00003.png", bytesOf("older"));
  ProcessSetup setup;
  setup.largestFileBytes = 300;
  EXPECT_TRUE(failedWith(1, "out/00003.png: cannot be written (File too large)",
                         scene.paint(quietly({}), setup)));
  const SmallScene::Painting left = filesOf(scene.file("out"));
  ASSERT_EQ(left.size(), 3U);
  EXPECT_TRUE(left.at("00001.png") == expected.at("00001.png"));
  EXPECT_TRUE(left.at("00002.png") == expected.at("00002.png"));
  EXPECT_TRUE(left.at("00003.png") == bytesOf("older"));
}

TEST(EndToEndOutput, AFullDiskEndsTheDumpWithoutHalfFiles) {
  const SmallScene scene;
  ProcessSetup setup;
  setup.largestFileBytes = 300;
  EXPECT_TRUE(failedNaming(1, "dump/source/00001.", {": cannot be written (File too large)"},
                           scene.paint(quietly({{"--dump-guides", "dump"}}), setup)));
  EXPECT_EQ(scene.names("out"), kNothing);
  for (const std::string& name : scene.names("dump/source")) {
    EXPECT_NE(name[0], '.') << name;
    EXPECT_FALSE(scene.read("dump/source/" + name).empty()) << name;
  }
}

// ---------------------------------------------------------------------------------------------
// Signals

TEST(EndToEndOutput, AStopSignalEndsTheRunBetweenFrames) {
  constexpr int kFrames = 12;
  const SmallScene scene(kFrames);
  const ToolOptions slow = {
      {"--opt-iterations", "400"}, {"--src-frames", "12"}, {"--target-frames", "12"}};
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    scene.remove("out");
    ProcessSetup setup;
    setup.signalAfterOutput = signal;
    const ProcessResult result = scene.paint(slow, setup);
    EXPECT_EQ(result.exitCode, code) << result.err;
    const std::vector<std::string> written = scene.names("out");
    ASSERT_GE(written.size(), 1U);
    ASSERT_LT(written.size(), std::size_t{kFrames});
    for (std::size_t i = 0; i < written.size(); ++i) {
      EXPECT_EQ("out/" + written[i], SmallScene::frame("out", static_cast<int>(i) + 1));
    }
    const std::string last =
        "fluidymation: interrupted; " + std::to_string(written.size()) + " of 12 frames written\n";
    ASSERT_GT(result.err.size(), last.size());
    EXPECT_EQ(result.err.substr(result.err.size() - last.size()), last);
  }
}

// ---------------------------------------------------------------------------------------------
// What the tool says, and to whom

/// Whether this is a number with two decimals.
bool isSeconds(const std::string& text) {
  const std::size_t dot = text.find('.');
  return dot != 0 && dot + 3 == text.size() && text.find_first_not_of("0123456789") == dot &&
         text.find_first_not_of("0123456789", dot + 1) == std::string::npos;
}

TEST(EndToEndOutput, APipeGetsOnePlainLinePerFrame) {
  const SmallScene scene;
  const ProcessResult result = scene.paint({{"--src-frames", "4"}, {"--target-frames", "4"}});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out, "");
  std::istringstream lines(result.err);
  std::string line;
  for (int i = 1; i <= 4; ++i) {
    ASSERT_TRUE(std::getline(lines, line)) << result.err;
    const std::string beginning = "frame " + std::to_string(i) + " of 4  ";
    const std::string end = " s  " + SmallScene::frame("out", i);
    ASSERT_GT(line.size(), beginning.size() + end.size()) << line;
    EXPECT_EQ(line.substr(0, beginning.size()), beginning);
    EXPECT_EQ(line.substr(line.size() - end.size()), end);
    EXPECT_TRUE(
        isSeconds(line.substr(beginning.size(), line.size() - beginning.size() - end.size())))
        << line;
  }
  EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST(EndToEndOutput, NotesTellOfFramesThatAreNotThereOrNotUsed) {
  const SmallScene scene;
  const ProcessResult result = scene.paint({{"--src-frames", "3"}, {"--target-frames", "9"}});
  EXPECT_EQ(result.exitCode, 0);
  const std::string notes =
      "fluidymation: note: --src-path src/%05d.png: frames 1 to 3 are used; 1 more follows "
      "(--src-frames)\n"
      "fluidymation: note: --target-path target/%05d.png: the sequence ends with frame 4, after 4 "
      "of at most 9 frames (--target-frames)\n"
      "frame 1 of 4  ";
  EXPECT_EQ(result.err.substr(0, notes.size()), notes);
}

TEST(EndToEndOutput, QuietIsQuiet) {
  const SmallScene scene;
  const ProcessResult result = scene.paint({{"--quiet", ""}, {"--src-frames", "3"}});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(scene.names("out"), kFourFrames);
}

TEST(EndToEndOutput, NoClosedOrFullStreamCostsAFrame) {
  const SmallScene scene;
  const SmallScene::Painting expected = scene.painting();
  for (const StreamKind err : {StreamKind::kCaptured, StreamKind::kClosed, StreamKind::kBrokenPipe,
                               StreamKind::kFullDevice}) {
    for (const StreamKind out : {StreamKind::kCaptured, StreamKind::kClosed,
                                 StreamKind::kBrokenPipe, StreamKind::kFullDevice}) {
      scene.remove("out");
      ProcessSetup setup;
      setup.err = err;
      setup.out = out;
      setup.inputClosed = out == StreamKind::kClosed;
      const ProcessResult result = scene.paint({}, setup);
      EXPECT_EQ(result.exitCode, 0) << static_cast<int>(err) << " " << static_cast<int>(out);
      EXPECT_EQ(result.signal, 0);
      EXPECT_TRUE(filesOf(scene.file("out")) == expected)
          << static_cast<int>(err) << " " << static_cast<int>(out);
    }
  }
}

TEST(EndToEndOutput, ExitCodesDoNotNeedAnOpenErrorStream) {
  const SmallScene scene(1);
  for (const StreamKind err :
       {StreamKind::kClosed, StreamKind::kBrokenPipe, StreamKind::kFullDevice}) {
    ProcessSetup setup;
    setup.err = err;
    EXPECT_EQ(scene.paint({{"--target-path", "none/%d.png"}}, setup).exitCode, 1);
    EXPECT_EQ(scene.paint({{"--lambda", "nan"}}, setup).exitCode, 2);
  }
}

TEST(EndToEndOutput, HelpAndVersionGoToStandardOutput) {
  for (const char* option : {"--help", "--version"}) {
    const ProcessResult result = runProcess(FLUIDYMATION_PROGRAM, {option});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out, "");
    for (const StreamKind unwritable : {StreamKind::kBrokenPipe, StreamKind::kFullDevice}) {
      ProcessSetup setup;
      setup.out = unwritable;
      const ProcessResult failed = runProcess(FLUIDYMATION_PROGRAM, {option}, setup);
      EXPECT_EQ(failed.exitCode, 1);
      EXPECT_EQ(failed.err, "fluidymation: error: standard output cannot be written\n");
    }
  }
}

}  // namespace
}  // namespace fluidymation::test
