#include "pipeline/memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/guides/packed_shape.h"
#include "fluidymation/presets.h"
#include "pipeline/inputs.h"
#include "support/png_maker.h"
#include "support/sanitizers.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation {
namespace {

TEST(Memory, ATypicalRunNeedsLittle) {
  // The run of docs/performance.md: 344 MiB were measured.
  const std::int64_t bytes = bytesOfRun({{400, 222}, 24, {1000, 800}, 8, 1, 2.0F, {1000, 800}});
  EXPECT_GT(bytes, 300 << 20);
  EXPECT_LT(bytes, 500 << 20);
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
  EXPECT_GT(changed([](RunSize& r) { r.target = {500, 401}; }), bytes);
  EXPECT_GT(changed([](RunSize& r) { r.targetFrames = 600; }), bytes);
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
  EXPECT_LT(bytesFor({128, 128}, 1024), kMaxRunBytes);
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
  const std::int64_t alone = bytesOfRun(run);
  run.threads = 2;
  const std::int64_t sideBySide = bytesOfRun(run);
  const std::int64_t pixels = 1000 * 800;
  EXPECT_GT(sideBySide - alone, 256 * pixels);
  EXPECT_LT(sideBySide - alone, 400 * pixels);
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
};

InputMask maskOf(MaskKind kind, Size size) {
  if (kind == MaskKind::kHard) return nearlyFull(size);
  InputMask soft(kind == MaskKind::kSoft ? nearlyFull(size) : test::randomMask(size, 3, 50));
  for (float& c : soft.coverage) c = c > 0.5F ? 0.8F : 0.2F;
  soft.soft = true;
  return soft;
}

/// What readers are told of a single mask.
ShapeTally tallyOf(const InputMask& mask, const MaskOptions& options) {
  ShapeTally tally;
  const auto copy = [&mask](int) { return InputMask(mask.coverage.clone(), mask.soft); };
  (void)readShapes(1, copy, options, [&tally](const ShapeTally& now) { tally = now; });
  return tally;
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
  const std::int64_t estimate =
      bytesOfRun(size) +
      bytesKept(tallyOf(maskOf(run.kind, run.target), {0.0F, 0.5F})) * run.frames;
  EXPECT_LE(result.peakBytes, estimate)
      << result.peakBytes / 1048576 << " MiB, estimate " << estimate / 1048576 << " MiB";
  if (run.kind == MaskKind::kDust) return;  // half of it is outside
  EXPECT_GT(result.peakBytes, estimate / 2) << "an estimate that refuses what would fit";
}

INSTANTIATE_TEST_SUITE_P(
    Sides, MemoryOfFullMasks,
    ::testing::Values(
        FullMaskRun{"exemplar", {1000, 800}, {40, 40}, 1},
        FullMaskRun{"movingExemplar", {700, 600}, {40, 40}, 3},
        FullMaskRun{"longExemplar", {200, 150}, {40, 40}, 40},
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

TEST(Memory, IsSaidInGibibytesRoundedUp) {
  EXPECT_EQ(gibibytes(kMaxRunBytes), "6.0 GiB");
  EXPECT_EQ(gibibytes((std::int64_t{1} << 30) + 1), "1.1 GiB");
  EXPECT_EQ(gibibytes(1), "0.1 GiB");
}

/// Frames of such a sequence that are read until the memory watch, with `freeBytes` left for their
/// masks, refuses it with `message`; all of them where it does not.
int framesRead(const InputMask& mask, int frameCount, const MaskOptions& options,
               std::int64_t freeBytes, std::string& message) {
  int read = 0;
  const auto reader = [&](int) {
    ++read;
    return InputMask(mask.coverage.clone(), mask.soft);
  };
  GuideOptions guides;
  guides.mask = options;
  const ShapeWatch watch = memoryWatch("t/%d.png", frameCount, kMaxRunBytes - freeBytes);
  try {
    const GuideStream stream(frameCount, reader, guides, {}, watch);
  } catch (const UsageError& error) {
    message = error.what();
  }
  return read;
}

TEST(Memory, SmoothedMasksAreCountedAsTheyAreRead) {
  struct Case {
    const char* name;
    InputMask mask;
    MaskOptions options;
    std::int64_t pixels;
  };
  const Size size{30, 20};
  Case cases[] = {
      {"hard", test::maskOf(size, [](int x, int) { return x < 12; }), {0.0F, 0.5F}, 12 * 20},
      // A hard edge smoothed by 4 px comes 2 px further out at 0.3
      {"grown", test::maskOf(size, [](int x, int) { return x < 12; }), {4.0F, 0.3F}, 14 * 20},
      // Gray of 0.4 is nothing at one half, and everything at 0.3
      {"gray", InputMask(Image<float>(size, 0.4F), true), {1.0F, 0.3F}, 30 * 20},
  };
  for (const Case& tested : cases) {
    SCOPED_TRACE(tested.name);
    const std::int64_t bytes = kBytesPerMaskPixel * tested.pixels;
    std::string message;
    EXPECT_EQ(framesRead(tested.mask, 3, tested.options, 3 * bytes, message), 3);
    EXPECT_EQ(message, "");
    EXPECT_EQ(framesRead(tested.mask, 3, tested.options, 2 * bytes - 1, message), 2);
    EXPECT_EQ(
        message,
        "--target-path t/%d.png: the first 2 of 3 frames need about 6.1 GiB of memory; wanted "
        "at most 6.0 GiB (--target-frames, --target-scale)");
  }
}

TEST(Memory, OfSoftMasksTheOutlineCountsToo) {
  const Mask half = test::maskOf({10, 6}, [](int x, int) { return x < 4; });
  const MaskOptions unsmoothed{0.0F, 0.5F};
  EXPECT_EQ(bytesKept(tallyOf(half, unsmoothed)), 24 * kBytesPerMaskPixel);
  InputMask soft(half);
  soft.soft = true;
  EXPECT_EQ(bytesKept(tallyOf(soft, unsmoothed)), 24 * kBytesPerMaskPixel + 6 * kBytesPerCrossing);
}

TEST(Memory, ASequenceThatTurnsSoftCountsTheOutlinesBeforeToo) {
  const Mask half = test::maskOf({10, 6}, [](int x, int) { return x < 4; });
  std::vector<std::int64_t> crossings;
  const auto reader = [&half](int frame) {
    InputMask mask(half);
    mask.soft = frame == 1;
    return mask;
  };
  (void)readShapes(2, reader, {0.0F, 0.5F},
                   [&](const ShapeTally& tally) { crossings.push_back(tally.crossings); });
  EXPECT_EQ(crossings, (std::vector<std::int64_t>{0, 12}));
}

TEST(Memory, ARunThatWouldNotFitIsRefusedFromTheHeaders) {
  const test::SmallScene scene(4);
  // Each frame is within the limits of a frame.
  for (int number = 1; number <= 4; ++number) {
    const test::Bytes large = test::maskPng(Mask(Size{1000, 1000}));
    scene.write(test::SmallScene::frame("src", number), large);
    scene.write(test::SmallScene::frame("mask", number), large);
  }
  const test::ProcessResult refused = scene.paint({{"--quiet", ""}, {"--src-scale", "6"}});
  EXPECT_TRUE(test::failedNaming(
      2, "--src-path src/%05d.png, --target-path target/%05d.png: 4 frames of 6000x6000 and 4 of ",
      {", stored with up to 1000x1000, need about ",
       " GiB of memory; wanted at most 6.0 GiB (--src-frames"},
      refused));
  EXPECT_LT(refused.peakBytes, 400'000'000);
  EXPECT_TRUE(scene.names("out").empty());
}

}  // namespace
}  // namespace fluidymation
