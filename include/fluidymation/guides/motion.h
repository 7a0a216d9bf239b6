#pragma once

#include "fluidymation/core/image.h"
#include "fluidymation/guides/diffusion.h"

namespace fluidymation {

/// Inside pixels with a 4-neighbour, within the image, outside.
[[nodiscard]] Mask borderPixels(const Mask& mask);

/// Half-pixel correction for the flow only: distance - 1/2 inside, + 1/2 outside, so that the
/// field is continuous across the edge. Without it the speed of a disc growing by 0.2 px per frame
/// comes out 1.56 times too high.
[[nodiscard]] Image<float> continuousDistance(const Image<float>& signedDistance);

/// Blur of the distance field for the flow, px. The distance to the nearest outside pixel is exact
/// at horizontal and vertical edges only: at a diagonal one it changes by 1.41 per px across the
/// edge and by 0.59 right inside it. Unblurred, a disc growing by 0.2 px per frame has 0.76 of its
/// speed in the first frame and 1.13 in the last, and 0.17 of its length points sideways; at 1 px
/// it is 0.93 to 0.99 of the speed in all frames, and 0.06 sideways.
inline constexpr float kStaircaseSigmaPx = 1.0F;

/// The distance field that flow and normals are made of: `continuousDistance`, blurred by
/// `kStaircaseSigmaPx`.
[[nodiscard]] Image<float> motionDistance(const Image<float>& signedDistance);

struct MotionField {
  Image<Vec2> flow;  ///< px per frame, from the previous frame to this one; zero outside the mask
  SolveReport report;
};

/// The movement that leads from one frame's shape to the next, defined on `mask` (thesis §3.8):
/// at border pixels -(after - before) grad(here) / |grad(here)|, spread over the inside by
/// `diffuse`. The documents drop the minus sign; with distances positive inside the gradient
/// points inwards, and a growing mask has to flow outwards.
/// @param mask    the frame on which the flow is defined.
/// @param before  `motionDistance` (temporally smoothed) of the earlier frame.
/// @param after   the same of the later frame.
/// @param here    the same of the frame of `mask` (either of the two): its gradient is used.
/// The speed at a border pixel is limited to the largest `here` of its connected component
/// (8-neighbours): what appears at once, or flies in from elsewhere, does not move further than it
/// is thick. Where the gradient vanishes (parts one or two pixels wide) the flow is zero.
[[nodiscard]] MotionField motionField(const Mask& mask, const Image<float>& before,
                                      const Image<float>& after, const Image<float>& here);

}  // namespace fluidymation
