#pragma once

#include <functional>
#include <utility>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// A mask as read from the user, before smoothing.
struct InputMask {
  InputMask() = default;
  InputMask(Image<float> coverageOfPixels, bool isSoft)
      : coverage(std::move(coverageOfPixels)), soft(isSoft) {}
  /// A hard one. Not explicit: wherever an input mask is wanted, a hard one is as good.
  InputMask(const Mask& mask);

  /// Cut at one half.
  [[nodiscard]] Mask cut() const;

  Image<float> coverage;  ///< how much of each pixel lies inside, in [0, 1]
  /// Whether any pixel was stored as partly covered. Hard masks, which are not, may have partly
  /// covered pixels too, once they are scaled.
  bool soft = false;
};

/// Gives the mask of frame i (0-based). Called once for every frame, in order.
using MaskReader = std::function<InputMask(int frame)>;

}  // namespace fluidymation
