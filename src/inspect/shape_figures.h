#pragma once

#include <cstdint>
#include <vector>

#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/synthesis/channels.h"

namespace fluidymation {

/// Parts whose largest disc is narrower than a patch: no window lies wholly within them.
inline constexpr float kThinRadiusPx = 0.5F * static_cast<float>(kPatchSize);

/// What one frame's shape and movement come to. Pixels are those of the smoothed mask, at the size
/// that the frame is scaled to, unless told otherwise.
struct ShapeFigures {
  int number = 0;             ///< the user's own
  double storedAreaPx = 0.0;  ///< before smoothing: the sum of the coverage
  std::int64_t framePx = 0;   ///< of the whole picture
  std::int64_t insidePx = 0;
  std::int64_t sharedPx = 0;    ///< inside in the frame before, too; 0 for the first
  std::int64_t interiorPx = 0;  ///< at least the border width away from the edge
  std::int64_t thinPx = 0;      ///< in parts thinner than a patch (`kThinRadiusPx`)
  std::int64_t borderPx = 0;    ///< with a neighbour outside
  std::int64_t cutPx = 0;       ///< inside and on the picture's own rim: the shape is cut there
  float depthPx = 0.0F;         ///< the largest distance to the edge; 0 where there is no edge
  double borderSpeedPx = 0.0;   ///< mean speed of the border pixels, px per frame
  [[nodiscard]] bool empty() const { return insidePx == 0; }
  [[nodiscard]] bool full() const { return insidePx == framePx; }
};

/// @param previous  mask of the frame before; null for the first frame.
/// @return  all but `number` and `storedAreaPx`.
[[nodiscard]] ShapeFigures measureShape(const GuideFrame& frame, const Mask* previous,
                                        float borderWidthPx);

/// Of a sequence, in its order.
struct SequenceFigures {
  std::vector<ShapeFigures> frames;
  bool soft = false;  ///< whether its masks are anti-aliased

  [[nodiscard]] std::int64_t insidePx() const;  ///< of all frames together
};

/// The least, the mean and the largest of some numbers; zeros where there are none.
struct Spread {
  double least = 0.0;
  double mean = 0.0;
  double largest = 0.0;
};
[[nodiscard]] Spread spreadOf(const std::vector<double>& values);

/// The middle one, of an even number the mean of the two in the middle; 0 where there is none.
[[nodiscard]] double medianOf(std::vector<double> values);

/// Median of the frames' border speeds, of those that have a border; the first frame of the
/// sequence tells the speed of the second and does not count. 0 where there is none.
[[nodiscard]] double typicalBorderSpeed(const SequenceFigures& sequence);

}  // namespace fluidymation
