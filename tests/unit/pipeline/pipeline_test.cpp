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

TEST(Stylize, StopsAtEveryStageWhenAsked) {
  constexpr int kFrames = 3;
  // Asked before each mask of the exemplar, twice, likewise of the target, before each picture, its
  // guides, each frame to paint.
  constexpr int kBeforeTheFirst = 6 * kFrames;
  for (const int threads : {1, 2}) {
    for (int patience = 0; patience < kBeforeTheFirst + kFrames; ++patience) {
      const SmallScene scene(kFrames);
      Options options = optionsFor(scene);
      options.threads = threads;
      int asked = 0;
      int told = 0;
      Observer observer;
      observer.cancelled = [&] { return asked++ == patience; };
      observer.frameDone = [&](const FrameReport&) { ++told; };
      const int written = std::max(0, patience - kBeforeTheFirst);
      EXPECT_EQ(messageOf<Interrupted>([&] { stylize(options, observer); }),
                "interrupted; " + std::to_string(written) + " of 3 frames written");
      EXPECT_EQ(scene.names("out").size(), static_cast<std::size_t>(written));
      EXPECT_EQ(told, written);
    }
  }
}

TEST(Stylize, TellsOfTheFirstFrameBeforeItIsPainted) {
  for (const int threads : {1, 3}) {
    const SmallScene scene(2);
    Options options = optionsFor(scene);
    options.threads = threads;
    std::string told;
    Observer observer;
    observer.paintingBegins = [&](int count) { told += "begin " + std::to_string(count); };
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
    observer.paintingBegins = [&](int) { std::filesystem::create_directory(third); };
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
