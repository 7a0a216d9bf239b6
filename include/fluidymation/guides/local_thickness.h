#pragma once

#include "fluidymation/core/image.h"

namespace fluidymation {

/// How thick the shape is round each pixel: the radius of the largest disc within the shape that
/// covers the pixel, its depth measured as `distance` measures it, but at most `limitPx`.
/// @param distance  signed distance field, px, positive inside.
/// @param limitPx   > 0; parts at least this thick are not told apart.
/// @return  same size, px; at least min(distance, limitPx) inside, 0 outside. Time is linear in the
///   pixels, and in the area of the discs, up to limitPx^2 each, within parts thinner than the
///   limit and where thick ones reach into them.
[[nodiscard]] Image<float> localThickness(const Image<float>& distance, float limitPx);

/// The distance to the edge as the edge guide wants it, so that thin parts have a body: where the
/// shape is thinner than the medium's rim, distances are stretched until the middle of the part
/// lies as deep as the rim is wide. Unstretched, legs, ears and drawn lines never get deeper than a
/// few px and are painted with nothing but the medium's pale fringe.
/// @return  distance * borderWidthPx / localThickness inside; `distance` outside, and wherever the
///   shape is at least borderWidthPx thick.
[[nodiscard]] Image<float> stretchedDistance(const Image<float>& distance, float borderWidthPx);

}  // namespace fluidymation
