#include "fluidymation/synthesis/synthesizer.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "fluidymation/presets.h"
#include "support/shapes.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderWidthPx = 5.0F;

SynthesisOptions smallOptions() {
  Options thesis;
  applyThesisPreset(thesis);  // what the standard look changes has tests of its own
  SynthesisOptions options = thesis.synthesis;
  options.prevModulation = {5.0F, 1.0F, ModulationUnit::kPixels};
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
Statistics lightness(const Image<Lab>& picture, const Image<float>& distancePx, float fromPx,
                     float toPx) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const float distance = distancePx(x, y);
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

/// Mean square of the steps of lightness to the right and lower neighbour, where all are at least
/// `fromPx` deep: how much detail a picture has.
double gradientEnergy(const Image<Lab>& picture, const Image<float>& distancePx, float fromPx) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y + 1 < picture.height(); ++y) {
    for (int x = 0; x + 1 < picture.width(); ++x) {
      if (std::min({distancePx(x, y), distancePx(x + 1, y), distancePx(x, y + 1)}) < fromPx) {
        continue;
      }
      const double right = picture(x + 1, y).l - picture(x, y).l;
      const double down = picture(x, y + 1).l - picture(x, y).l;
      sum += right * right + down * down;
      ++count;
    }
  }
  return sum / count;
}

/// The frames of a painted disc that brightens as it grows, with the guides that the pipeline makes
/// of its masks; in reverse order where wanted, as the files of a film played backwards.
struct Film {
  static constexpr float kBrighteningPerFrame = 3.0F;

  Film(const test::GrowingDisc& disc, std::uint64_t seed, bool backwards = false) {
    std::vector<Mask> masks;
    for (int i = 0; i < disc.frameCount; ++i) {
      const int frame = backwards ? disc.frameCount - 1 - i : i;
      masks.push_back(test::disc(disc.size, disc.centre, disc.radiusPx(frame)));
      pictures.push_back(test::paintedDisc(disc, frame, seed));
      for (std::size_t p = 0; p < masks.back().pixelCount(); ++p) {
        if (masks.back().data()[p] == 0) continue;
        pictures.back().data()[p].l += kBrighteningPerFrame * static_cast<float>(frame);
      }
    }
    guides = test::guidesOf(masks, 2.0F);
  }

  [[nodiscard]] Exemplar exemplar() const {
    Exemplar result(pictures.front().size(), static_cast<int>(guides.size()), 3, kBorderWidthPx);
    for (std::size_t k = 0; k < guides.size(); ++k) {
      result.setColor(static_cast<int>(k), pictures[k]);
      result.setGuides(static_cast<int>(k), guides[k]);
    }
    result.finish();
    return result;
  }

  /// The frames' shapes painted by `film`.
  [[nodiscard]] std::vector<Image<Lab>> paintedBy(const Film& film,
                                                  const SynthesisOptions& options) const {
    const Exemplar exemplar = film.exemplar();
    Synthesizer synthesizer(exemplar, options);
    std::vector<Image<Lab>> frames;
    for (const GuideFrame& frame : guides) frames.push_back(synthesizer.paint(frame));
    return frames;
  }

  std::vector<GuideFrame> guides;
  std::vector<Image<Lab>> pictures;
};

class SynthesizerTest : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{72, 64}, {36.0F, 32.0F}, 14.0F, 1.0F, 6};
  test::GrowingDisc other_{Size{90, 80}, {45.0F, 40.0F}, 20.0F, 1.5F, 4};
};

TEST_F(SynthesizerTest, AnExemplarUsedAsItsOwnTargetKeepsItsLook) {
  const Film film(disc_, 31);
  const std::vector<Image<Lab>> frames = film.paintedBy(film, smallOptions());
  for (std::size_t j = 0; j < frames.size(); ++j) {
    SCOPED_TRACE(j);
    const Image<float>& distance = film.guides[j].distance;
    // The rim, pixel by pixel
    for (float depth = 1.0F; depth < 7.0F; depth += 1.0F) {
      const double original = lightness(film.pictures[j], distance, depth, depth + 1.0F).mean;
      EXPECT_NEAR(lightness(frames[j], distance, depth, depth + 1.0F).mean, original, 1.5) << depth;
    }
    // The grain
    const double detail = gradientEnergy(frames[j], distance, 2.0F) /
                          gradientEnergy(film.pictures[j], distance, 2.0F);
    EXPECT_GT(detail, 0.97);
    EXPECT_LT(detail, 1.03);
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
      const Statistics a =
          lightness(forwards[static_cast<std::size_t>(j)], guides.distance, from, to);
      const Statistics b =
          lightness(backwards[static_cast<std::size_t>(j)], guides.distance, from, to);
      EXPECT_NEAR(a.mean, b.mean, 2.0) << "frame " << j << ", " << from << " to " << to << " px";
      EXPECT_NEAR(a.deviation / b.deviation, 1.0, 0.2) << "frame " << j;
    }
  }
}

TEST_F(SynthesizerTest, TheExemplarsFilesInReverseOrderServeEquallyWell) {
  // The medium brightens as it spreads, so that a frame taken for another shows
  SynthesisOptions options = smallOptions();
  options.flowWeight = 2.0F;
  const Film target(other_, 5);
  const std::vector<Image<Lab>> forwards = target.paintedBy(Film(disc_, 31, false), options);
  const std::vector<Image<Lab>> backwards = target.paintedBy(Film(disc_, 31, true), options);
  for (std::size_t j = 0; j < forwards.size(); ++j) {
    SCOPED_TRACE(j);
    const Image<float>& distance = target.guides[j].distance;
    for (const auto& [from, to] :
         {std::pair{1.0F, 3.0F}, std::pair{3.0F, 8.0F}, std::pair{8.0F, 99.0F}}) {
      const Statistics a = lightness(forwards[j], distance, from, to);
      const Statistics b = lightness(backwards[j], distance, from, to);
      EXPECT_NEAR(a.mean, b.mean, 3.0) << from << " to " << to << " px";
      EXPECT_NEAR(a.deviation / b.deviation, 1.0, 0.25) << from << " to " << to << " px";
    }
    const double detail =
        gradientEnergy(forwards[j], distance, 2.0F) / gradientEnergy(backwards[j], distance, 2.0F);
    EXPECT_NEAR(detail, 1.0, 0.3);
  }
}

/// Mean change of lightness from frame to frame, where the first of both is more than 4 px deep.
double flicker(const Exemplar& exemplar, const test::GrowingDisc& disc,
               const SynthesisOptions& options) {
  const std::vector<Image<Lab>> frames = paintAll(exemplar, disc, options);
  double change = 0.0;
  int count = 0;
  for (int j = 1; j < disc.frameCount; ++j) {
    const GuideFrame guides = disc.guides(j - 1);
    const auto i = static_cast<std::size_t>(j);
    for (int y = 0; y < disc.size.height; ++y) {
      for (int x = 0; x < disc.size.width; ++x) {
        if (guides.distance(x, y) <= 4.0F) continue;
        change += std::abs(frames[i](x, y).l - frames[i - 1](x, y).l);
        ++count;
      }
    }
  }
  return change / count;
}

/// The same where the disc grows by half a pixel per frame.
double slowFlicker(const Exemplar& exemplar, test::GrowingDisc disc,
                   const SynthesisOptions& options) {
  disc.speedPx = 0.5F;
  return flicker(exemplar, disc, options);
}

TEST_F(SynthesizerTest, MaterialAtRestKeepsItsPicture) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  test::GrowingDisc still = other_;
  still.speedPx = 0.0F;
  still.frameCount = 2;
  SynthesisOptions options = smallOptions();
  options.lambda = 8.0F;  // many matches change in every frame
  const double kept = flicker(exemplar, still, options);
  EXPECT_LT(kept, 0.5);
  options.prevWeight = 0.0F;
  EXPECT_LT(kept, 0.75 * flicker(exemplar, still, options)) << "no previous frame is looked at";
}

TEST_F(SynthesizerTest, SlowMaterialKeepsItsPictureBecauseOfThePreviousFrame) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  SynthesisOptions options = smallOptions();
  const double kept = slowFlicker(exemplar, other_, options);
  options.prevWeight = 0.0F;
  EXPECT_LT(kept, 0.6 * slowFlicker(exemplar, other_, options));
}

TEST_F(SynthesizerTest, FullResolutionMatchesOfTheLastFrameCalmTheFinestLevel) {
  const Exemplar exemplar = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  SynthesisOptions options = smallOptions();
  const double upscaled = slowFlicker(exemplar, other_, options);
  options.finestLevel = FinestLevel::kRefined;
  const double refined = slowFlicker(exemplar, other_, options);
  options.finestLevel = FinestLevel::kSearched;
  const double searched = slowFlicker(exemplar, other_, options);
  EXPECT_LT(refined, 0.6 * upscaled);
  EXPECT_LT(searched, 0.6 * upscaled);
}

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
    // Only matches that are not legal there are moved; one sweep, however many are asked for
    EXPECT_LT(changes(upscaled, nnfOf(finest, {2, 2, 2, 0})), 0.25 * inside);
    EXPECT_GT(changes(upscaled, nnfOf(finest, {2, 2, 2, 1})), 0.4 * inside);
    EXPECT_EQ(changes(nnfOf(finest, {2, 2, 2, 1}), nnfOf(finest, {2, 2, 2, 5})), 0);
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
  differs("tex-weight", [](SynthesisOptions& o) { o.texWeight = 0.0F; });
  differs("dist-weight", [](SynthesisOptions& o) { o.distWeight = 0.0F; });
  differs("flow-weight", [](SynthesisOptions& o) { o.flowWeight = 5.0F; });
  differs("prev-weight", [](SynthesisOptions& o) { o.prevWeight = 0.0F; });
  differs("lambda", [](SynthesisOptions& o) { o.lambda = 0.0F; });
  differs("occ-radius", [](SynthesisOptions& o) { o.occRadiusFrames = 0; });
  differs("patchmatch-alpha", [](SynthesisOptions& o) { o.patchmatchAlpha = 0.5F; });
  differs("prev-modulation-bounds", [](SynthesisOptions& o) {
    o.prevModulation = {0.5F, 0.0F, ModulationUnit::kPixels};
  });
  differs("patchmatch-iterations", [](SynthesisOptions& o) { o.patchmatchIterations = {1}; });
  differs("opt-iterations", [](SynthesisOptions& o) { o.optIterations = {1}; });
}

}  // namespace
}  // namespace fluidymation
