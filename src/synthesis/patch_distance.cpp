#include "fluidymation/synthesis/patch_distance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "synthesis/patch_kernels.h"
#include "synthesis/sample_order.h"

namespace fluidymation {
namespace {

/// |tan| of the angle between two directions of any length; 0 where one has none.
float misalignment(Vec2 a, Vec2 b) {
  const float sine = std::abs(a.x * b.y - a.y * b.x);
  const float cosine = std::abs(dot(a, b));
  if (sine < kLargestMisalignment * cosine) return sine / cosine;
  return sine > 0.0F ? kLargestMisalignment : 0.0F;
}

/// The exemplar's direction between pixels: bilinear, the edge repeats. Not a unit vector.
Vec2 directionAt(const ExemplarLevel& exemplar, int frame, float x, float y) {
  const float cx = std::clamp(x, 0.0F, static_cast<float>(exemplar.size().width - 1));
  const float cy = std::clamp(y, 0.0F, static_cast<float>(exemplar.size().height - 1));
  const int x0 = static_cast<int>(cx);
  const int y0 = static_cast<int>(cy);
  const int x1 = std::min(x0 + 1, exemplar.size().width - 1);
  const int y1 = std::min(y0 + 1, exemplar.size().height - 1);
  const float fx = cx - static_cast<float>(x0);
  const float fy = cy - static_cast<float>(y0);
  return (1.0F - fy) * ((1.0F - fx) * exemplar.direction(x0, y0, frame) +
                        fx * exemplar.direction(x1, y0, frame)) +
         fy * ((1.0F - fx) * exemplar.direction(x0, y1, frame) +
               fx * exemplar.direction(x1, y1, frame));
}

/// A weight of squared values, of squared steps.
float perStep(float weight, float stepsPerUnit) { return weight / (stepsPerUnit * stepsPerUnit); }

}  // namespace

PatchDistance::PatchDistance(const ExemplarLevel& exemplar, const TargetLevel& target,
                             const DistanceWeights& weights)
    : exemplar_(exemplar), target_(target), kernels_(exemplar.kernels()), weights_(weights) {
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    offsets_[i] = sampleOffsetY(i) * target.size().width + sampleOffsetX(i);
  }
}

void PatchDistance::gather(int x, int y, TargetWindow& window) const {
  const Size size = target_.size();
  constexpr auto kColors = static_cast<float>(kColorChannels);
  constexpr auto kArea = static_cast<float>(kPatchArea);
  const WindowWeights weights{
      perStep(weights_.color / kColors, kColorSteps),
      perStep(target_.modulation(x, y) * weights_.prev / kColors, kColorSteps),
      perStep(weights_.dist / kArea, kEdgeSteps),
      perStep(weights_.flow / kArea, exemplar_.extentSteps())};
  window.direction = target_.direction(x, y);
  if (x >= kPatchRadius && y >= kPatchRadius && x < size.width - kPatchRadius &&
      y < size.height - kPatchRadius) {
    kernels_.gather(
        {&target_.picture(x, y), &target_.previous(x, y), &target_.guides(x, y), offsets_.data()},
        weights, window);
  } else {
    gatherAtEdge(x, y, weights, window);
  }
  if (weights_.dir != 0.0F) gatherDirections(x, y, window);
}

void PatchDistance::gatherAtEdge(int x, int y, const WindowWeights& weights,
                                 TargetWindow& window) const {
  // A copy in which the edge repeats, and what lies beyond has no colour.
  std::array<FixedLab, TargetWindow::kSamples> picture;
  std::array<FixedLab, TargetWindow::kSamples> previous;
  std::array<FixedGuides, TargetWindow::kSamples> guides;
  std::array<std::int32_t, TargetWindow::kSamples> offsets{};
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    const int qx = x + sampleOffsetX(i);
    const int qy = y + sampleOffsetY(i);
    offsets[i] = static_cast<std::int32_t>(i);
    guides[i] = target_.guides.clamped(qx, qy);
    if (!target_.segment.contains(qx, qy)) continue;
    picture[i] = target_.picture(qx, qy);
    previous[i] = target_.previous(qx, qy);
  }
  kernels_.gather({picture.data(), previous.data(), guides.data(), offsets.data()}, weights,
                  window);
}

void PatchDistance::gatherDirections(int x, int y, TargetWindow& window) const {
  int inside = 0;
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    const int qx = x + sampleOffsetX(i);
    const int qy = y + sampleOffsetY(i);
    const bool counts = target_.segment.contains(qx, qy) && target_.inside(qx, qy);
    window.directions[i] = target_.direction.clamped(qx, qy);
    window.directionWeight[i] = counts ? weights_.dir : 0.0F;
    inside += counts ? 1 : 0;
  }
  assert(inside > 0);
  for (float& weight : window.directionWeight) weight /= static_cast<float>(inside);
}

float PatchDistance::operator()(const TargetWindow& window, const Match& match, float stopAt,
                                int* samples) const {
  const Vec2 sourceDirection = exemplar_.direction(match.nearestX(), match.nearestY(), match.frame);
  const bool opposite =
      !exemplar_.comparesAges() && isOpposite(window.direction, sourceDirection, match.rotation);
  int compared = 0;
  float distance = kernels_.distance(window, opposite ? window.swapped.data() : window.value.data(),
                                     sourceWindow(exemplar_, match), stopAt, compared);
  if (weights_.dir != 0.0F && distance < stopAt) distance += directionTerm(window, match);
  if (samples != nullptr) *samples = compared;
  return distance;
}

std::array<float, 2> PatchDistance::ofBothWays(const TargetWindow& window, const Match& aligned,
                                               float stopAt, int& samples) const {
  std::array<float, 2> distances =
      kernels_.bothDistances(window, window.value.data(),
                             exemplar_.comparesAges() ? window.value.data() : window.swapped.data(),
                             sourceWindow(exemplar_, aligned), stopAt, samples);
  if (weights_.dir != 0.0F) {
    if (distances[0] < stopAt) distances[0] += directionTerm(window, aligned);
    if (distances[1] < stopAt) {
      Match opposite = aligned;
      opposite.rotation = aligned.rotation.opposite();
      distances[1] += directionTerm(window, opposite);
    }
  }
  return distances;
}

float PatchDistance::directionTerm(const TargetWindow& window, const Match& match) const {
  const Rotation toSource = match.rotation.inverse();
  float sum = 0.0F;
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    if (window.directionWeight[i] == 0.0F) continue;
    const Vec2 away = toSource.apply({kSampleOffsets.x[i], kSampleOffsets.y[i]});
    const Vec2 there = directionAt(exemplar_, match.frame, match.x + away.x, match.y + away.y);
    sum +=
        window.directionWeight[i] * misalignment(match.rotation.apply(there), window.directions[i]);
  }
  return sum;
}

}  // namespace fluidymation
