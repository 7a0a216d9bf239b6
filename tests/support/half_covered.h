#pragma once

#include "fluidymation/guides/guide_frame.h"

namespace fluidymation::test {

/// The left half covered, and a column in the middle covered in part.
[[nodiscard]] inline GuideFrame halfCovered(Size size) {
  GuideFrame guides;
  guides.mask = Mask(size);
  guides.coverage = Image<float>(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x <= size.width / 2; ++x) {
      const bool edge = x == size.width / 2;
      guides.mask(x, y) = edge ? 0 : 1;
      guides.coverage(x, y) = edge ? 0.25F : 1.0F;
    }
  }
  return guides;
}

}  // namespace fluidymation::test
