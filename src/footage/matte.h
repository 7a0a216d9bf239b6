#pragma once

#include <cstdint>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

struct Matte {
  Image<Rgba8> picture;      ///< straight alpha; black where nothing is
  std::int64_t lighter = 0;  ///< pixels that no multiplication gives: lighter than the surface
};

/// The pigment of a frame without the surface that it lies on: multiplied over the bare surface, in
/// encoded values as compositors do (surface * (1 - alpha + alpha * colour)), it gives the frame
/// back within one of 255; over white, the frame with the surface divided out.
/// @param frame, bare  sRGB-encoded, of one size with `coverage` (asserted).
/// @param coverage  in [0, 1]; becomes alpha.
[[nodiscard]] Matte multiplyMatte(const Image<Rgb>& frame, const Image<Rgb>& bare,
                                  const Image<float>& coverage);

}  // namespace fluidymation
