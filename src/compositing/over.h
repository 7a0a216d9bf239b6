#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// A pixel of straight alpha over an opaque one: alpha * over + (1 - alpha) * under, of the
/// sRGB-encoded values, as browsers, players and editors do unless told else. Porter and Duff,
/// Compositing Digital Images (1984).
[[nodiscard]] inline Rgb composited(Rgba over, Rgb under) {
  const float rest = 1.0F - over.a;
  return {over.a * over.r + rest * under.r, over.a * over.g + rest * under.g,
          over.a * over.b + rest * under.b};
}

/// The same for all pixels of a picture; `background` has its size (asserted).
[[nodiscard]] Image<Rgb> composited(const Image<Rgba>& picture, const Image<Rgb>& background);

}  // namespace fluidymation
