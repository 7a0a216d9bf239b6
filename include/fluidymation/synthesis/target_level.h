#pragma once

#include <array>
#include <cstddef>

#include "fluidymation/core/image.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation {

/// One frame of the target on one pyramid level: the guides in the exemplar's units, the picture
/// as it stands, and what the previous frame says. All images have the level's size.
struct TargetLevel {
  TargetLevel(const GuideLevel& given, float borderWidthPx, const ExtentScale& extentScale = {},
              const ShapeRules& rules = {});

  Image<Segment> segment;
  Image<FixedGuides> guides;
  Image<Vec2> direction;
  Image<float> modulationDistancePx;  ///< see `modulationDistances`
  Image<float> speed;                 ///< of the target's flow, px of the finest level per frame

  Image<FixedLab> picture;   ///< T^rgb, in CIELAB, inside the mask; changes with every vote
  Image<FixedLab> previous;  ///< T^prev (§3.7), where it exists
  Image<float> modulation;   ///< m(q) in [0, 1]; 0 without previous match

  [[nodiscard]] Size size() const { return segment.size(); }
  [[nodiscard]] bool inside(int x, int y) const { return segment(x, y) != Segment::kOutside; }

  /// Pixels of a segment; Segment::kOutside is not counted.
  [[nodiscard]] std::size_t count(Segment which) const {
    return which == Segment::kInterior ? interiorCount : borderCount;
  }

  std::size_t borderCount = 0;
  std::size_t interiorCount = 0;
};

}  // namespace fluidymation
