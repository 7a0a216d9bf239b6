#pragma once

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Connected parts of a mask, 8-neighbours.
struct Components {
  Image<int> label;  ///< 0..count-1 inside, in row order of each part's first pixel; -1 outside
  int count = 0;
};

[[nodiscard]] Components findComponents(const Mask& mask);

}  // namespace fluidymation
