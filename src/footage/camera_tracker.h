#pragma once

#include <optional>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// Finds how far the camera has moved since the bare surface was taken, by matching blocks of it
/// that have some structure. Paint hides some blocks and fakes others; the movement on which most
/// of them agree is the camera's.
class CameraTracker {
 public:
  explicit CameraTracker(const Image<Lab>& bare);

  /// How far the surface in `frame`, of the same size (asserted), lies from where it was: pixels,
  /// up to `kReachPx` along x and y, to about a tenth.
  /// @return  nothing where the surface is too even to tell, too much of it is hidden, or it has
  ///   moved further.
  [[nodiscard]] std::optional<Vec2> offsetOf(const Image<Lab>& frame) const;

  static constexpr int kReachPx = 12;

 private:
  Image<float> bare_;  ///< lightness, smoothed
  std::vector<Pixel> blocks_;
};

}  // namespace fluidymation
