#include "fluidymation/synthesis/synthesizer.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderWidthPx = 5.0F;

SynthesisOptions smallOptions() {
  SynthesisOptions options;
  options.borderWidthPx = kBorderWidthPx;
  options.prevModulation = {5.0F, 1.0F};
  return options;
}

std::vector<Image<Lab>> paintAll(const Exemplar& exemplar, const test::GrowingDisc& target,
                                 const SynthesisOptions& options) {
  Synthesizer synthesizer(exemplar, options);
  std::vector<Image<Lab>> frames;
  for (int j = 0; j < target.frameCount; ++j) frames.push_back(synthesizer.paint(target.guides(j)));
  return frames;
}

bool equalBytes(const std::vector<Image<Lab>>& a, const std::vector<Image<Lab>>& b) {
  for (std::size_t j = 0; j < a.size(); ++j) {
    if (std::memcmp(a[j].data(), b[j].data(), a[j].pixelCount() * sizeof(Lab)) != 0) return false;
  }
  return a.size() == b.size();
}

struct Statistics {
  double mean = 0.0;
  double deviation = 0.0;
};

/// Lightness of a picture at `fromPx` <= distance to the edge < `toPx`.
Statistics lightness(const Image<Lab>& picture, const GuideFrame& guides, float fromPx,
                     float toPx) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const float distance = guides.distance(x, y);
      if (distance < fromPx || distance >= toPx) continue;
      const double l = picture(x, y).l;
      sum += l;
      squares += l * l;
      ++count;
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean)};
}

class SynthesizerTest : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{72, 64}, {36.0F, 32.0F}, 14.0F, 1.0F, 6};
  test::GrowingDisc other_{Size{90, 80}, {45.0F, 40.0F}, 20.0F, 1.5F, 4};
};

TEST_F(SynthesizerTest, AnExemplarUsedAsItsOwnTargetKeepsItsLook) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  const std::vector<Image<Lab>> frames = paintAll(exemplar, disc_, smallOptions());
  for (int j = 0; j < disc_.frameCount; ++j) {
    SCOPED_TRACE(j);
    const GuideFrame guides = disc_.guides(j);
    const Image<Lab> original = test::paintedDisc(disc_, j, 31);
    const Image<Lab>& painted = frames[static_cast<std::size_t>(j)];
    const Statistics rim = lightness(original, guides, 1.0F, 3.0F);
    const Statistics paintedRim = lightness(painted, guides, 1.0F, 3.0F);
    EXPECT_NEAR(paintedRim.mean, rim.mean, 5.0);
    const Statistics body = lightness(original, guides, 5.0F, 99.0F);
    const Statistics paintedBody = lightness(painted, guides, 5.0F, 99.0F);
    EXPECT_NEAR(paintedBody.mean, body.mean, 3.0);
    EXPECT_GT(paintedBody.deviation, 0.6 * body.deviation);
    EXPECT_LT(paintedBody.deviation, 1.2 * body.deviation);
  }
}

TEST_F(SynthesizerTest, TheExemplarsFramesInReverseOrderServeEquallyWell) {
  // Thesis §3.5: reversing the source exchanges ext+ and ext- and negates the flow.
  Exemplar reversed(disc_.size, disc_.frameCount, 3, kBorderWidthPx);
  for (int k = 0; k < disc_.frameCount; ++k) {
    const int original = disc_.frameCount - 1 - k;
    GuideFrame guides = disc_.guides(original);
    std::swap(guides.accForward, guides.accBackward);
    for (Vec2& v : guides.flow) v = -1.0F * v;
    for (Vec2& v : guides.direction) v = -1.0F * v;
    for (Vec2& v : guides.accForward) v = -1.0F * v;
    for (Vec2& v : guides.accBackward) v = -1.0F * v;
    reversed.setColor(k, test::paintedDisc(disc_, original, 31));
    reversed.setGuides(k, guides);
  }
  reversed.finish();
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  const std::vector<Image<Lab>> forwards = paintAll(exemplar, other_, smallOptions());
  const std::vector<Image<Lab>> backwards = paintAll(reversed, other_, smallOptions());
  for (int j = 0; j < other_.frameCount; ++j) {
    const GuideFrame guides = other_.guides(j);
    for (const auto& [from, to] :
         {std::pair{1.0F, 3.0F}, std::pair{3.0F, 8.0F}, std::pair{8.0F, 99.0F}}) {
      const Statistics a = lightness(forwards[static_cast<std::size_t>(j)], guides, from, to);
      const Statistics b = lightness(backwards[static_cast<std::size_t>(j)], guides, from, to);
      EXPECT_NEAR(a.mean, b.mean, 2.0) << "frame " << j << ", " << from << " to " << to << " px";
      EXPECT_NEAR(a.deviation / b.deviation, 1.0, 0.2) << "frame " << j;
    }
  }
}

TEST_F(SynthesizerTest, MaterialAtRestKeepsItsPicture) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  test::GrowingDisc still = other_;
  still.speedPx = 0.0F;
  const std::vector<Image<Lab>> frames = paintAll(exemplar, still, smallOptions());
  const GuideFrame guides = still.guides(0);
  double change = 0.0;
  int count = 0;
  for (int y = 0; y < still.size.height; ++y) {
    for (int x = 0; x < still.size.width; ++x) {
      if (guides.mask(x, y) == 0) continue;
      change += std::abs(frames[3](x, y).l - frames[2](x, y).l);
      ++count;
    }
  }
  EXPECT_LT(change / count, 1.0) << "mean change of lightness between two still frames";
}

TEST_F(SynthesizerTest, SameBytesForAnyNumberOfThreadsAndForEveryRun) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  // On the finest level that is searched the disc lies in four tiles of 64 px
  const test::GrowingDisc large{Size{200, 190}, {128.0F, 100.0F}, 46.0F, 1.5F, 2};
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
  differs("dist-weight", [](SynthesisOptions& o) { o.distWeight = 0.0F; });
  differs("flow-weight", [](SynthesisOptions& o) { o.flowWeight = 5.0F; });
  differs("prev-weight", [](SynthesisOptions& o) { o.prevWeight = 0.0F; });
  differs("lambda", [](SynthesisOptions& o) { o.lambda = 0.0F; });
  differs("occ-radius", [](SynthesisOptions& o) { o.occRadiusFrames = 0; });
  differs("patchmatch-alpha", [](SynthesisOptions& o) { o.patchmatchAlpha = 0.5F; });
  differs("prev-modulation-bounds", [](SynthesisOptions& o) { o.prevModulation = {0.5F, 0.0F}; });
  differs("patchmatch-iterations", [](SynthesisOptions& o) { o.patchmatchIterations = {1}; });
  differs("opt-iterations", [](SynthesisOptions& o) { o.optIterations = {1}; });
}

}  // namespace
}  // namespace fluidymation
