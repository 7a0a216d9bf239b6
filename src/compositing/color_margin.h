#pragma once

#include "fluidymation/core/image.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// How far colours go on past the paint, px: as far as bicubic scaling to half the size looks.
inline constexpr int kColorMarginPx = 4;

/// Gives transparent pixels up to `kColorMarginPx` from others, along x and y, their colours, ring
/// by ring: the mean of those of the ring before that they touch. Programs that mix pixels without
/// regard to alpha then show no dark fringe. Pixels further out stay as they are, and so does all
/// alpha.
void spreadColors(Image<Rgba8>& image);
void spreadColors(Image<Rgba16>& image);

}  // namespace fluidymation
