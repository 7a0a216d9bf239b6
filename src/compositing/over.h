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

/// The same over one that may be transparent itself; both of straight alpha. Where neither shows
/// anything, the result is black and transparent.
[[nodiscard]] inline Rgba composited(Rgba over, Rgba under) {
  const float below = (1.0F - over.a) * under.a;
  const float alpha = over.a + below;
  if (alpha <= 0.0F) return {0.0F, 0.0F, 0.0F, 0.0F};
  const float shareOver = over.a / alpha;
  const float shareUnder = below / alpha;
  return {shareOver * over.r + shareUnder * under.r, shareOver * over.g + shareUnder * under.g,
          shareOver * over.b + shareUnder * under.b, alpha};
}

/// Lays a picture over what lies in `canvas`, which has its size (asserted).
void layOver(const Image<Rgba>& picture, Image<Rgba>& canvas);

/// A whole picture over an opaque one; `background` has its size (asserted).
[[nodiscard]] Image<Rgb> composited(const Image<Rgba>& picture, const Image<Rgb>& background);

}  // namespace fluidymation
