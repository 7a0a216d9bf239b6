#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// Size of an image scaled by `scale`: each side rounded to the nearest pixel, at least 1.
[[nodiscard]] Size scaledSize(Size size, double scale);

/// Resamples to `size`: area averaging along a side that shrinks, bilinear along one that grows;
/// the edge repeats. Equal size copies exactly.
[[nodiscard]] Image<float> resize(const Image<float>& image, Size size);
[[nodiscard]] Image<Rgb> resize(const Image<Rgb>& image, Size size);
[[nodiscard]] Image<Vec2> resize(const Image<Vec2>& image, Size size);

}  // namespace fluidymation
