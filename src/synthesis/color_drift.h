#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fluidymation/core/color.h"

namespace fluidymation {

/// Nine values of the edge guide, from the edge to as deep as it tells: an eighth of the border
/// width apart, unless the guide is the blurred mask. All that lies deeper is as the last one, and
/// all that lies outside as the first.
inline constexpr std::size_t kDriftDistances = 9;

/// What colours are off those wanted, summed at each distance to the edge. The sums are of
/// integers, so that it does not matter in which order pixels are added, or by how many threads.
class DriftSums {
 public:
  /// @param edge  FixedGuides::edge of the pixel, any value.
  /// @param difference  of its colour from the one wanted; CIELAB, within +-1000.
  /// @param speedPx  what the target moves there in this frame, >= 0, by which the pixel counts:
  ///   colours drift where edges sweep on, and what hardly moves would hide it.
  void add(int edge, const Lab& difference, float speedPx);
  void add(const DriftSums& other);

  /// The mean difference at a distance, times n / (n + 25) with n the effective number of pixels,
  /// (sum of weights)^2 / sum of their squares: what few pixels are off on average may be the
  /// texture that they show.
  [[nodiscard]] Lab mean(std::size_t distance) const;

 private:
  struct Sum {
    std::int64_t l = 0;
    std::int64_t a = 0;
    std::int64_t b = 0;
    std::int64_t weight = 0;
    std::int64_t squares = 0;  ///< of weights

    void add(std::int64_t ofL, std::int64_t ofA, std::int64_t ofB, std::int64_t by);
  };

  std::array<Sum, kDriftDistances> sums_;
};

/// How far colours have drifted from those wanted, all together, by their distance to the edge.
class ColorDrift {
 public:
  explicit ColorDrift(const DriftSums& sums);

  /// The mean difference there; between two distances it changes linearly.
  /// @param edge  FixedGuides::edge, any value.
  [[nodiscard]] Lab at(int edge) const;

 private:
  std::array<Lab, kDriftDistances> means_;
};

}  // namespace fluidymation
