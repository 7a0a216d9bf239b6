#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/core/frame_part.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// What of a frame is painted.
struct PaintedPart {
  const FramePart& part;  ///< what picture and guides show; nothing is painted beyond it
  const Image<Lab>& picture;
  const GuideFrame& guides;  ///< mask and coverage
};

/// The part with room for the colours of `spreadColors`, as far as the frame reaches.
[[nodiscard]] FramePart withColorMargin(const FramePart& part);

/// Straight alpha: painted, and as opaque as the shape covers the pixel; fully transparent where it
/// does not. Near the paint, transparent pixels have its colours (`spreadColors`); further out they
/// are black.
/// @return  of the part `withColorMargin`.
[[nodiscard]] Image<Rgba8> straightPixels8(const PaintedPart& painted,
                                           const SrgbByteEncoder& encoder);
/// The same in 16 bits, each value rounded once.
[[nodiscard]] Image<Rgba16> straightPixels16(const PaintedPart& painted);

/// A background without paint.
[[nodiscard]] Image<Rgba8> barePixels8(const Image<Rgb>& background);
[[nodiscard]] Image<Rgba16> barePixels16(const Image<Rgb>& background);

/// Laid over a background (`composited`) of the frame's size (asserted); opaque. Each value
/// is rounded once: neither colours nor coverage are before they are mixed.
/// @param bare  what `barePixels8` or `barePixels16` makes of the background.
/// @return  of the whole frame.
[[nodiscard]] Image<Rgba8> opaquePixels8(const PaintedPart& painted, const Image<Rgb>& background,
                                         const Image<Rgba8>& bare, const SrgbByteEncoder& encoder);
[[nodiscard]] Image<Rgba16> opaquePixels16(const PaintedPart& painted, const Image<Rgb>& background,
                                           const Image<Rgba16>& bare);

}  // namespace fluidymation
