#pragma once

#include <cstddef>

#include "fluidymation/core/image.h"
#include "fluidymation/guides/material_age.h"
#include "fluidymation/guides/packed_mask.h"

namespace fluidymation {

// What tells lines being drawn from all other animations; docs/decisions.md has figures.

/// Uncovered pixels for each newly covered one, at most: material stays.
inline constexpr double kLargestRecession = 0.05;
/// Newly covered pixels for each one of the last frame, more than: most is drawn, not given.
inline constexpr double kSmallestGrowth = 0.5;
/// Age from which on what has arrived has to lie still, frames: past the reach of the standard
/// smoothing of movement in time, 6 frames.
inline constexpr float kSettledAgeFrames = 8.0F;
/// Its mean movement as a share of that of newly covered pixels, at most.
inline constexpr double kLargestRestlessness = 0.1;

/// Watches the masks of an animation, one frame after the other, for the first half of what lines
/// being drawn are: material that only ever is added.
class Growth {
 public:
  void add(const PackedMask& mask);

  /// Whether next to nothing is uncovered and most of the last mask has been added. False without a
  /// second frame.
  [[nodiscard]] bool isDrawing() const;

 private:
  PackedMask mask_;  ///< of the last frame
  bool first_ = true;
  std::size_t covered_ = 0;    ///< pixels, over all frames but the first
  std::size_t uncovered_ = 0;  ///< likewise
};

/// Watches an animation, one frame after the other, for the second half, which takes more time:
/// what has been added lies still.
class DrawnLines {
 public:
  /// @param mask  of the next frame.
  /// @param flow  of the same, px per frame; zero outside.
  void add(const Mask& mask, const Image<Vec2>& flow);

  /// False where nothing has lain long enough to tell.
  [[nodiscard]] bool found() const;

 private:
  /// A mean movement.
  struct Movement {
    double sumPx = 0.0;
    std::size_t pixels = 0;
    [[nodiscard]] double meanPx() const { return sumPx / static_cast<double>(pixels); }
  };

  Mask mask_;  ///< of the last frame
  TargetAges ages_;
  Movement fresh_;    ///< of newly covered pixels
  Movement settled_;  ///< of those of kSettledAgeFrames and more, holds left out
};

}  // namespace fluidymation
