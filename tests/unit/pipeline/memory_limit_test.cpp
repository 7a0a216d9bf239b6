#include "pipeline/memory_limit.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

/// A long film, whose frames are most of what is needed.
RunSize longFilm() { return {{400, 300}, 200, {200, 150}, 30, 1, 2.0F, {400, 300}}; }

Options limitedTo(std::int64_t bytes) {
  Options options;
  options.source.path = "src/%05d.png";
  options.target.path = "target/%05d.png";
  options.maxMemoryBytes = bytes;
  return options;
}

std::string refusalOf(const Options& options, const RunSize& run) {
  return test::messageOf<UsageError>([&] { requireMemory(options, run); });
}

/// What stands behind `words`.
std::string after(const std::string& words, const std::string& text) {
  const auto found = text.find(words);
  return found == std::string::npos ? "" : text.substr(found + words.size());
}

/// With masks that fill their frames.
RunSize fullMasks(RunSize run) {
  run.exemplarMaskPixels = std::int64_t{run.exemplar.width} * run.exemplar.height;
  run.targetMaskPixels = std::int64_t{run.target.width} * run.target.height;
  return run;
}

std::int64_t bytesHolding(int frames) {
  RunSize run = longFilm();
  run.heldFrames = frames;
  return bytesOfRun(run);
}

std::int64_t mostBytesHolding(int frames) {
  RunSize run = fullMasks(longFilm());
  run.heldFrames = frames;
  return bytesOfRun(run);
}

TEST(MemoryLimit, SaysHowManyFramesOfAWholeFilmWouldFit) {
  const std::int64_t limit = bytesHolding(0) / 2;
  const std::string message = refusalOf(limitedTo(limit), longFilm());
  EXPECT_NE(message.find("; lower --src-frames, --src-scale, --target-scale or --threads, or hold "
                         "a part of the film at a time: --src-window "),
            std::string::npos)
      << message;
  const int frames = std::stoi("0" + after("--src-window ", message));
  ASSERT_GE(frames, 2);
  EXPECT_LE(mostBytesHolding(frames), limit);
  EXPECT_GT(mostBytesHolding(frames + 1), limit);
  EXPECT_EQ(after(" needs at most about ", message), memoryText(mostBytesHolding(frames)));
}

TEST(MemoryLimit, TheWindowThatItNamesIsNotRefusedWhateverTheMasksTurnOutToHold) {
  for (const std::int64_t limit : {bytesHolding(0) / 2, bytesHolding(0) - 1, mostBytesHolding(2)}) {
    const std::string message = refusalOf(limitedTo(limit), longFilm());
    Options options = limitedTo(limit);
    options.sourceWindowFrames = std::stoi("0" + after("--src-window ", message));
    ASSERT_GE(options.sourceWindowFrames, 2) << message;
    for (RunSize run : {longFilm(), fullMasks(longFilm())}) {
      run.heldFrames = options.sourceWindowFrames;
      EXPECT_EQ(refusalOf(options, run), "");
    }
  }
}

TEST(MemoryLimit, AWindowGrowsWithItsFrames) {
  for (const int threads : {1, 8}) {
    RunSize run = fullMasks(longFilm());
    run.threads = threads;
    std::int64_t before = 0;
    for (run.heldFrames = 2; run.heldFrames < run.exemplarFrames; ++run.heldFrames) {
      EXPECT_GE(bytesOfRun(run), before) << run.heldFrames << " frames, " << threads << " threads";
      before = bytesOfRun(run);
    }
  }
}

TEST(MemoryLimit, NamesNoWindowWhereNoneWouldFit) {
  const std::string message = refusalOf(limitedTo(mostBytesHolding(2) - 1), longFilm());
  EXPECT_EQ(after("(--max-memory); ", message),
            "lower --src-frames, --src-scale, --target-scale or --threads");
  EXPECT_NE(refusalOf(limitedTo(mostBytesHolding(2)), longFilm()).find(": --src-window 2 needs"),
            std::string::npos);
}

TEST(MemoryLimit, AWindowThatIsGivenIsToBeLoweredUnlessItIsTheSmallest) {
  RunSize run = longFilm();
  run.heldFrames = 50;
  Options options = limitedTo(bytesHolding(40));
  options.sourceWindowFrames = 50;
  EXPECT_EQ(after("(--max-memory); ", refusalOf(options, run)),
            "lower --src-frames, --src-window, --src-scale, --target-scale or --threads");
  run.heldFrames = 2;
  options = limitedTo(bytesHolding(2) - 1);
  options.sourceWindowFrames = 2;
  EXPECT_EQ(after("(--max-memory); ", refusalOf(options, run)),
            "lower --src-frames, --src-scale, --target-scale or --threads");
}

TEST(MemoryLimit, WhatFitsIsNotRefused) {
  EXPECT_EQ(refusalOf(limitedTo(bytesHolding(0)), longFilm()), "");
  EXPECT_NE(refusalOf(limitedTo(bytesHolding(0) - 1), longFilm()), "");
}

}  // namespace
}  // namespace fluidymation
