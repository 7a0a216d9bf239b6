#include "fluidymation/guides/outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/mask.h"

namespace fluidymation {
namespace {

constexpr float kShareSteps = 65536.0F;  // of a 16-bit number

std::uint16_t packed(float share) {
  return static_cast<std::uint16_t>(std::clamp(share * kShareSteps, 0.0F, kShareSteps - 1.0F));
}

/// In the middle of its step: never 0 or 1, and the same from either end.
float unpacked(std::uint16_t share) { return (static_cast<float>(share) + 0.5F) / kShareSteps; }

/// `visit(x, y, isRight)` for every pair of neighbours on two sides, in row order.
template <typename Visit>
void forEachCrossing(const Mask& mask, const Visit& visit) {
  for (int y = 0; y < mask.height(); ++y) {
    const std::uint8_t* row = mask.row(y);
    const std::uint8_t* below = y + 1 < mask.height() ? mask.row(y + 1) : row;
    for (int x = 0; x < mask.width(); ++x) {
      if (x + 1 < mask.width() && row[x] != row[x + 1]) visit(x, y, true);
      if (row[x] != below[x]) visit(x, y, false);
    }
  }
}

/// The argument at which the integral of the normal distribution is `c`: Abramowitz and Stegun
/// 1964, 26.2.23, error below 4.5e-4.
float normalQuantile(float c) {
  constexpr float kLeast = 1e-5F;  // beyond, rounding decides
  const float tail = std::max(std::min(c, 1.0F - c), kLeast);
  const float t = std::sqrt(-2.0F * std::log(tail));
  const float quantile = t - (2.515517F + t * (0.802853F + t * 0.010328F)) /
                                 (1.0F + t * (1.432788F + t * (0.189269F + t * 0.001308F)));
  return c < 0.5F ? -quantile : quantile;
}

/// Crossings of a step that a Gaussian has smoothed.
class SmoothedStep {
 public:
  SmoothedStep(const Image<float>& coverage, float threshold)
      : coverage_(coverage), level_(normalQuantile(threshold)) {}

  /// The share of the way from pixel (x, y), which is inside, to (x + dx, y + dy), which is not.
  [[nodiscard]] float operator()(int x, int y, int dx, int dy) const {
    const float inside = normalQuantile(coverage_(x, y)) - level_;
    const float outside = normalQuantile(coverage_(x + dx, y + dy)) - level_;
    return inside > outside ? inside / (inside - outside) : 0.5F;
  }

 private:
  const Image<float>& coverage_;
  float level_;
};

/// Crossings of a box-filtered step at one half.
class BoxFilteredStep {
 public:
  explicit BoxFilteredStep(const Image<float>& coverage) : coverage_(coverage) {}

  /// Likewise.
  [[nodiscard]] float operator()(int x, int y, int dx, int dy) const {
    // An edge that runs along the way rather than across it: its height over the two pixels
    const float insideHeight = height(x, y, dx, dy);
    const float outsideHeight = height(x + dx, y + dy, dx, dy);
    const float slope = insideHeight - outsideHeight;
    if (insideHeight >= 0.0F && outsideHeight < 0.0F && slope < 1.0F) return insideHeight / slope;

    const float inside = coverage_(x, y);
    const float outside = coverage_(x + dx, y + dy);
    // One that runs across it cuts these two pixels only, and they are filled up to it
    constexpr float kUncut = 0.1F;
    if (coverage_.clamped(x - dx, y - dy) > 1.0F - kUncut &&
        coverage_.clamped(x + 2 * dx, y + 2 * dy) < kUncut) {
      return std::clamp(inside + outside - 0.5F, 0.0F, 1.0F);
    }
    // Thin parts, and edges softer than a pixel
    return (inside - 0.5F) / (inside - outside);
  }

 private:
  /// By how much the three pixels across the way are filled beyond the middle of (x, y).
  [[nodiscard]] float height(int x, int y, int dx, int dy) const {
    return coverage_.clamped(x - dy, y - dx) + coverage_(x, y) + coverage_.clamped(x + dy, y + dx) -
           1.5F;
  }

  const Image<float>& coverage_;
};

template <typename Step>
std::vector<std::uint16_t> traced(const Mask& mask, const Step& step) {
  std::vector<std::uint16_t> shares;
  forEachCrossing(mask, [&](int x, int y, bool isRight) {
    const int dx = isRight ? 1 : 0;
    const int dy = 1 - dx;
    const float share =
        mask(x, y) != 0 ? step(x, y, dx, dy) : 1.0F - step(x + dx, y + dy, -dx, -dy);
    shares.push_back(packed(share));
  });
  shares.shrink_to_fit();  // it may wait for a long time
  return shares;
}

}  // namespace

Crossings Outline::crossings(const Mask& mask) const {
  Crossings crossings{Image<float>(mask.size()), Image<float>(mask.size())};
  auto share = shares_.begin();
  forEachCrossing(mask, [&](int x, int y, bool isRight) {
    (isRight ? crossings.right : crossings.down)(x, y) = unpacked(*share++);
  });
  assert(share == shares_.end());
  return crossings;
}

std::size_t countCrossings(const Mask& mask) {
  std::size_t count = 0;
  forEachCrossing(mask, [&count](int, int, bool) { ++count; });
  return count;
}

OutlinedMask outlinedMask(const Image<float>& coverage, const MaskOptions& options) {
  const bool smooths = options.blurSigmaPx >= kLeastCoverageSigmaPx;
  const float threshold = smooths ? options.threshold : 0.5F;
  const Image<float> smooth =
      smooths ? smoothCoverage(coverage, options.blurSigmaPx) : coverage.clone();
  OutlinedMask result{Mask(smooth.size()), {}};
  std::transform(smooth.begin(), smooth.end(), result.mask.begin(), [threshold](float c) {
    return static_cast<std::uint8_t>(c >= threshold ? 1 : 0);
  });
  result.outline = Outline(smooths ? traced(result.mask, SmoothedStep(smooth, threshold))
                                   : traced(result.mask, BoxFilteredStep(smooth)));
  return result;
}

}  // namespace fluidymation
