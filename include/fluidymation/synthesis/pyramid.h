#pragma once

#include <cstdint>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"

namespace fluidymation {

/// The part of a mask a pixel belongs to (thesis §3.4). A match stays in its segment.
enum class Segment : std::uint8_t {
  kOutside,
  kBorder,    ///< distance below the border width
  kInterior,  ///< the rest of the mask
};

/// Number L of the coarsest level; 0 is the finest (thesis §3.9): floor(log2(n_min / n)) with
/// n_min the smallest side of source and target and n the patch size, at least 0.
[[nodiscard]] int coarsestLevel(Size source, Size target);

/// Size of the next coarser level: halves, odd sizes round up.
[[nodiscard]] Size halvedSize(Size size);

/// The guides of one frame on one level. Values keep full-resolution units.
struct GuideLevel {
  Mask mask;
  Image<float> distance;     ///< signed, px of the finest level
  Image<float> extForward;   ///< ext+, px; or GuideFrame::age, frames, where there is one
  Image<float> extBackward;  ///< ext-, px; or 0
  Image<Vec2> flow;          ///< px per frame
  Image<Vec2> direction;     ///< unit vectors inside the mask
  Image<float> shape;        ///< GuideFrame::shape; empty unless it was asked for

  /// Whether the distances are the stand-ins of a mask without an edge.
  [[nodiscard]] bool edgeless() const;

  [[nodiscard]] Segment segment(int x, int y, float borderWidthPx) const {
    if (mask(x, y) == 0) return Segment::kOutside;
    return distance(x, y) < borderWidthPx ? Segment::kBorder : Segment::kInterior;
  }
};

[[nodiscard]] GuideLevel finestLevel(const GuideFrame& frame);

/// Next coarser level: distance and shape are the mean of the 2x2 block; extents, flow and
/// direction the mean over its inside pixels; the mask holds a block with any inside pixel, so that
/// every inside pixel has an inside parent. Where the mean flow is slower than `kStillPxPerFrame`
/// the direction is the mean of the directions, else that of the mean flow.
[[nodiscard]] GuideLevel halve(const GuideLevel& fine);

/// Next coarser level of a picture: separable [1 3 3 1] / 8 centred on the 2x2 block; the edge of
/// the image repeats.
[[nodiscard]] Image<Lab> halve(const Image<Lab>& fine);

}  // namespace fluidymation
