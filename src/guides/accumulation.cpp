#include "fluidymation/guides/accumulation.h"

#include <cstddef>

namespace fluidymation {

std::vector<Vec2> accumulateForward(const PackedMask& previousMask,
                                    const std::vector<Vec2>& previous, const PackedMask& mask,
                                    const std::vector<Vec2>& flow) {
  std::vector<Vec2> accumulated(flow.size());
  forEachStretch(
      mask, previousMask,
      [&](std::size_t begin, std::size_t end, std::size_t own, bool isShared, std::size_t other) {
        for (std::size_t i = 0; i < end - begin; ++i) {
          accumulated[own + i] = (isShared ? previous[other + i] : Vec2{}) + flow[own + i];
        }
      });
  return accumulated;
}

std::vector<Vec2> accumulateBackward(const PackedMask& nextMask, const std::vector<Vec2>& next,
                                     const std::vector<Vec2>& nextFlow, const PackedMask& mask,
                                     const std::vector<Vec2>& flow) {
  std::vector<Vec2> accumulated(flow.size());
  forEachStretch(
      mask, nextMask,
      [&](std::size_t begin, std::size_t end, std::size_t own, bool isShared, std::size_t other) {
        for (std::size_t i = 0; i < end - begin; ++i) {
          // Where the material leaves, the next frame has no flow to offer: its own last one stands
          // in
          accumulated[own + i] =
              isShared ? next[other + i] + nextFlow[other + i] : Vec2{} + flow[own + i];
        }
      });
  return accumulated;
}

}  // namespace fluidymation
