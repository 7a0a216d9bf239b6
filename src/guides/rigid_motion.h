#pragma once

#include "components.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// What the border of each part tells about its movement as a whole. The shape of a part shows only
/// the movement along its normals; spread inside harmonically, that makes a disc that travels 3 px
/// per frame move by 1.4 px inside. Fitted to the border's normal speeds, per part and by least
/// squares: one translation, rotation and scaling, v(p) = t + w x (p - c) + s (p - c).
///
/// How far to believe it follows from the share of the squared normal speeds that it explains: not
/// at all up to kUnexplainedShare, fully from kExplainedShare on. A figure that waves an arm
/// while it stands must not slide.
/// @param border   pixels that count.
/// @param normals  unit normals at border pixels; zero where there is none.
/// @param speeds   movement along the normal at border pixels, px per frame.
/// @param origin  where the first pixel lies in the image that these are part of: sums of places
/// are
///   rounded as there.
/// @return  the believed movement of every pixel of the parts, px per frame; zero outside.
[[nodiscard]] Image<Vec2> rigidMotion(const Components& parts, const Mask& border,
                                      const Image<Vec2>& normals, const Image<float>& speeds,
                                      Pixel origin = {});

}  // namespace fluidymation
