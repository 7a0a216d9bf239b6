// Ages in the place of motion extents: what new material of an animation looks like.

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include "fluidymation/core/random.h"
#include "fluidymation/guides/material_age.h"
#include "fluidymation/synthesis/patch_distance.h"
#include "fluidymation/synthesis/shift.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr float kBorderWidthPx = 3.0F;
constexpr int kFilmFrames = 16;
const Size kFilmSize{64, 56};
const Size kLineSize{96, 32};

/// What the film looks like at a time: its lightness says it, with some grain.
Lab filmColor(int x, int y, int frame) {
  Random random({5, 0, 0, 0, x / 2, y / 2});
  const auto grain = static_cast<float>(random.uniform(0, 100)) / 100.0F;
  return {30.0F + 3.0F * static_cast<float>(frame) + 6.0F * grain, 10.0F, -20.0F};
}

/// A drop that spreads and lightens evenly as it dries.
Exemplar film(bool withAges, int frameCount = kFilmFrames) {
  std::vector<Mask> masks;
  for (int k = 0; k < frameCount; ++k) {
    masks.push_back(test::disc(kFilmSize, {32.0F, 28.0F}, 10.0F + static_cast<float>(k)));
  }
  std::vector<GuideFrame> guides = test::guidesOf(masks, 2.0F);
  Exemplar exemplar(kFilmSize, frameCount, coarsestLevel(kFilmSize, kLineSize), kBorderWidthPx);
  FilmAges ages;
  for (int k = 0; k < frameCount; ++k) {
    Image<Lab> picture(kFilmSize);
    for (int y = 0; y < kFilmSize.height; ++y) {
      for (int x = 0; x < kFilmSize.width; ++x) picture(x, y) = filmColor(x, y, k);
    }
    exemplar.setColor(k, picture);
    GuideFrame& frame = guides[static_cast<std::size_t>(k)];
    if (withAges) frame.age = ages.next(frame.mask);
    exemplar.setGuides(k, frame);
  }
  exemplar.finish(ExtentUnit::kExemplar);
  return exemplar;
}

/// A line drawn from left to right, 12 px wide; it rests from frame `holdBegin` to `holdEnd`.
std::vector<GuideFrame> drawnLine(bool withAges, int frameCount, int holdBegin = 1000,
                                  int holdEnd = 1000) {
  std::vector<Mask> masks;
  for (int j = 0; j < frameCount; ++j) {
    const int drawn = j < holdBegin ? j : j < holdEnd ? holdBegin - 1 : j - (holdEnd - holdBegin);
    masks.push_back(test::maskOf(kLineSize, [&](int x, int y) {
      return x >= 6 && x < 18 + 4 * drawn && y >= 10 && y < 22;
    }));
  }
  std::vector<GuideFrame> guides = test::guidesOf(masks, 2.0F);
  TargetAges ages;
  for (GuideFrame& frame : guides) {
    if (!withAges) break;
    frame.age = ages.next(frame.mask);
    frame.ageGrows = ages.haveGrown();
  }
  return guides;
}

std::vector<Image<Lab>> paint(const Exemplar& exemplar, const std::vector<GuideFrame>& line,
                              const SynthesisOptions& options = {}) {
  Synthesizer synthesizer(exemplar, options);
  std::vector<Image<Lab>> pictures;
  for (const GuideFrame& frame : line) pictures.push_back(synthesizer.paint(frame));
  return pictures;
}

/// Mean lightness along the line's middle, from x = `from` to `to`.
double lightness(const Image<Lab>& picture, int from, int to) {
  double sum = 0.0;
  for (int y = 14; y < 18; ++y) {
    for (int x = from; x < to; ++x) sum += static_cast<double>(picture(x, y).l);
  }
  return sum / (4.0 * (to - from));
}

/// Correlation of painted lightness with the time since a pixel was covered.
double correlation(const Image<Lab>& picture, const GuideFrame& aged) {
  double n = 0.0;
  double a = 0.0;
  double l = 0.0;
  double aa = 0.0;
  double ll = 0.0;
  double al = 0.0;
  for (std::size_t i = 0; i < aged.mask.pixelCount(); ++i) {
    if (aged.mask.data()[i] == 0) continue;
    const auto age = static_cast<double>(aged.age.data()[i]);
    const auto light = static_cast<double>(picture.data()[i].l);
    n += 1.0;
    a += age;
    l += light;
    aa += age * age;
    ll += light * light;
    al += age * light;
  }
  return (n * al - a * l) / std::sqrt((n * aa - a * a) * (n * ll - l * l));
}

TEST(NewMaterial, IsFreshAtTheBrushAndOlderBehindIt) {
  constexpr int kFrames = 16;
  const std::vector<GuideFrame> line = drawnLine(true, kFrames);
  const Image<Lab> fresh = std::move(paint(film(true), line).back());
  const Image<Lab> plain = std::move(paint(film(false), drawnLine(false, kFrames)).back());
  // From the brush backwards, six frames a step
  EXPECT_GT(lightness(fresh, 30, 54), lightness(fresh, 54, 78) + 4.0);
  EXPECT_GT(lightness(fresh, 6, 30), lightness(fresh, 30, 54) + 2.0);
  EXPECT_GT(lightness(fresh, 6, 18), lightness(fresh, 66, 78) + 18.0) << "of 40 that the film has";
  EXPECT_GT(correlation(fresh, line.back()), 0.85);
  EXPECT_LT(correlation(plain, line.back()), 0.5);
}

TEST(NewMaterial, IsSearchedWithTheWideVotesOfTheThesis) {
  const std::vector<GuideFrame> line = drawnLine(true, 6);
  const auto last = [&](float optVoteSigmaPx, const std::vector<GuideFrame>& guides, bool aged) {
    SynthesisOptions options;
    options.optVoteSigmaPx = optVoteSigmaPx;
    return std::move(paint(film(aged), guides, options).back());
  };
  const auto areEqual = [](const Image<Lab>& a, const Image<Lab>& b) {
    return std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Lab)) == 0;
  };
  EXPECT_TRUE(areEqual(last(0.5F, line, true), last(0.0F, line, true)));
  const std::vector<GuideFrame> plain = drawnLine(false, 6);
  EXPECT_FALSE(areEqual(last(0.5F, plain, false), last(0.0F, plain, false)));
}

TEST(NewMaterial, StaysAsItIsInAHold) {
  const std::vector<GuideFrame> line = drawnLine(true, 18, 9, 17);
  const std::vector<Image<Lab>> pictures = paint(film(true), line);
  const auto difference = [&](std::size_t a, std::size_t b) {
    double sum = 0.0;
    for (int y = 10; y < 22; ++y) {
      for (int x = 6; x < 50; ++x) {
        sum += std::abs(static_cast<double>(pictures[a](x, y).l - pictures[b](x, y).l));
      }
    }
    return sum / (12.0 * 44.0);
  };
  EXPECT_LT(difference(10, 15), 1.5) << "five frames of a hold";
  EXPECT_GT(difference(16, 17), 1.5) << "the film goes on by 3";
}

TEST(NewMaterial, IsTheSameForAnyNumberOfThreads) {
  const Exemplar exemplar = film(true);
  const std::vector<GuideFrame> line = drawnLine(true, 4);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const std::vector<Image<Lab>> one = paint(exemplar, line);
  omp_set_num_threads(3);
  const std::vector<Image<Lab>> three = paint(exemplar, line);
  omp_set_num_threads(before);
  for (std::size_t j = 0; j < one.size(); ++j) {
    EXPECT_EQ(std::memcmp(one[j].data(), three[j].data(), one[j].pixelCount() * sizeof(Lab)), 0);
  }
}

TEST(NewMaterial, IsPaintedFromAFilmOfOneFrameAndOnEmptyFrames) {
  const Exemplar exemplar = film(true, 1);
  std::vector<GuideFrame> line = drawnLine(true, 3);
  std::vector<Mask> empty;
  empty.emplace_back(kLineSize);
  line[1] = std::move(test::guidesOf(empty, 2.0F).front());
  line[1].age = Image<float>(kLineSize);
  const std::vector<Image<Lab>> pictures = paint(exemplar, line);
  for (const std::size_t j : {0U, 2U}) EXPECT_NEAR(lightness(pictures[j], 6, 18), 33.0, 3.0) << j;
}

/// Shifts a match in the middle of the film, with a target that flows to the right.
int shiftedFrame(const Exemplar& exemplar, int frame, bool ageGrows, Vec2 place) {
  std::vector<GuideFrame> line = drawnLine(true, 2);
  line[1].ageGrows = ageGrows;
  NearestNeighborField previous(kLineSize);
  previous(10, 15) = Match{place.x, place.y, frame, Rotation{}};
  Image<float> owed;
  return shift(exemplar, line[1], previous, &owed)(10, 15).frame;
}

TEST(NewMaterial, MovesThroughTheFilmByOneFrameWhereverItAges) {
  const Exemplar exemplar = film(true);
  const Vec2 middle{32.0F, 28.0F};
  EXPECT_EQ(shiftedFrame(exemplar, 4, true, middle), 5);
  EXPECT_EQ(shiftedFrame(exemplar, 4, false, middle), 4) << "a hold";
  EXPECT_EQ(shiftedFrame(exemplar, kFilmFrames - 1, true, middle), kFilmFrames - 1);
  EXPECT_EQ(shiftedFrame(exemplar, 4, true, {0.0F, 0.0F}), 4) << "outside the film's mask";
}

TEST(NewMaterial, ComparesAgesAsSharesOfTheFilmsAndNotTheDirections) {
  const ExtentScale scale = ExtentScale::ofAges(8.0F);
  EXPECT_EQ(scale(0.0F), 0.0F);
  EXPECT_EQ(scale(4.0F), kLargestAge / 2.0F);
  EXPECT_EQ(scale(8.0F), kLargestAge);
  EXPECT_EQ(scale(80.0F), kLargestAge);
  EXPECT_EQ(ExtentScale::ofAges(0.0F)(3.0F), 0.0F);

  const Exemplar exemplar = film(true);
  const std::vector<GuideFrame> line = drawnLine(true, 8);
  const TargetLevel target(finestLevel(line[7]), kBorderWidthPx, exemplar.extentScale());
  const PatchDistance distance(exemplar.level(0), target, {0.0F, 0.0F, 1.0F, 0.0F});
  TargetWindow window;
  distance.gather(10, 15, window);
  const Vec2 flow = exemplar.level(0).direction(32, 28, 7);
  const Rotation along = Rotation::between(flow, line[7].direction(10, 15));
  const auto cost = [&](int frame, const Rotation& rotation) {
    return distance(window, Match{32.0F, 28.0F, frame, rotation}, 1e9F);
  };
  EXPECT_EQ(cost(7, along), 0.0F);
  EXPECT_EQ(cost(7, along.opposite()), 0.0F);
  // Three frames older; both ages are rounded by half a step at most
  const float older = 3.0F * kLargestAge / static_cast<float>(kFilmFrames - 1);
  const float error = 1.0F / exemplar.extentScale().stepsPerUnit();
  const float tolerance = (2.0F * older + error) * error;
  EXPECT_NEAR(cost(4, along), older * older, tolerance);
  EXPECT_NEAR(cost(4, along.opposite()), older * older, tolerance);
}

}  // namespace
}  // namespace fluidymation
