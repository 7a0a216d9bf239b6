#pragma once

#include <cmath>
#include <cstdint>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Where a target pixel takes its patch from: the thesis' (x, y, k, theta), §3.2. The source pixel
/// for window offset o is (x, y) + R_-theta o.
struct Match {
  float x = 0.0F;  ///< px of the level, pixel centres are integers
  float y = 0.0F;
  std::int32_t frame = -1;  ///< k, 0-based; -1: no match
  Rotation rotation;        ///< R_theta turns source directions into target directions

  [[nodiscard]] bool exists() const { return frame >= 0; }
  [[nodiscard]] int nearestX() const { return static_cast<int>(std::floor(x + 0.5F)); }
  [[nodiscard]] int nearestY() const { return static_cast<int>(std::floor(y + 0.5F)); }

  /// The match that continues this one `step` target pixels further.
  [[nodiscard]] Match moved(Vec2 step) const {
    const Vec2 sourceStep = rotation.inverse().apply(step);
    return {x + sourceStep.x, y + sourceStep.y, frame, rotation};
  }
};

/// Whether source and target move roughly in opposite directions under a match (thesis §3.5). Unit
/// directions are compared, so that material at rest keeps the answer of its last movement.
[[nodiscard]] inline bool isOpposite(Vec2 targetDirection, Vec2 sourceDirection,
                                     const Rotation& rotation) {
  return dot(targetDirection, rotation.apply(sourceDirection)) < 0.0F;
}

/// One match per pixel of the target; pixels outside the mask have none.
using NearestNeighborField = Image<Match>;

/// Identifies one run of a random procedure within a level of a frame.
struct Place {
  int frame = 0;
  int level = 0;
};

}  // namespace fluidymation
