// The engine as a library: what a program that links it may rely on.
#include "fluidymation/pipeline.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "fluidymation/core/error.h"
#include "support/small_scene.h"

namespace fluidymation {
namespace {

using test::messageOf;
using test::SmallScene;

/// Options that suit a small scene, with absolute paths.
Options optionsFor(const SmallScene& scene) {
  Options options;
  options.source.path = scene.file("src/%05d.png");
  options.sourceMaskPath = scene.file("mask/%05d.png");
  options.target.path = scene.file("target/%05d.png");
  options.outPath = scene.file("out/%05d.png");
  options.blurSigmaPx = 1.0F;
  options.timeBlurSigmaFrames = 1.0F;
  options.borderWidthPx = 3.0F;
  return options;
}

TEST(Stylize, LeavesTheCallersThreadSettingAsItWas) {
  constexpr int kCallersThreads = 3;
  const int before = omp_get_max_threads();
  omp_set_num_threads(kCallersThreads);
  const SmallScene scene(1);
  Options options = optionsFor(scene);
  options.threads = 2;
  stylize(options, {});
  EXPECT_EQ(omp_get_max_threads(), kCallersThreads);
  scene.remove("target");
  EXPECT_NE(messageOf<Error>([&] { stylize(options, {}); }), "");
  EXPECT_EQ(omp_get_max_threads(), kCallersThreads);
  omp_set_num_threads(before);
}

TEST(Stylize, StopsWheneverAskedAndGoesOnToTheSameFrames) {
  constexpr int kFrames = 3;
  const SmallScene whole(kFrames);
  stylize(optionsFor(whole), {});
  for (const int threads : {1, 2}) {
    const SmallScene scene(kFrames);
    Options options = optionsFor(scene);
    options.threads = threads;
    bool stopped = true;
    int before = 0;
    for (int patience = 0; stopped; patience += 3) {
      SCOPED_TRACE(patience);
      scene.remove("out");
      int asked = 0;
      int told = 0;
      Observer observer;
      observer.cancelled = [&] { return asked++ == patience; };
      observer.frameDone = [&](const FrameReport&) { ++told; };
      const std::string message = messageOf<Interrupted>([&] { stylize(options, observer); });
      stopped = !message.empty();
      EXPECT_EQ(scene.names("out").size(), static_cast<std::size_t>(told));
      EXPECT_GE(told, before);
      before = told;
      if (!stopped) break;
      EXPECT_EQ(message, "interrupted; " + std::to_string(told) + " of 3 frames written" +
                             (told > 0 ? "; --resume goes on from there" : ""));
      if (patience % 5 != 0) continue;  // the others end in the same places
      Options goingOn = options;
      goingOn.continuation.resume = true;
      goingOn.threads = 3 - threads;
      stylize(goingOn, {});
      EXPECT_TRUE(test::filesOf(scene.file("out")) == test::filesOf(whole.file("out")));
    }
    EXPECT_EQ(before, kFrames);
  }
}

TEST(Stylize, TellsOfTheFirstFrameBeforeItIsPainted) {
  for (const int threads : {1, 3}) {
    const SmallScene scene(2);
    Options options = optionsFor(scene);
    options.threads = threads;
    std::string told;
    Observer observer;
    observer.paintingBegins = [&](int, int count) { told += "begin " + std::to_string(count); };
    observer.frameDone = [&](const FrameReport& report) {
      told += ", done " + std::to_string(report.frameNumber);
      EXPECT_FALSE(scene.read(SmallScene::frame("out", report.frameNumber)).empty());
    };
    stylize(options, observer);
    EXPECT_EQ(told, "begin 2, done 1, done 2");
  }
}

TEST(Stylize, AFrameThatCannotBeWrittenEndsTheRunAfterThoseBeforeIt) {
  for (const int threads : {1, 2}) {
    const SmallScene scene(4);
    Options options = optionsFor(scene);
    options.threads = threads;
    int told = 0;
    Observer observer;
    // Nobody expects a folder of that name once all paths are checked.
    const std::string third = scene.file("out/00003.png");
    observer.paintingBegins = [&](int, int) { std::filesystem::create_directory(third); };
    observer.frameDone = [&](const FrameReport&) { ++told; };
    EXPECT_EQ(messageOf<Error>([&] { stylize(options, observer); }),
              third + ": cannot be written (it is a folder)");
    EXPECT_EQ(told, 2);
    EXPECT_EQ(scene.names("out"),
              (std::vector<std::string>{"00001.png", "00002.png", "00003.png"}));
  }
}

TEST(Stylize, FinishesWhenAskedToStopAfterTheLastFrame) {
  const SmallScene scene(1);
  bool stop = false;
  Observer observer;
  observer.frameDone = [&](const FrameReport&) { stop = true; };
  observer.cancelled = [&] { return stop; };
  stylize(optionsFor(scene), observer);
  EXPECT_EQ(scene.names("out").size(), 1U);
}

}  // namespace
}  // namespace fluidymation
