// What the real program says, to whom, and how it ends.

#include <gtest/gtest.h>

#include <csignal>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

TEST(EndToEndOutput, AStopSignalEndsTheRunAndLeavesWholeFrames) {
  constexpr int kFrames = 12;
  const SmallScene scene(kFrames);
  const ToolOptions slow = {
      {"--opt-iterations", "400"}, {"--src-frames", "12"}, {"--target-frames", "12"}};
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    scene.remove("out");
    ProcessSetup setup;
    setup.signalAfterOutput = signal;
    setup.linesBeforeSignal = 3;  // memory, that painting begins, and a frame
    const ProcessResult result = scene.paint(slow, setup);
    EXPECT_EQ(result.exitCode, code) << result.err;
    const std::vector<std::string> written = scene.names("out");
    ASSERT_GE(written.size(), 1U);
    ASSERT_LT(written.size(), std::size_t{kFrames});
    for (std::size_t i = 0; i < written.size(); ++i) {
      EXPECT_EQ("out/" + written[i], SmallScene::frame("out", static_cast<int>(i) + 1));
    }
    EXPECT_NE(result.err.find("fluidymation: interrupted; " + std::to_string(written.size()) +
                              " of 12 frames written; --resume goes on from there\n"),
              std::string::npos)
        << result.err;
  }
}

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
  std::getline(lines, line);
  EXPECT_EQ(line.find("fluidymation: note: memory: at most "), 0U) << line;
  std::getline(lines, line);
  EXPECT_EQ(line, "painting 4 frames ...");
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
  std::getline(lines, line);
  EXPECT_EQ(line.find("4 frames in 00:"), 0U) << line;
  std::getline(lines, line);
  EXPECT_EQ(line.find("to look at them: fluidymation preview"), 0U) << line;
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
      "fluidymation: note: memory: ";
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
  const ToolOptions json = {{"--progress", "json"}};  // speaks on stdout, else it does on stderr
  for (const StreamKind err : {StreamKind::kCaptured, StreamKind::kClosed, StreamKind::kBrokenPipe,
                               StreamKind::kFullDevice}) {
    for (const StreamKind out : {StreamKind::kCaptured, StreamKind::kClosed,
                                 StreamKind::kBrokenPipe, StreamKind::kFullDevice}) {
      scene.remove("out");
      ProcessSetup setup;
      setup.err = err;
      setup.out = out;
      setup.inputClosed = out == StreamKind::kClosed;
      const ProcessResult result =
          scene.paint(out == StreamKind::kCaptured ? ToolOptions{} : json, setup);
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
