#pragma once

#include <vector>

#include "fluidymation/core/image.h"
#include "fluidymation/guides/diffusion.h"
#include "fluidymation/options.h"

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

/// Largest depth of each connected part (8-neighbours) in the row order of their first pixels, at
/// least 0: how far it may move in one frame.
/// @param depth  `continuousDistance` of the mask, which no blur lowers.
[[nodiscard]] std::vector<float> partThicknesses(const Mask& mask, const Image<float>& depth);

/// A share of a field in a mean.
struct WeightedField {
  const Image<float>* field;
  float weight;
};

/// What the shapes of neighbouring frames say about one frame's movement. All images have one size;
/// fields are `motionDistance`.
struct ShapeChange {
  std::vector<float> thicknesses;     ///< `partThicknesses` of the frame itself
  std::vector<WeightedField> smooth;  ///< their sum is the frame's own field, smoothed over time
  std::vector<const Image<float>*> fields;  ///< of consecutive frames, earliest first
  std::vector<float> stepWeights;           ///< of the steps between them; one fewer
};

/// The movement that leads from one frame's shape to the next, defined on `mask` (thesis §3.8):
/// at border pixels -(D^_i - D^_i-1) grad(D^_i) / |grad(D^_i)|, D^ smoothed over time, spread over
/// the inside by `diffuse`. The documents drop the minus sign; with distances positive inside the
/// gradient points inwards, and a growing mask has to flow outwards.
///
/// D^_i - D^_i-1 is a weighted mean of the steps of the single frames, and each of them is limited
/// to the largest depth of the pixel's connected component (8-neighbours): what appears at once, or
/// flies in from elsewhere, does not move further than it is thick. Limiting the mean instead
/// leaves a choice of two errors: by the depth of D^, which vanishes where a part crosses its own
/// width within the window, fast parts stand still; by the depth of the frame, what appears at
/// once moves by its thickness in every frame of the window.
/// Where the gradient vanishes (parts one or two pixels wide) the flow is zero.
/// @param mask  the frame on which the flow is defined.
/// @param origin  even: where the first pixel lies in the image that all of these are part of.
/// @param model  whether parts are also fitted a movement as a whole, so that only what their
///   border moves beside it is spread inside.
[[nodiscard]] MotionField motionField(const Mask& mask, const ShapeChange& change,
                                      MotionModel model = MotionModel::kNormals, Pixel origin = {});

}  // namespace fluidymation
