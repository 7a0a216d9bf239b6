#include "pipeline/memory.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "pipeline/inputs.h"
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
  const RunSize run{{400, 300}, 20, {500, 400}, 300, 2, 2.0F, {500, 400}};
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
}

TEST(Memory, FramesAreDecodedAtTheirStoredSize) {
  // 28 bytes per stored pixel were measured, whatever a frame is scaled to.
  const Size stored{12000, 10000};
  const std::int64_t bytes = bytesOfRun({{120, 100}, 4, {120, 100}, 4, 1, 2.0F, stored});
  EXPECT_GT(bytes, std::int64_t{28} * 12000 * 10000);
  EXPECT_LT(bytes, std::int64_t{29} * 12000 * 10000);
}

TEST(Memory, NoMoreThreadsCountThanTilesAreSearched) {
  const auto bytesFor = [](Size target, int threads) {
    return bytesOfRun({{1000, 800}, 50, target, 4, threads, 2.0F, {1000, 800}});
  };
  EXPECT_EQ(bytesFor({128, 128}, 1024), bytesFor({128, 128}, 1)) << "one tile of half the size";
  EXPECT_LT(bytesFor({128, 128}, 1024), kMaxRunBytes);
  EXPECT_GT(bytesFor({1000, 128}, 1024), bytesFor({1000, 128}, 7));
  EXPECT_EQ(bytesFor({1000, 128}, 1024), bytesFor({1000, 128}, 8));
  EXPECT_EQ(bytesFor({9, 700}, 1024), bytesFor({9, 700}, 11)) << "a single level is searched whole";
}

TEST(Memory, IsSaidInGibibytesRoundedUp) {
  EXPECT_EQ(gibibytes(kMaxRunBytes), "6.0 GiB");
  EXPECT_EQ(gibibytes((std::int64_t{1} << 30) + 1), "1.1 GiB");
  EXPECT_EQ(gibibytes(1), "0.1 GiB");
}

TEST(Memory, MaskPixelsAreCountedAsTheyAreRead) {
  const test::SmallScene scene(3);
  InputSequence masks;
  masks.stored = masks.scaled = Size{28, 22};
  std::int64_t insideOfTwo = 0;
  for (int number = 1; number <= 3; ++number) {
    masks.files.paths.push_back(scene.file(test::SmallScene::frame("target", number)));
    if (number < 3) insideOfTwo += static_cast<std::int64_t>(countInside(scene.targetMask(number)));
  }
  const MaskReader read = countingReader(masks, MaskChannel::kBrightness, "t/%d.png",
                                         kMaxRunBytes - kBytesPerMaskPixel * insideOfTwo);
  EXPECT_EQ(countInside(read(0)), countInside(scene.targetMask(1)));
  EXPECT_EQ(countInside(read(1)), countInside(scene.targetMask(2)));
  EXPECT_EQ(test::messageOf<UsageError>([&] { (void)read(2); }),
            "--target-path t/%d.png: the first 3 of 3 frames need about 6.1 GiB of memory; wanted "
            "at most 6.0 GiB (--target-frames, --target-scale)");
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
