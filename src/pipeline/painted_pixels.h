#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// Straight alpha: painted, and as opaque as the shape covers the pixel; fully transparent where it
/// does not. Near the paint, transparent pixels have its colours (`spreadColors`); further out they
/// are black.
/// @param guides  mask and coverage of the frame.
[[nodiscard]] Image<Rgba8> straightPixels8(const Image<Lab>& picture, const GuideFrame& guides,
                                           const SrgbByteEncoder& encoder);
/// The same in 16 bits, each value rounded once.
[[nodiscard]] Image<Rgba16> straightPixels16(const Image<Lab>& picture, const GuideFrame& guides);

/// Laid over a background (`composited`), of which it has the size (asserted); opaque. Each value
/// is rounded once: neither colours nor coverage are before they are mixed.
[[nodiscard]] Image<Rgba8> opaquePixels8(const Image<Lab>& picture, const GuideFrame& guides,
                                         const Image<Rgb>& background,
                                         const SrgbByteEncoder& encoder);
[[nodiscard]] Image<Rgba16> opaquePixels16(const Image<Lab>& picture, const GuideFrame& guides,
                                           const Image<Rgb>& background);

}  // namespace fluidymation
