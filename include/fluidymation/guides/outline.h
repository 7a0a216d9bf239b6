#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fluidymation/core/image.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// Smoothing of coverage begins here, px; a narrower Gaussian leaves a pixel's neighbours out.
inline constexpr float kLeastCoverageSigmaPx = 0.5F;

/// Where an outline crosses the lines between the centres of neighbouring pixels: the share of the
/// way from a pixel to its right, or lower, neighbour, in (0, 1); 0 where the two are of one side.
struct Crossings {
  Image<float> right;
  Image<float> down;
};

/// The outline of a shape as the polygon that marching squares draw (Lorensen and Cline 1987): its
/// corners lie where the isoline of the coverage crosses the lines between pixel centres. Kept
/// without the mask, which tells where these crossings are: 16 bits for each, in row order.
class Outline {
 public:
  Outline() = default;
  /// @param shares  of all crossings in row order, in steps of 2^-16.
  explicit Outline(std::vector<std::uint16_t> shares) : shares_(std::move(shares)) {}

  /// Each in the middle of its step.
  /// @param mask  the one the outline was made with.
  [[nodiscard]] Crossings crossings(const Mask& mask) const;

  [[nodiscard]] const std::vector<std::uint16_t>& shares() const { return shares_; }
  [[nodiscard]] std::size_t crossingCount() const { return shares_.size(); }

  friend bool operator==(const Outline& a, const Outline& b) { return a.shares_ == b.shares_; }

 private:
  std::vector<std::uint16_t> shares_;
};

/// Pairs of neighbouring pixels on two sides.
[[nodiscard]] std::size_t countCrossings(const Mask& mask);

/// A mask and the sub-pixel outline between its two sides.
struct OutlinedMask {
  Mask mask;
  Outline outline;
};

/// What `smoothMask` does for anti-aliased masks (thesis §4.1): (Gaussian * coverage) >= threshold,
/// and the isoline at the threshold as outline. Narrower than `kLeastCoverageSigmaPx` there is no
/// smoothing, and the threshold is one half. On straight edges at any angle the outline is right to
/// 0.03 px, unsmoothed to 0.005 px (0.08 px where a sigma below 1 px meets a threshold below one
/// half, two thirds of it alike for all edges):
/// - Smoothed, a step has the profile of a Gaussian's integral, whose inverse is linear across the
///   edge.
/// - Unsmoothed, it is a box-filtered step. The sum of the coverage across the edge is its place,
///   however the single pixels are cut (the height functions of volume-of-fluid methods).
[[nodiscard]] OutlinedMask outlinedMask(const Image<float>& coverage, const MaskOptions& options);

}  // namespace fluidymation
