#include "footage/camera_tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "fluidymation/core/index.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

constexpr int kBlockPx = 32;
constexpr int kMostBlocks = 48;
constexpr int kLeastBlocks = 3;
constexpr double kLeastSlope = 0.15;  // of lightness a pixel, in the mean, along x and y alike
constexpr double kLeastCorrelation = 0.7;
constexpr float kAgreementPx = 0.75F;

[[nodiscard]] Image<float> smoothedLightness(const Image<Lab>& picture) {
  Image<float> lightness(picture.size());
  std::transform(picture.begin(), picture.end(), lightness.begin(),
                 [](const Lab& color) { return color.l; });
  constexpr float kGrainSigmaPx = 1.0F;
  return gaussianBlur(lightness, kGrainSigmaPx);
}

/// The smaller one of the mean squared slopes across any two directions at right angles: the lesser
/// eigenvalue of the structure tensor (Shi and Tomasi 1994).
[[nodiscard]] double structureOf(const Image<float>& picture, Pixel block) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (int y = block.y; y < block.y + kBlockPx; ++y) {
    for (int x = block.x; x < block.x + kBlockPx; ++x) {
      const double alongX = 0.5 * (picture.clamped(x + 1, y) - picture.clamped(x - 1, y));
      const double alongY = 0.5 * (picture.clamped(x, y + 1) - picture.clamped(x, y - 1));
      xx += alongX * alongX;
      xy += alongX * alongY;
      yy += alongY * alongY;
    }
  }
  const double pixels = kBlockPx * kBlockPx;
  return (0.5 * (xx + yy) - std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy)) / pixels;
}

/// Normalized cross-correlation of a block with the frame at another place, in [-1, 1].
[[nodiscard]] double correlation(const Image<float>& bare, Pixel block, const Image<float>& frame,
                                 Pixel place) {
  double sumA = 0.0;
  double sumB = 0.0;
  double sumAA = 0.0;
  double sumAB = 0.0;
  double sumBB = 0.0;
  for (int y = 0; y < kBlockPx; ++y) {
    const float* const rowA = bare.row(block.y + y) + block.x;
    const float* const rowB = frame.row(place.y + y) + place.x;
    for (int x = 0; x < kBlockPx; ++x) {
      const double a = rowA[x];
      const double b = rowB[x];
      sumA += a;
      sumB += b;
      sumAA += a * a;
      sumAB += a * b;
      sumBB += b * b;
    }
  }
  constexpr double kPixels = kBlockPx * kBlockPx;
  const double spread = (sumAA - sumA * sumA / kPixels) * (sumBB - sumB * sumB / kPixels);
  return spread > 0.0 ? (sumAB - sumA * sumB / kPixels) / std::sqrt(spread) : 0.0;
}

/// Where between -1 and 1 the parabola through three values is largest, the middle one being so.
[[nodiscard]] float peakOf(double before, double middle, double after) {
  const double bend = before - 2.0 * middle + after;
  return bend < 0.0 ? static_cast<float>(0.5 * (before - after) / bend) : 0.0F;
}

/// How far one block has moved; nothing where it is not found within reach.
[[nodiscard]] std::optional<Vec2> movementOf(const Image<float>& bare, Pixel block,
                                             const Image<float>& frame) {
  constexpr int kReach = CameraTracker::kReachPx;
  constexpr int kCoarseStep = 2;  // px; the smoothed lightness correlates further than that
  const auto match = [&](int x, int y) {
    return correlation(bare, block, frame, {block.x + x, block.y + y});
  };
  Pixel best;
  double top = match(0, 0);
  const auto improve = [&](Pixel from, int reach, int step) {
    for (int y = std::max(from.y - reach, -kReach); y <= std::min(from.y + reach, kReach);
         y += step) {
      for (int x = std::max(from.x - reach, -kReach); x <= std::min(from.x + reach, kReach);
           x += step) {
        const double found = match(x, y);
        if (found <= top) continue;
        top = found;
        best = {x, y};
      }
    }
  };
  improve({0, 0}, kReach, kCoarseStep);
  improve(best, 1, 1);
  const bool atBrink = std::abs(best.x) == kReach || std::abs(best.y) == kReach;
  if (atBrink || top < kLeastCorrelation) return std::nullopt;
  return Vec2{static_cast<float>(best.x) +
                  peakOf(match(best.x - 1, best.y), top, match(best.x + 1, best.y)),
              static_cast<float>(best.y) +
                  peakOf(match(best.x, best.y - 1), top, match(best.x, best.y + 1))};
}

/// Those that lie within `kAgreementPx` of `movement`: how many, and their mean.
[[nodiscard]] std::pair<int, Vec2> agreeingWith(Vec2 movement, const std::vector<Vec2>& movements) {
  int count = 0;
  Vec2 sum;
  for (const Vec2 other : movements) {
    if (length(other - movement) > kAgreementPx) continue;
    ++count;
    sum += other;
  }
  return {count, 1.0F / static_cast<float>(std::max(count, 1)) * sum};
}

/// No movement where some blocks have stayed: a camera that moves moves all of them. Else the mean
/// of the largest set that lies within `kAgreementPx` of one of its members.
[[nodiscard]] std::optional<Vec2> agreedOn(const std::vector<Vec2>& movements) {
  std::pair<int, Vec2> largest = agreeingWith({}, movements);
  if (largest.first >= kLeastBlocks) return largest.second;
  for (const Vec2 movement : movements) {
    const std::pair<int, Vec2> agreeing = agreeingWith(movement, movements);
    if (agreeing.first > largest.first) largest = agreeing;
  }
  const bool isMost = 2 * largest.first > static_cast<int>(movements.size());
  if (largest.first < kLeastBlocks || !isMost) return std::nullopt;
  return largest.second;
}

}  // namespace

CameraTracker::CameraTracker(const Image<Lab>& bare) : bare_(smoothedLightness(bare)) {
  std::vector<std::pair<double, Pixel>> candidates;
  for (int y = kReachPx; y + kBlockPx + kReachPx <= bare_.height(); y += kBlockPx) {
    for (int x = kReachPx; x + kBlockPx + kReachPx <= bare_.width(); x += kBlockPx) {
      const double structure = structureOf(bare_, {x, y});
      if (structure >= kLeastSlope * kLeastSlope) candidates.push_back({structure, {x, y}});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::tuple{-a.first, a.second.y, a.second.x} <
           std::tuple{-b.first, b.second.y, b.second.x};
  });
  candidates.resize(std::min(candidates.size(), at(kMostBlocks)));
  for (const auto& [structure, block] : candidates) blocks_.push_back(block);
}

std::optional<Vec2> CameraTracker::offsetOf(const Image<Lab>& frame) const {
  assert(frame.size() == bare_.size());
  const Image<float> lightness = smoothedLightness(frame);
  std::vector<std::optional<Vec2>> found(blocks_.size());
  parallelFor(static_cast<int>(blocks_.size()), 1,
              [&](int i) { found[at(i)] = movementOf(bare_, blocks_[at(i)], lightness); });
  std::vector<Vec2> movements;
  for (const std::optional<Vec2>& movement : found) {
    if (movement) movements.push_back(*movement);
  }
  return agreedOn(movements);
}

}  // namespace fluidymation
