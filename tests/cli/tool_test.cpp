#include "cli/tool.h"

#include <gtest/gtest.h>

#include <csignal>
#include <new>
#include <sstream>
#include <stdexcept>

#include "cli/subcommand.h"
#include "fluidymation/core/error.h"

namespace fluidymation::cli {
namespace {

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

Outcome run(std::vector<const char*> arguments, const Engine& engine, bool terminal = false) {
  std::vector<const char*> argv = {"fluidymation",    "--src-path",    "s/%d",
                                   "--src-mask-path", "m/%d",          "--out-path",
                                   "o/%d.png",        "--target-path", "t/%d"};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  std::ostringstream out;
  std::ostringstream err;
  const int code =
      runTool(static_cast<int>(argv.size()), argv.data(), {out, err, terminal}, engine);
  return {code, out.str(), err.str()};
}

/// An engine that reports one frame and then fails with `failure`.
template <typename Failure>
Engine failing(const Failure& failure) {
  return [failure](const Options&, const Observer& observer) {
    observer.frameDone({0, 2, 1, 0.5, "o/1"});
    throw failure;
  };
}

TEST(Tool, PassesTheOptionsAndReportsFramesOnStderr) {
  std::string path;
  const Outcome outcome =
      run({"--seed", "9"}, [&](const Options& options, const Observer& observer) {
        path = options.outPath + " " + std::to_string(options.synthesis.seed);
        observer.note("two frames");
        observer.frameDone({0, 2, 1, 0.5, "o/1"});
        observer.frameDone({1, 2, 2, 0.5, "o/2"});
      });
  EXPECT_EQ(outcome.code, kDone);
  EXPECT_EQ(path, "o/%d.png 9");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err,
            "fluidymation: note: two frames\n"
            "frame 1 of 2  0.50 s  o/1\n"
            "frame 2 of 2  0.50 s  o/2\n"
            "2 frames in 00:01: o/1 to o/2\n"
            "to look at them: fluidymation preview, the same options, and --preview FILE.apng\n");
}

TEST(Tool, ReadingThatIsDoneSoonIsNotToldOf) {
  const auto reads = [](const Options&, const Observer& observer) {
    for (int i = 1; i <= 400; ++i) observer.reading({ReadingStage::kTargetMasks, i, 400});
  };
  EXPECT_EQ(run({"--progress", "json"}, reads).out, "");
  EXPECT_EQ(run({}, reads).err, "");
}

TEST(Tool, LinesForProgramsGoToStdoutAndNotesStayOnStderr) {
  const auto noteAndFrame = [](const Options&, const Observer& observer) {
    observer.note("one frame");
    observer.paintingBegins(0, 1);
    observer.frameDone({0, 1, 7, 0.5, "o/7"});
  };
  const std::string frame =
      "{\"frame\":7,\"index\":0,\"count\":1,\"seconds\":0.5,\"path\":\"o/7\"}\n";
  const Outcome json = run({"--progress", "json"}, noteAndFrame, true);
  EXPECT_EQ(json.code, kDone);
  EXPECT_EQ(json.out, frame);
  EXPECT_EQ(json.err, "fluidymation: note: one frame\n");
  const Outcome quiet = run({"--progress", "json", "--quiet"}, noteAndFrame);
  EXPECT_EQ(quiet.out, frame);
  EXPECT_EQ(quiet.err, "");

  const Outcome failed = run({"--progress", "openjd"}, failing(Error("o/2: is full")));
  EXPECT_EQ(failed.code, kFailed);
  EXPECT_NE(failed.out.find("openjd_progress: 50\n"), std::string::npos) << failed.out;
  EXPECT_NE(failed.out.find("openjd_fail: o/2: is full\n"), std::string::npos) << failed.out;
  EXPECT_EQ(failed.err, "fluidymation: error: o/2: is full\n");
}

TEST(Tool, QuietLeavesOnlyErrors) {
  const Outcome outcome = run({"--quiet"}, failing(Error("o/2: cannot be written (full)")));
  EXPECT_EQ(outcome.code, kFailed);
  EXPECT_EQ(outcome.err, "fluidymation: error: o/2: cannot be written (full)\n");
}

TEST(Tool, ErrorsBeginOnALineOfTheirOwn) {
  const Outcome outcome = run({}, failing(Error("a\nb")), true);
  EXPECT_EQ(outcome.code, kFailed);
  EXPECT_EQ(outcome.err,
            "\rreading the masks and the exemplar ...\x1b[K"
            "\rframe 1 of 2  0.50 s/frame  00:01 left\x1b[K\nfluidymation: error: a?b\n");
}

TEST(Tool, WhatComesFromFilesCannotSteerTheTerminal) {
  // Escape, and the one-character form of its sequences, U+009B; a c with cedilla stays
  const Outcome outcome = run({}, failing(Error("\x1b[31m \xc2\x9b"
                                                "31m fa\xc3\xa7"
                                                "ade")));
  EXPECT_NE(outcome.err.find("?[31m \xc2?31m fa\xc3\xa7"
                             "ade"),
            std::string::npos)
      << outcome.err;
}

TEST(Tool, ExitCodesTellWrongUsageFromFailure) {
  EXPECT_EQ(run({"--quiet"}, failing(UsageError("wrong"))).code, kWrongUsage);
  for (const Engine& engine : {failing(std::bad_alloc()), failing(std::bad_array_new_length()),
                               failing(std::length_error("vector::_M_default_append"))}) {
    const Outcome memory = run({"--quiet"}, engine);
    EXPECT_EQ(memory.code, kFailed);
    EXPECT_EQ(memory.err.find("fluidymation: error: out of memory; "), 0U);
  }
  const Outcome internal = run({"--quiet"}, failing(std::out_of_range("at")));
  EXPECT_EQ(internal.code, kFailed);
  EXPECT_EQ(internal.err, "fluidymation: error: internal error: at\n");
}

TEST(Tool, AStoppedRunEndsWithTheSignalsCode) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    int received = 0;
    bool stoppedAtOnce = true;
    const int number = signal;
    std::ostringstream out;
    std::ostringstream err;
    const char* const argv[] = {"fluidymation",  "--quiet",  "--src-path",      "s/%d",
                                "--out-path",    "o/%d.png", "--src-mask-path", "m/%d",
                                "--target-path", "t/%d"};
    const Engine engine = [&](const Options&, const Observer& observer) {
      stoppedAtOnce = observer.cancelled();
      received = number;
      if (observer.cancelled()) throw Interrupted("interrupted; 1 of 2 frames written");
    };
    EXPECT_EQ(runTool(10, argv, {out, err}, engine, [&] { return received; }), code);
    EXPECT_FALSE(stoppedAtOnce);
    EXPECT_EQ(err.str(), "fluidymation: interrupted; 1 of 2 frames written\n");
  }
}

TEST(Tool, WrongUsageNeverReachesTheEngine) {
  const Outcome outcome = run({"--mask-threshold", "0.7"},
                              [](const Options&, const Observer&) { ADD_FAILURE() << "called"; });
  EXPECT_EQ(outcome.code, kWrongUsage);
  EXPECT_EQ(outcome.err,
            "fluidymation: error: --mask-threshold 0.7: wanted a number in (0, 0.5]\n");
}

TEST(Tool, HelpAndVersionGoToStdout) {
  const Engine engine = [](const Options&, const Observer&) { ADD_FAILURE() << "called"; };
  for (const char* option : {"--help", "--version"}) {
    const Outcome outcome = run({option}, engine);
    EXPECT_EQ(outcome.code, kDone);
    EXPECT_NE(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
  }
}

/// What the tool says to these words alone.
Outcome answerTo(std::vector<const char*> words) {
  words.insert(words.begin(), "fluidymation");
  std::ostringstream out;
  std::ostringstream err;
  const int code = runTool(static_cast<int>(words.size()), words.data(), {out, err}, {});
  return {code, out.str(), err.str()};
}

TEST(Tool, EveryCommandHasHelpAndIsInTheHelpOfTheTool) {
  const std::string help = answerTo({"--help"}).out;
  for (const Subcommand& command : subcommands()) {
    EXPECT_NE(help.find("  fluidymation " + command.name + "  " + command.summary),
              std::string::npos);
    const Outcome own = answerTo({command.name.c_str(), "--help"});
    EXPECT_EQ(own.code, kDone);
    EXPECT_EQ(own.err, "");
    EXPECT_NE(own.out.find("Usage: fluidymation " + command.name + " "), std::string::npos)
        << own.out;
  }
}

TEST(Tool, AWordThatIsNoCommandIsRefused) {
  const Outcome outcome = answerTo({"inspekt", "--help"});
  EXPECT_EQ(outcome.code, kWrongUsage);
  EXPECT_EQ(outcome.err.find("fluidymation: error: command inspekt: there is no such command; "
                             "wanted inspect"),
            0U)
      << outcome.err;
}

TEST(Tool, SaysWhenStdoutIsFull) {
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  const char* const argv[] = {"fluidymation", "--help"};
  EXPECT_EQ(runTool(2, argv, {out, err}, {}), kFailed);
  EXPECT_EQ(err.str(), "fluidymation: error: standard output cannot be written\n");
}

}  // namespace
}  // namespace fluidymation::cli
