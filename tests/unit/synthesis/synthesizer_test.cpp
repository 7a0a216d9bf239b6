#include "fluidymation/synthesis/synthesizer.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "support/shapes.h"
#include "support/synthetic_scene.h"
#include "synthesis/patch_kernels.h"
#include "synthesizer_fixture.h"

namespace fluidymation {
namespace {

TEST_F(SynthesizerTest, NoIterationsAtTheEndOfTheListLeaveTheFinestLevelUnswept) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  const auto nnfOf = [&](FinestLevel finest, const std::vector<int>& iterations) {
    SynthesisOptions options = smallOptions();
    options.finestLevel = finest;
    options.optIterations = iterations;
    Synthesizer synthesizer(exemplar, options);
    (void)synthesizer.paint(other_.guides(0));
    return synthesizer.nnf().clone();
  };
  const auto changes = [](const NearestNeighborField& a, const NearestNeighborField& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixelCount(); ++i) {
      const Match& first = a.data()[i];
      const Match& second = b.data()[i];
      count += first.x == second.x && first.y == second.y && first.frame == second.frame ? 0 : 1;
    }
    return count;
  };
  const int inside = static_cast<int>(countInside(other_.guides(0).mask));
  const NearestNeighborField upscaled = nnfOf(FinestLevel::kUpscaled, {2, 2, 2, 0});
  for (const FinestLevel finest : {FinestLevel::kRefined, FinestLevel::kSearched}) {
    // Only matches that are not legal there are moved, 2 to 4 % over several seeds; a sweep changes
    // 16 to 39 %. One sweep, however many are asked for
    EXPECT_LT(changes(upscaled, nnfOf(finest, {2, 2, 2, 0})), 0.06 * inside);
    EXPECT_GT(changes(upscaled, nnfOf(finest, {2, 2, 2, 1})), 0.12 * inside);
    EXPECT_EQ(changes(nnfOf(finest, {2, 2, 2, 1}), nnfOf(finest, {2, 2, 2, 5})), 0);
  }
}

/// It is given a part of each frame, only so much as it asks for, and goes on from such a part.
TEST_F(SynthesizerTest, PaintsAPartAsTheWholeFrame) {
  const Size size{190, 150};
  test::GrowingDisc small{size, {140.0F, 96.0F}, 11.0F, 1.5F, 4};
  struct Case {
    int coarsest;
    SynthesisOptions options;
  };
  for (const auto& [coarsest, options] :
       {Case{0, smallOptions()}, Case{3, smallOptions()}, Case{3, SynthesisOptions()}}) {
    SCOPED_TRACE(coarsest);
    const Exemplar exemplar = test::discExemplar(disc_, coarsest, kBorderWidthPx, 31);
    Synthesizer ofWhole(exemplar, options);
    Synthesizer ofParts(exemplar, options);
    for (int j = 0; j < small.frameCount; ++j) {
      const GuideFrame whole = small.guides(j);
      const FramePart part{size, grown(boundingBox(whole.mask), ofParts.marginPx(), size)};
      const auto here = [&](const auto& image) { return cropped(image, part.box); };
      GuidePart guides{part, {}};
      guides.guides.mask = here(whole.mask);
      guides.guides.distance = here(whole.distance);
      guides.guides.flow = here(whole.flow);
      guides.guides.direction = here(whole.direction);
      guides.guides.accForward = here(whole.accForward);
      guides.guides.accBackward = here(whole.accBackward);
      const Image<Lab> picture = ofWhole.paint(whole);
      ofParts.paint(guides);
      EXPECT_LT(ofParts.part().box.size().width, size.width);
      EXPECT_TRUE(sameBytes(picture, wholeFrame(ofParts.picture(), ofParts.part()))) << j;
      EXPECT_TRUE(sameBytes(ofWhole.nnf(), ofParts.nnf())) << j;
      Synthesizer resumed(exemplar, options);
      resumed.restore(ofParts.state(), guides);
      resumed.paint(guides);
      ofParts.paint(guides);
      EXPECT_TRUE(sameBytes(resumed.picture(), ofParts.picture())) << j;
      (void)ofWhole.paint(whole);
    }
  }
}

TEST_F(SynthesizerTest, GuidesAlonePlaceTheMatchesOfAFreshFrame) {
  // Without any search after the first one the field must not know the exemplar's colours
  SynthesisOptions options = smallOptions();
  options.optIterations = {0};
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  const Exemplar recoloured = test::discExemplar(disc_, 3, kBorderWidthPx, 77);
  Synthesizer one(exemplar, options);
  Synthesizer two(recoloured, options);
  const Image<Lab> picture = one.paint(other_.guides(0));
  const Image<Lab> recolouredPicture = two.paint(other_.guides(0));
  EXPECT_NE(
      std::memcmp(picture.data(), recolouredPicture.data(), picture.pixelCount() * sizeof(Lab)), 0);
  EXPECT_EQ(std::memcmp(one.nnf().data(), two.nnf().data(), one.nnf().pixelCount() * sizeof(Match)),
            0);
}

TEST_F(SynthesizerTest, WhatHadNoPreviousFrameRemembersNone) {
  // A second disc appears far from the first. No window sees both, and without uniformity nothing
  // else connects them: the weight of the previous frame must not show in the new one.
  const Size size{200, 64};
  std::vector<Mask> masks;
  for (const bool both : {false, true}) {
    masks.push_back(test::maskOf(size, [&](int x, int y) {
      const Vec2 here{static_cast<float>(x), static_cast<float>(y)};
      return length(here - Vec2{32.0F, 32.0F}) < 16.0F ||
             (both && length(here - Vec2{160.0F, 32.0F}) < 16.0F);
    }));
  }
  const std::vector<GuideFrame> guides = test::guidesOf(masks, 0.0F);
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  std::vector<Image<Lab>> pictures;
  for (const float prevWeight : {0.0F, 5.0F}) {
    SynthesisOptions options = smallOptions();
    options.lambda = 0.0F;
    options.prevWeight = prevWeight;
    Synthesizer synthesizer(exemplar, options);
    (void)synthesizer.paint(guides[0]);
    pictures.push_back(synthesizer.paint(guides[1]));
  }
  int oldChanged = 0;
  int newChanged = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (guides[1].mask(x, y) == 0 || pictures[0](x, y).l == pictures[1](x, y).l) continue;
      ++(x < 96 ? oldChanged : newChanged);
    }
  }
  EXPECT_GT(oldChanged, 100);
  EXPECT_EQ(newChanged, 0);
}

TEST_F(SynthesizerTest, SameBytesForAnyNumberOfThreadsAndForEveryRun) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  // On the finest level that is searched the box round the disc has four tiles of 64 px
  const test::GrowingDisc large{Size{200, 190}, {104.0F, 96.0F}, 72.0F, 1.5F, 2};
  ASSERT_GT(exemplar.levelCount(), 1);
  ASSERT_GT(static_cast<int>(2.0F * large.radiusPx(0)) / 2, kTileSidePx);
  const int defaultThreads = omp_get_max_threads();
  const std::vector<Image<Lab>> reference = paintAll(exemplar, large, smallOptions());
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    EXPECT_TRUE(equalBytes(reference, paintAll(exemplar, large, smallOptions()))) << threads;
  }
  omp_set_num_threads(defaultThreads);
  SynthesisOptions otherSeed = smallOptions();
  otherSeed.seed = 1;
  EXPECT_FALSE(equalBytes(reference, paintAll(exemplar, large, otherSeed)));
}

TEST_F(SynthesizerTest, SameBytesWithEveryInstructionSet) {
  if (avx2Kernels() == nullptr) GTEST_SKIP() << "no AVX2 in this build or processor";
  const test::GrowingDisc target{Size{120, 110}, {58.0F, 54.0F}, 36.0F, 1.5F, 4};
  SynthesisOptions directed;
  directed.dirWeight = 2.0F;
  directed.paintedVote.interpolation = Interpolation::kCubic;
  for (const SynthesisOptions& options : {SynthesisOptions(), smallOptions(), directed}) {
    Exemplar exemplar = test::discExemplar(disc_, 2, kBorderWidthPx, 31);
    exemplar.use(*avx2Kernels());
    const std::vector<Image<Lab>> frames = paintAll(exemplar, target, options);
    exemplar.use(portableKernels());
    EXPECT_TRUE(equalBytes(paintAll(exemplar, target, options), frames));
  }
}

TEST_F(SynthesizerTest, EmptyFramesAreLegalAndTheNextOneStartsAfresh) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  GuideFrame empty = other_.guides(0);
  for (auto& m : empty.mask) m = 0;
  Synthesizer synthesizer(exemplar, smallOptions());
  (void)synthesizer.paint(empty);
  EXPECT_FALSE(synthesizer.nnf()(45, 40).exists());
  (void)synthesizer.paint(other_.guides(1));
  EXPECT_TRUE(synthesizer.nnf()(45, 40).exists());
  (void)synthesizer.paint(empty);
  EXPECT_FALSE(synthesizer.nnf()(45, 40).exists());
}

TEST_F(SynthesizerTest, ImagesSmallerThanAPatchWork) {
  for (const int side : {1, 3}) {
    const auto middle = static_cast<float>(side / 2);
    const test::GrowingDisc tiny{Size{side, side}, {middle, middle}, 1.2F, 0.0F, 2};
    ASSERT_EQ(coarsestLevel(tiny.size, tiny.size), 0);
    const Exemplar exemplar = test::discExemplar(tiny, 0, kBorderWidthPx, 31);
    const std::vector<Image<Lab>> frames = paintAll(exemplar, tiny, smallOptions());
    for (const Image<Lab>& frame : frames) EXPECT_TRUE(std::isfinite(frame(0, 0).l));
  }
}

TEST_F(SynthesizerTest, EveryWeightChangesThePicture) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  const std::vector<Image<Lab>> reference = paintAll(exemplar, other_, smallOptions());
  const auto differs = [&](const char* what, auto change) {
    SynthesisOptions options = smallOptions();
    change(options);
    EXPECT_FALSE(equalBytes(reference, paintAll(exemplar, other_, options))) << what;
  };
  differs("tex-weight", [](SynthesisOptions& o) { o.texWeight = 0.0F; });
  differs("dist-weight", [](SynthesisOptions& o) { o.distWeight = 0.0F; });
  differs("flow-weight", [](SynthesisOptions& o) { o.flowWeight = 5.0F; });
  differs("prev-weight", [](SynthesisOptions& o) { o.prevWeight = 0.0F; });
  differs("prev-deepening", [](SynthesisOptions& o) { o.prevDeepening = 2.5F; });
  differs("coherence-weight", [](SynthesisOptions& o) { o.coherenceWeight = 100.0F; });
  differs("change-blending", [](SynthesisOptions& o) { o.changeBlending = 0.5F; });
  differs("detail-restoration", [](SynthesisOptions& o) { o.detailRestoration = 1.0F; });
  differs("prevGain", [](SynthesisOptions& o) { o.prevGain = 2.0F; });
  differs("lambda", [](SynthesisOptions& o) { o.lambda = 0.0F; });
  differs("occ-radius", [](SynthesisOptions& o) { o.occRadiusFrames = 0; });
  differs("patchmatch-alpha", [](SynthesisOptions& o) { o.patchmatchAlpha = 0.5F; });
  differs("prev-modulation-bounds", [](SynthesisOptions& o) {
    o.prevModulation = {0.5F, 0.0F, ModulationUnit::kPixels};
  });
  differs("patchmatch-iterations", [](SynthesisOptions& o) { o.patchmatchIterations = {1}; });
  differs("opt-iterations", [](SynthesisOptions& o) { o.optIterations = {1}; });
}

TEST_F(SynthesizerTest, TheFieldHasTheFramesSizeAndMatchesInTheMaskAlone) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  // Far from the corner in which the boxes of work begin; moved from frame to frame
  std::vector<Mask> masks;
  for (const float x : {61.0F, 78.0F, 40.0F}) {
    masks.push_back(test::disc(Size{131, 117}, {x, 70.0F}, 15.0F));
  }
  Synthesizer synthesizer(exemplar, smallOptions());
  for (const GuideFrame& guides : test::guidesOf(masks, 0.0F)) {
    const Image<Lab> picture = synthesizer.paint(guides);
    const NearestNeighborField nnf = synthesizer.nnf();
    ASSERT_EQ(picture.size(), guides.mask.size());
    ASSERT_EQ(nnf.size(), guides.mask.size());
    for (int y = 0; y < nnf.height(); ++y) {
      for (int x = 0; x < nnf.width(); ++x) {
        ASSERT_EQ(nnf(x, y).exists(), guides.mask(x, y) != 0) << x << ", " << y;
        if (guides.mask(x, y) == 0) continue;
        ASSERT_GT(picture(x, y).l, 1.0F) << x << ", " << y;
      }
    }
  }
}

TEST_F(SynthesizerTest, EmptyRowsAndColumnsBehindTheShapeChangeNothing) {
  // To the right and below, whole blocks of the coarsest level: coordinates, which random numbers
  // depend on, stay what they are
  constexpr int kLevels = 4;
  constexpr int kBlock = 1 << (kLevels - 1);
  const Exemplar exemplar = test::discExemplar(disc_, kLevels - 1, kBorderWidthPx, 31);
  const test::GrowingDisc small{Size{11 * kBlock, 10 * kBlock}, {40.0F, 36.0F}, 14.0F, 1.0F, 3};
  test::GrowingDisc padded = small;
  padded.size = {13 * kBlock, 17 * kBlock};
  for (const FinestLevel finest :
       {FinestLevel::kUpscaled, FinestLevel::kRefined, FinestLevel::kSearched}) {
    SynthesisOptions options = smallOptions();
    options.finestLevel = finest;
    Synthesizer one(exemplar, options);
    Synthesizer other(exemplar, options);
    const Box all{0, 0, small.size.width, small.size.height};
    for (int j = 0; j < small.frameCount; ++j) {
      const Image<Lab> picture = one.paint(small.guides(j));
      const Image<Lab> paddedPicture = other.paint(padded.guides(j));
      ASSERT_EQ(paddedPicture.size(), padded.size);
      EXPECT_TRUE(sameBytes(cropped(paddedPicture, all), picture)) << j;
      EXPECT_TRUE(sameBytes(cropped(other.nnf(), all), one.nnf())) << j;
    }
  }
}

TEST_F(SynthesizerTest, GuidesCountAsFarFromTheMaskAsTheCoarsestWindowsReach) {
  // The mask lies in the blocks from 4 to 8 across and 4 to 7 down; windows reach two blocks
  // further
  constexpr int kLevels = 4;
  constexpr int kBlock = 1 << (kLevels - 1);
  const Exemplar exemplar = test::discExemplar(disc_, kLevels - 1, kBorderWidthPx, 31);
  const test::GrowingDisc target{Size{13 * kBlock, 12 * kBlock}, {51.5F, 47.5F}, 16.0F, 1.0F, 1};
  const auto painted = [&](const Box& changed) {
    GuideFrame guides = target.guides(0);
    for (int y = changed.beginY; y < changed.endY; ++y) {
      for (int x = changed.beginX; x < changed.endX; ++x) guides.distance(x, y) -= 20.0F;
    }
    Synthesizer synthesizer(exemplar, smallOptions());
    return synthesizer.paint(guides);
  };
  const auto blocks = [](int beginX, int beginY, int endX, int endY) {
    return Box{kBlock * beginX, kBlock * beginY, kBlock * endX, kBlock * endY};
  };
  ASSERT_EQ(alignedTo(boundingBox(target.guides(0).mask), kBlock, target.size), blocks(4, 4, 9, 8));
  const Image<Lab> reference = painted({});
  for (const Box& within :
       {blocks(2, 0, 3, 12), blocks(10, 0, 11, 12), blocks(0, 2, 13, 3), blocks(0, 9, 13, 10)}) {
    EXPECT_FALSE(sameBytes(painted(within), reference))
        << "from " << within.beginX << ", " << within.beginY;
  }
  for (const Box& beyond :
       {blocks(0, 0, 2, 12), blocks(11, 0, 13, 12), blocks(0, 0, 13, 2), blocks(0, 10, 13, 12)}) {
    EXPECT_TRUE(sameBytes(painted(beyond), reference))
        << "from " << beyond.beginX << ", " << beyond.beginY;
  }
}

/// Writes down what it is told, and complains of stages that overlap.
class StageRecorder : public StageObserver {
 public:
  void begins(Stage stage, int level) override {
    EXPECT_FALSE(open_) << "stages overlap";
    open_ = {stage, level};
  }
  void ends(Stage stage, int level) override {
    ASSERT_TRUE(open_);
    EXPECT_EQ(*open_, std::pair(stage, level));
    stages_.push_back(*open_);
    open_.reset();
  }
  void searched(int level, const SearchStatistics& done) override {
    EXPECT_FALSE(open_);
    ASSERT_FALSE(stages_.empty());
    EXPECT_EQ(stages_.back(), std::pair(Stage::kSearch, level)) << "the stage that has just ended";
    done_ += done;
    ++searches_;
  }

  [[nodiscard]] bool isBetweenStages() const { return !open_; }
  [[nodiscard]] int count(Stage stage) const {
    return static_cast<int>(std::count_if(stages_.begin(), stages_.end(),
                                          [stage](const auto& s) { return s.first == stage; }));
  }
  [[nodiscard]] int count() const { return static_cast<int>(stages_.size()); }
  [[nodiscard]] int count(Stage stage, int level) const {
    return static_cast<int>(std::count(stages_.begin(), stages_.end(), std::pair(stage, level)));
  }
  [[nodiscard]] int searches() const { return searches_; }
  [[nodiscard]] const SearchStatistics& done() const { return done_; }

 private:
  std::optional<std::pair<Stage, int>> open_;
  std::vector<std::pair<Stage, int>> stages_;
  SearchStatistics done_;
  int searches_ = 0;
};

TEST_F(SynthesizerTest, AnObserverIsToldOfEveryStageOnceItRunsAndChangesNothing) {
  constexpr int kCoarsest = 3;
  const Exemplar exemplar = test::discExemplar(disc_, kCoarsest, kBorderWidthPx, 31);
  SynthesisOptions options = smallOptions();
  options.finestLevel = FinestLevel::kRefined;
  const std::vector<Image<Lab>> unobserved = paintAll(exemplar, other_, options);
  StageRecorder recorder;
  Synthesizer synthesizer(exemplar, options, &recorder);
  std::vector<Image<Lab>> observed;
  for (int j = 0; j < other_.frameCount; ++j) {
    observed.push_back(synthesizer.paint(other_.guides(j)));
    EXPECT_TRUE(recorder.isBetweenStages());
  }
  EXPECT_TRUE(equalBytes(observed, unobserved));

  const int frames = other_.frameCount;
  for (const Stage once : {Stage::kLevels, Stage::kShift, Stage::kPaint}) {
    EXPECT_EQ(recorder.count(once, 0), frames);
    EXPECT_EQ(recorder.count(once), frames) << "they concern all levels, or the finest";
  }
  for (int level = 0; level <= kCoarsest; ++level) {
    SCOPED_TRACE(level);
    const bool enlarged = level < kCoarsest;
    EXPECT_EQ(recorder.count(Stage::kUpscale, level), enlarged ? frames : 0);
    EXPECT_EQ(recorder.count(Stage::kPrevious, level), frames - 1);
    EXPECT_EQ(recorder.count(Stage::kMerge, level), enlarged ? frames - 1 : 0);
    EXPECT_EQ(recorder.count(Stage::kVote, level),
              recorder.count(Stage::kSearch, level) - (enlarged ? 0 : 1))
        << "a vote before every search but for that which starts afresh";
    EXPECT_GT(recorder.count(Stage::kSearch, level), 0);
    EXPECT_GE(recorder.count(Stage::kRepair, level), frames);
  }
  EXPECT_EQ(recorder.searches(), recorder.count(Stage::kSearch));
  EXPECT_GT(recorder.done().distances, 0U);
  EXPECT_GE(recorder.done().samples, recorder.done().distances) << "at least one each";

  // What is held is not worked over
  test::GrowingDisc still = other_;
  still.speedPx = 0.0F;
  (void)synthesizer.paint(still.guides(0));
  const int before = recorder.count();
  (void)synthesizer.paint(still.guides(0));
  EXPECT_TRUE(synthesizer.held());
  EXPECT_EQ(recorder.count(), before);
}

}  // namespace
}  // namespace fluidymation
