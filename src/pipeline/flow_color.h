#pragma once

#include "fluidymation/core/geometry.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// Angle as hue (right is red, down is yellow-green, left is cyan, up is violet), magnitude times
/// `scale` as intensity, at most 1 (thesis figure 3.3b). Opaque.
[[nodiscard]] Rgba8 flowColor(Vec2 flow, float scale);

}  // namespace fluidymation
