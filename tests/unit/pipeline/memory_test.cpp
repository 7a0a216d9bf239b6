#include "pipeline/memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/guides/input_mask.h"
#include "fluidymation/presets.h"
#include "support/png_maker.h"
#include "support/sanitizers.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation {
namespace {

TEST(Memory, ATypicalRunNeedsLittle) {
  // A long run at the size of docs/performance.md: 397 MiB as measured there.
  RunSize run{{400, 222}, 20, {1000, 800}, 400, 2, 2.0F, {1000, 800}};
  run.exemplarMaskPixels = 70'000;
  run.targetMaskPixels = 120'000;
  const std::int64_t bytes = bytesOfRun(run);
  EXPECT_GT(bytes, 400 << 20);
  EXPECT_LT(bytes, 624 << 20);
}

TEST(Memory, GrowsWithEverySize) {
  const RunSize run{{400, 300}, 20, {500, 400}, 300, 1, 2.0F, {500, 400}};
  const std::int64_t bytes = bytesOfRun(run);
  const auto changed = [&](auto change) {
    RunSize other = run;
    change(other);
    return bytesOfRun(other);
  };
  EXPECT_GT(changed([](RunSize& r) { r.exemplar = {401, 300}; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.exemplarFrames = 21; }), bytes);
  EXPECT_LT(changed([](RunSize& r) { r.heldFrames = 19; }), bytes);
  EXPECT_EQ(changed([](RunSize& r) { r.heldFrames = 20; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.target = {500, 401}; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.exemplarMaskPixels = 1000; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.targetMaskPixels = 1000; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.threads = 64; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.timeBlurSigmaFrames = 50.0F; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.largestStored = {4000, 4000}; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.flowBlurSigmaFrames = 50.0F; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.shape.guide = ShapeGuide::kBlurredMask; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.shape.hardSegments = false; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.shape.modulation = ModulationDistance::kUnclamped; }),
            bytes);
  EXPECT_LT(changed([](RunSize& r) { r.mayCompareAges = false; }), bytes);
  const auto bidirectional = [](RunSize& r) {
    r.temporalCoherence = TemporalCoherence::kBidirectional;
  };
  EXPECT_GT(changed(bidirectional), bytes + 8 * std::int64_t{500} * 400 * 80);
}

TEST(Memory, HardlyGrowsWithTheLengthOfTheTarget) {
  RunSize run{{400, 222}, 20, {1000, 800}, 400, 2, 2.0F, {1000, 800}};
  run.exemplarMaskPixels = 70'000;
  run.targetMaskPixels = 120'000;
  const std::int64_t bytes = bytesOfRun(run);
  run.targetFrames = 10'000;
  EXPECT_GT(bytesOfRun(run), bytes);
  EXPECT_LT(bytesOfRun(run), bytes + bytes / 10);
}

TEST(Memory, FramesAreDecodedAtTheirStoredSize) {
  // 28 bytes per stored pixel were measured, whatever a frame is scaled to.
  const Size stored{12000, 10000};
  const std::int64_t bytes = bytesOfRun({{120, 100}, 4, {120, 100}, 4, 1, 2.0F, stored});
  EXPECT_GT(bytes, std::int64_t{28} * 12000 * 10000);
  EXPECT_LT(bytes, std::int64_t{29} * 12000 * 10000);
}

TEST(Memory, NoMoreThreadsCountThanTilesAreSearched) {
  FinestLevel finestLevel = FinestLevel::kUpscaled;
  const auto bytesFor = [&finestLevel](Size target, int threads) {
    RunSize run{{1000, 800}, 50, target, 4, threads, 2.0F, {1000, 800}};
    run.finestLevel = finestLevel;
    run.occRadiusFrames = 0;  // the most a thread can need
    return bytesOfRun(run);
  };
  EXPECT_EQ(bytesFor({128, 128}, 1024), bytesFor({128, 128}, 2)) << "one tile of half the size";
  EXPECT_LT(bytesFor({128, 128}, 1024), std::int64_t{6} << 30);
  // Sixteen tiles: with fewer, reading the exemplar needs more than its search
  EXPECT_GT(bytesFor({2000, 128}, 1024), bytesFor({2000, 128}, 15));
  EXPECT_EQ(bytesFor({2000, 128}, 1024), bytesFor({2000, 128}, 16));
  EXPECT_EQ(bytesFor({9, 700}, 1024), bytesFor({9, 700}, 11)) << "a single level is searched whole";
  finestLevel = FinestLevel::kRefined;  // only its neighbours' matches are tried
  EXPECT_EQ(bytesFor({128, 128}, 1024), bytesFor({128, 128}, 2)) << "one tile of half the size";
  finestLevel = FinestLevel::kSearched;
  EXPECT_GT(bytesFor({128, 128}, 1024), bytesFor({128, 128}, 3)) << "four tiles of full size";
  EXPECT_EQ(bytesFor({128, 128}, 1024), bytesFor({128, 128}, 4));
}

TEST(Memory, WithSeveralThreadsAFrameIsInEveryStage) {
  RunSize run{{400, 300}, 20, {1000, 800}, 30, 1, 2.0F, {1000, 800}};
  run.finestLevel = FinestLevel::kUpscaled;  // hardly any maps
  run.targetMaskPixels = 1000 * 800;
  const std::int64_t alone = bytesOfRun(run);
  run.threads = 2;
  const std::int64_t sideBySide = bytesOfRun(run);
  const std::int64_t pixels = 1000 * 800;
  // A state and its file hold the picture too
  EXPECT_GT(sideBySide - alone, 280 * pixels);
  EXPECT_LT(sideBySide - alone, 424 * pixels);
  run.dumps = true;
  EXPECT_GT(bytesOfRun(run) - sideBySide, 72 * pixels);
  EXPECT_LT(bytesOfRun(run) - sideBySide, 200 * pixels);
}

TEST(Memory, MapsCountOnTheLevelsThatAreSearchedAndThoseOfThreadsWhereMatchesAreDrawn) {
  for (const int threads : {48, 54, 60}) {  // enough for the maps to decide, no more than tiles
    SCOPED_TRACE(threads);
    RunSize run{{400, 300}, 100, {1280, 720}, 8, threads, 2.0F, {1280, 720}};
    run.occRadiusFrames = 1;  // frames counted one by one: the most a thread can need
    const auto bytesFor = [&run](FinestLevel finestLevel) {
      run.finestLevel = finestLevel;
      return static_cast<double>(bytesOfRun(run));
    };
    // Of every pixel of the exemplar 4 bytes, and 4 for each thread
    const double map = 4.0 * 400 * 300 * 100;
    EXPECT_NEAR(bytesFor(FinestLevel::kRefined) - bytesFor(FinestLevel::kUpscaled), map, 1.0);
    EXPECT_NEAR(bytesFor(FinestLevel::kSearched) - bytesFor(FinestLevel::kRefined), map * threads,
                1.0);
  }
}

/// The image without its outermost pixels: nearly everything is inside, and has to be solved for.
Mask nearlyFull(Size size) {
  return test::maskOf(size, [size](int x, int y) {
    return x > 0 && y > 0 && x + 1 < size.width && y + 1 < size.height;
  });
}

enum class MaskKind {
  kHard,  ///< nearly full
  kSoft,  ///< likewise
  kDust,  ///< soft, with outlines about as long as they can be
};

/// What a run with nearly full masks really takes, on the exemplar's side or the target's.
struct FullMaskRun {
  const char* name;
  Size source;
  Size target;
  int frames;
  MaskKind kind = MaskKind::kHard;
  const char* preset = "standard";
  int threads = 1;
  TemporalCoherence coherence = TemporalCoherence::kForward;
  int heldFrames = 0;
};

InputMask maskOf(MaskKind kind, Size size) {
  if (kind == MaskKind::kHard) return nearlyFull(size);
  InputMask soft(kind == MaskKind::kSoft ? nearlyFull(size) : test::randomMask(size, 3, 50));
  for (float& c : soft.coverage) c = c > 0.5F ? 0.8F : 0.2F;
  soft.soft = true;
  return soft;
}

std::int64_t maskPixels(MaskKind kind, Size size) {
  return static_cast<std::int64_t>(countInside(maskOf(kind, size).cut()));
}

/// A gray 8-bit PNG file.
test::Bytes pngOf(const InputMask& mask) {
  test::PngSpec spec;
  spec.size = mask.coverage.size();
  for (const float c : mask.coverage) {
    spec.samples.push_back(static_cast<std::uint16_t>(std::lround(255.0F * c)));
  }
  return test::makePng(spec);
}

Options optionsOf(const std::string& preset) {
  Options options;
  if (preset == "thesis") applyThesisPreset(options);
  if (preset == "paper") applyPaperPreset(options);
  return options;
}

class MemoryOfFullMasks : public ::testing::TestWithParam<FullMaskRun> {};

int pixelsOf(Size size) { return size.width * size.height; }

TEST_P(MemoryOfFullMasks, StaysWithinTheEstimate) {
  // The estimate is of the program's own memory, what the system measures holds a sanitizer's too.
  if (test::kSanitized) GTEST_SKIP() << "sanitizers keep shadow memory and what was freed";
  const FullMaskRun& run = GetParam();
  const test::SmallScene scene(0);
  for (int number = 1; number <= run.frames; ++number) {
    scene.write(test::SmallScene::frame("src", number),
                test::colorPng(test::texturedDisc(run.source, 20.0F, 5)));
    scene.write(test::SmallScene::frame("mask", number), pngOf(maskOf(run.kind, run.source)));
    scene.write(test::SmallScene::frame("target", number), pngOf(maskOf(run.kind, run.target)));
  }
  const test::ProcessResult result =
      scene.paint({{"--preset", run.preset},
                   {"--blur-sigma", "0"},
                   {"--opt-iterations", "0"},
                   {"--patchmatch-iterations", "1"},
                   {"--threads", std::to_string(run.threads)},
                   {"--src-window", std::to_string(run.heldFrames)},
                   {"--temporal-coherence",
                    run.coherence == TemporalCoherence::kForward ? "forward" : "bidirectional"},
                   {"--quiet", ""}});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const Size largest = pixelsOf(run.source) > pixelsOf(run.target) ? run.source : run.target;
  RunSize size{run.source, run.frames, run.target, run.frames, run.threads, 1.0F, largest};
  const Options options = optionsOf(run.preset);
  size.flowBlurSigmaFrames = options.flowBlurSigmaFrames;
  size.shape = options.synthesis.shape;
  size.finestLevel = options.synthesis.finestLevel;
  size.temporalCoherence = run.coherence;
  size.heldFrames = run.heldFrames;
  size.exemplarMaskPixels = maskPixels(run.kind, run.source);
  size.targetMaskPixels = maskPixels(run.kind, run.target);
  const std::int64_t estimate = bytesOfRun(size);
  EXPECT_LE(result.peakBytes, estimate)
      << result.peakBytes / 1048576 << " MiB, estimate " << estimate / 1048576 << " MiB";
  if (run.kind == MaskKind::kDust) return;  // half of it is outside
  // Side by side the stages hardly ever need the most at the same moment
  EXPECT_GT(result.peakBytes, estimate / (run.threads > 1 ? 3 : 2))
      << "an estimate that refuses what would fit";
}

INSTANTIATE_TEST_SUITE_P(
    Sides, MemoryOfFullMasks,
    ::testing::Values(
        FullMaskRun{"exemplar", {1000, 800}, {40, 40}, 1},
        FullMaskRun{"movingExemplar", {700, 600}, {40, 40}, 3},
        FullMaskRun{"longExemplar", {200, 150}, {40, 40}, 40},
        FullMaskRun{"longExemplarInParts",
                    {200, 150},
                    {40, 40},
                    40,
                    MaskKind::kHard,
                    "standard",
                    1,
                    TemporalCoherence::kForward,
                    20},
        FullMaskRun{"largeExemplarInPartsSideBySide",
                    {500, 400},
                    {200, 150},
                    12,
                    MaskKind::kSoft,
                    "standard",
                    2,
                    TemporalCoherence::kForward,
                    4},
        FullMaskRun{"longThesis", {200, 150}, {40, 40}, 40, MaskKind::kHard, "thesis"},
        FullMaskRun{"longPaper", {200, 150}, {40, 40}, 40, MaskKind::kHard, "paper"},
        FullMaskRun{"paper", {40, 40}, {600, 500}, 2, MaskKind::kHard, "paper"},
        FullMaskRun{"target", {40, 40}, {600, 500}, 2},
        FullMaskRun{"targetSideBySide", {40, 40}, {600, 500}, 6, MaskKind::kSoft, "standard", 2},
        FullMaskRun{"targetInWindows",
                    {40, 40},
                    {600, 500},
                    11,
                    MaskKind::kSoft,
                    "standard",
                    2,
                    TemporalCoherence::kBidirectional},
        FullMaskRun{"softExemplar", {700, 600}, {40, 40}, 3, MaskKind::kSoft},
        FullMaskRun{"softTarget", {40, 40}, {600, 500}, 2, MaskKind::kSoft},
        FullMaskRun{"dustExemplar", {200, 150}, {40, 40}, 40, MaskKind::kDust},
        FullMaskRun{"dustTarget", {40, 40}, {200, 150}, 30, MaskKind::kDust}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Memory, CountsTheReadingOfAGivenFlow) {
  RunSize run{{40, 30}, 2, {50, 40}, 30, 2, 2.0F, {50, 40}};
  run.targetFlow = {5000, 4000};  // scaled to 1 %
  EXPECT_GT(bytesOfRun(run), 5000 * 4000 * 16);
  EXPECT_LT(bytesOfRun(run), 5000 * 4000 * 40);
  std::swap(run.exemplarFlow, run.targetFlow);
  EXPECT_GT(bytesOfRun(run), 5000 * 4000 * 16);
}

TEST(Memory, IsSaidInMebibytesOrGibibytesRoundedUp) {
  EXPECT_EQ(memoryText(1), "1 MiB");
  EXPECT_EQ(memoryText((std::int64_t{1} << 30) - 1), "1024 MiB");
  EXPECT_EQ(memoryText(std::int64_t{6} << 30), "6.0 GiB");
  EXPECT_EQ(memoryText((std::int64_t{1} << 30) + 1), "1.1 GiB");
  EXPECT_EQ(memoryText(std::numeric_limits<std::int64_t>::max()), "8589934591 GiB");
}

TEST(Memory, MasksThatNeedTooMuchAreRefusedWhenTheyAreRead) {
  const test::SmallScene scene(0);
  const Size size{700, 600};
  scene.write(test::SmallScene::frame("src", 1),
              test::colorPng(test::texturedDisc({40, 40}, 9, 5)));
  scene.write(test::SmallScene::frame("mask", 1), test::maskPng(test::disc({40, 40}, {20, 20}, 9)));
  RunSize run{{40, 40}, 1, size, 1, 1, 2.0F, size};
  const std::int64_t empty = bytesOfRun(run);
  run.targetMaskPixels = maskPixels(MaskKind::kHard, size);
  const std::string between = std::to_string((empty + bytesOfRun(run)) / 2);
  const auto paint = [&](const Mask& mask) {
    scene.write(test::SmallScene::frame("target", 1), test::maskPng(mask));
    return scene.paint({{"--threads", "1"}, {"--max-memory", between}, {"--quiet", ""}});
  };
  const test::ProcessResult refused = paint(nearlyFull(size));
  EXPECT_TRUE(test::failedNaming(2, "--src-path src/%05d.png, --target-path target/%05d.png: ",
                                 {" MiB (--max-memory); lower --src-frames"}, refused));
  EXPECT_TRUE(scene.names("out").empty());
  const test::ProcessResult painted = paint(test::disc(size, {300, 300}, 40));
  EXPECT_EQ(painted.exitCode, 0) << painted.err;
}

TEST(Memory, ARunThatWouldNotFitIsRefusedFromTheHeaders) {
  const test::SmallScene scene(4);
  // Each frame is within the limits of a frame.
  for (int number = 1; number <= 4; ++number) {
    const test::Bytes large = test::maskPng(Mask(Size{1000, 1000}));
    scene.write(test::SmallScene::frame("src", number), large);
    scene.write(test::SmallScene::frame("mask", number), large);
  }
  const test::ProcessResult refused =
      scene.paint({{"--quiet", ""}, {"--src-scale", "6"}, {"--max-memory", "6G"}});
  EXPECT_TRUE(test::failedNaming(
      2, "--src-path src/%05d.png, --target-path target/%05d.png: 4 frames of 6000x6000 and 4 of ",
      {", stored with up to 1000x1000, need about ",
       " GiB of memory; wanted at most 6.0 GiB (--max-memory); lower --src-frames"},
      refused));
  EXPECT_LT(refused.peakBytes, 400'000'000);
  EXPECT_TRUE(scene.names("out").empty());
}

}  // namespace
}  // namespace fluidymation
