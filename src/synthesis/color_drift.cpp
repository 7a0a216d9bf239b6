#include "synthesis/color_drift.h"

#include <algorithm>

#include "fluidymation/core/geometry.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation {
namespace {

/// Steps of a pixel's weight, in a pixel of movement.
constexpr float kWeightSteps = 64.0F;
/// What moves further counts as this. 2^28 pixels of weight 2^12 whose colours are off by 2^17
/// steps sum up to 2^57.
constexpr float kMostPx = 64.0F;
/// As many pixels as a window has, whose colours come from one piece of the film.
constexpr float kDoubtedPixels = 25.0F;

/// Between which two distances a pixel lies.
struct Between {
  std::size_t outer = 0;
  float inwards = 0.0F;  ///< how far on from there to the next, [0, 1]
};

Between betweenOf(int edge) {
  constexpr auto kDeepest = static_cast<float>(kDriftDistances - 1);
  constexpr float kStep = kEdgeScale * kEdgeSteps / kDeepest;
  const float at = std::clamp(static_cast<float>(edge) / kStep, 0.0F, kDeepest);
  const std::size_t outer = std::min(static_cast<std::size_t>(at), kDriftDistances - 2);
  return {outer, at - static_cast<float>(outer)};
}

}  // namespace

void DriftSums::Sum::add(std::int64_t ofL, std::int64_t ofA, std::int64_t ofB, std::int64_t by) {
  l += by * ofL;
  a += by * ofA;
  b += by * ofB;
  weight += by;
  squares += by * by;
}

void DriftSums::add(int edge, const Lab& difference, float speedPx) {
  const Between place = betweenOf(edge);
  const int all = floorToInt(kWeightSteps * std::min(speedPx, kMostPx) + 0.5F);
  const int inner = floorToInt(static_cast<float>(all) * place.inwards + 0.5F);
  const int l = floorToInt(kColorSteps * difference.l + 0.5F);
  const int a = floorToInt(kColorSteps * difference.a + 0.5F);
  const int b = floorToInt(kColorSteps * difference.b + 0.5F);
  sums_[place.outer].add(l, a, b, all - inner);
  sums_[place.outer + 1].add(l, a, b, inner);
}

void DriftSums::add(const DriftSums& other) {
  for (std::size_t d = 0; d < kDriftDistances; ++d) {
    sums_[d].l += other.sums_[d].l;
    sums_[d].a += other.sums_[d].a;
    sums_[d].b += other.sums_[d].b;
    sums_[d].weight += other.sums_[d].weight;
    sums_[d].squares += other.sums_[d].squares;
  }
}

Lab DriftSums::mean(std::size_t distance) const {
  const Sum& sum = sums_[distance];
  if (sum.weight == 0) return {};
  const auto weight = static_cast<float>(sum.weight);
  const float pixels = weight * (weight / static_cast<float>(sum.squares));
  const float scale = pixels / ((pixels + kDoubtedPixels) * kColorSteps * weight);
  return {scale * static_cast<float>(sum.l), scale * static_cast<float>(sum.a),
          scale * static_cast<float>(sum.b)};
}

ColorDrift::ColorDrift(const DriftSums& sums) {
  for (std::size_t d = 0; d < kDriftDistances; ++d) means_[d] = sums.mean(d);
}

Lab ColorDrift::at(int edge) const {
  const Between place = betweenOf(edge);
  const Lab& outer = means_[place.outer];
  const Lab& inner = means_[place.outer + 1];
  const auto between = [&](float from, float to) { return from + place.inwards * (to - from); };
  return {between(outer.l, inner.l), between(outer.a, inner.a), between(outer.b, inner.b)};
}

}  // namespace fluidymation
