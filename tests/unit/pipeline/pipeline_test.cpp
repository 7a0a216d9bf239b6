// The engine as a library: what a program that links it may rely on.
#include "fluidymation/pipeline.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>

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
  for (int patience = 0; patience < kBeforeTheFirst + kFrames; ++patience) {
    const SmallScene scene(kFrames);
    int asked = 0;
    Observer observer;
    observer.cancelled = [&] { return asked++ == patience; };
    const int written = std::max(0, patience - kBeforeTheFirst);
    EXPECT_EQ(messageOf<Interrupted>([&] { stylize(optionsFor(scene), observer); }),
              "interrupted; " + std::to_string(written) + " of 3 frames written");
    EXPECT_EQ(scene.names("out").size(), static_cast<std::size_t>(written));
  }
}

TEST(Stylize, TellsOfTheFirstFrameBeforeItIsPainted) {
  const SmallScene scene(2);
  std::string told;
  Observer observer;
  observer.paintingBegins = [&](int count) { told += "begin " + std::to_string(count); };
  observer.frameDone = [&](const FrameReport& report) {
    told += ", done " + std::to_string(report.frameNumber);
  };
  stylize(optionsFor(scene), observer);
  EXPECT_EQ(told, "begin 2, done 1, done 2");
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
