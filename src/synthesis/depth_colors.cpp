#include "fluidymation/synthesis/depth_colors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/channels.h"

namespace fluidymation {
namespace {

/// Between distances that are told apart, px, unless the border is so wide that there would be more
/// than kMostDistances.
constexpr float kStepPx = 0.5F;
constexpr float kMostDistances = 64.0F;
/// Frames on either side that are averaged with one: rims of single frames are short, and their
/// means restless.
constexpr int kFramesAround = 2;
/// Weight of the whole exemplar's mean where it is averaged with the pixels of a frame and its
/// neighbours, of which one at the distance itself weighs 2 and one beside it 1.
constexpr double kWeightOfAll = 20.0;

/// Exact sums of fixed-point colours.
struct ColorSum {
  std::int64_t l = 0;
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t count = 0;

  void add(const FixedLab& color) {
    l += color.l;
    a += color.a;
    b += color.b;
    ++count;
  }
  void add(const ColorSum& other, std::int64_t weight) {
    l += weight * other.l;
    a += weight * other.a;
    b += weight * other.b;
    count += weight * other.count;
  }
};

/// The mean of `near` and, by its weight, of `all`, which has one.
Lab meanOf(const ColorSum& near, const ColorSum& all) {
  const double ofAll = kWeightOfAll / static_cast<double>(all.count);
  const double scale =
      1.0 / ((static_cast<double>(near.count) + kWeightOfAll) * static_cast<double>(kColorSteps));
  const auto mean = [&](std::int64_t n, std::int64_t a) {
    return static_cast<float>((static_cast<double>(n) + ofAll * static_cast<double>(a)) * scale);
  };
  return {mean(near.l, all.l), mean(near.a, all.a), mean(near.b, all.b)};
}

/// Where the exemplar has no pixel of a distance, what the next deeper one has that has any, else
/// the next less deep one.
void fillGaps(std::vector<ColorSum>& all) {
  for (std::size_t d = all.size() - 1; d-- > 0;) {
    if (all[d].count == 0) all[d] = all[d + 1];
  }
  for (std::size_t d = 1; d < all.size(); ++d) {
    if (all[d].count == 0) all[d] = all[d - 1];
  }
}

/// The sums of every frame's pixels inside the mask at each of `distances` distances, one frame
/// after the other.
/// @param step  of the edge guide, from one distance to the next.
std::vector<ColorSum> sumsOf(const ExemplarLevel& exemplar, std::size_t distances, float step) {
  std::vector<ColorSum> sums(distances * static_cast<std::size_t>(exemplar.frameCount()));
  const float perStep = 1.0F / step;
  const auto deepest = static_cast<float>(distances - 1);
  parallelFor(exemplar.frameCount(), 1, [&](int k) {
    ColorSum* const ofFrame = &sums[static_cast<std::size_t>(k) * distances];
    for (int y = 0; y < exemplar.size().height; ++y) {
      for (int x = 0; x < exemplar.size().width; ++x) {
        if (exemplar.segment(x, y, k) == Segment::kOutside) continue;
        const Texel& texel = exemplar.texel(x, y, k);
        const float at = static_cast<float>(texel.guides.edge) * perStep;
        const int nearest = floorToInt(std::clamp(at, 0.0F, deepest) + 0.5F);
        ofFrame[static_cast<std::size_t>(nearest)].add(texel.color);
      }
    }
  });
  return sums;
}

/// The sums of a frame at one distance, of the frames round it and of the distances beside it.
/// @param sums  of each distance, one frame after the other.
ColorSum sumAround(const std::vector<ColorSum>& sums, int frames, int distances, int k, int d) {
  const auto at = [&](int frame, int distance) -> const ColorSum& {
    return sums[static_cast<std::size_t>(frame) * static_cast<std::size_t>(distances) +
                static_cast<std::size_t>(distance)];
  };
  // The last distance is the whole interior, and would outweigh the rim beside it
  const int interior = distances - 1;
  ColorSum around;
  for (int f = std::max(k - kFramesAround, 0); f <= std::min(k + kFramesAround, frames - 1); ++f) {
    around.add(at(f, d), 2);
    if (d == interior) continue;
    if (d > 0) around.add(at(f, d - 1), 1);
    if (d + 1 < interior) around.add(at(f, d + 1), 1);
  }
  return around;
}

}  // namespace

DepthColors::DepthColors(const ExemplarLevel& exemplar) {
  const float deepest = kEdgeScale * kEdgeSteps;
  const float count =
      std::clamp(std::ceil(exemplar.borderWidthPx() / kStepPx) + 1.0F, 2.0F, kMostDistances);
  step_ = deepest / (count - 1.0F);
  distances_ = static_cast<std::size_t>(count);

  const int frames = exemplar.frameCount();
  const std::vector<ColorSum> sums = sumsOf(exemplar, distances_, step_);
  std::vector<ColorSum> all(distances_);
  for (std::size_t i = 0; i < sums.size(); ++i) all[i % distances_].add(sums[i], 1);
  fillGaps(all);
  if (all.front().count == 0) all.assign(distances_, ColorSum{0, 0, 0, 1});  // there is no medium
  colors_.reserve(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const auto k = static_cast<int>(i / distances_);
    const auto d = static_cast<int>(i % distances_);
    colors_.push_back(
        meanOf(sumAround(sums, frames, static_cast<int>(distances_), k, d), all[i % distances_]));
  }
}

Lab DepthColors::mean(int k, int edge) const {
  const float at =
      std::clamp(static_cast<float>(edge) / step_, 0.0F, static_cast<float>(distances_ - 1));
  const std::size_t before = std::min(static_cast<std::size_t>(at), distances_ - 2);
  const float share = at - static_cast<float>(before);
  const Lab* const outer = &colors_[static_cast<std::size_t>(k) * distances_ + before];
  const Lab& inner = outer[1];
  return {outer->l + share * (inner.l - outer->l), outer->a + share * (inner.a - outer->a),
          outer->b + share * (inner.b - outer->b)};
}

Lab DepthColors::change(int k, int from, int to) const {
  if (from == to) return {};
  const Lab there = mean(k, to);
  const Lab here = mean(k, from);
  return {there.l - here.l, there.a - here.a, there.b - here.b};
}

}  // namespace fluidymation
