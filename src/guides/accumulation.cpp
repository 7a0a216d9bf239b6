#include "fluidymation/guides/accumulation.h"

#include "fluidymation/core/parallel.h"

namespace fluidymation {

Image<Vec2> accumulateForward(const Image<Vec2>& previous, const Image<Vec2>& flow,
                              const Mask& mask) {
  Image<Vec2> accumulated(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) != 0) accumulated(x, y) = previous(x, y) + flow(x, y);
    }
  });
  return accumulated;
}

Image<Vec2> accumulateBackward(const Image<Vec2>& next, const Image<Vec2>& nextFlow,
                               const Mask& nextMask, const Image<Vec2>& flow, const Mask& mask) {
  Image<Vec2> accumulated(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) == 0) continue;
      // Where the material leaves, the next frame has no flow to offer: its own last one stands in
      accumulated(x, y) = next(x, y) + (nextMask(x, y) != 0 ? nextFlow(x, y) : flow(x, y));
    }
  });
  return accumulated;
}

}  // namespace fluidymation
