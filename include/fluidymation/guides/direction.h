#pragma once

#include <functional>

#include "fluidymation/core/image.h"
#include "fluidymation/guides/diffusion.h"

namespace fluidymation {

/// Slower flow than this has no direction of its own, px per frame.
inline constexpr float kStillPxPerFrame = 0.01F;

struct DirectionField {
  Image<Vec2> direction;  ///< unit vectors inside the mask, (0, 0) outside
  SolveReport report;     ///< of the normals' extension; all zero where no pixel asked for it
};

/// Unit direction of movement at every inside pixel. Where the flow is slower than
/// `kStillPxPerFrame`: the pixel's last direction (`previous`, where the pixel was inside then),
/// else the harmonic extension of the outward border normals, else (1, 0).
/// @param previous  directions of the frame before, (0, 0) outside its mask; or an empty image. Its
///   memory becomes the result's.
/// @param distance  signed distance of `mask`.
/// @param origin  where these images begin in the frame; even. They may show a part of it that
///   holds the shape and `directionMarginPx` round it, as far as the frame reaches: the same comes
///   out, bit for bit.
[[nodiscard]] DirectionField flowDirection(const Mask& mask, const Image<Vec2>& flow,
                                           const Image<float>& distance, Image<Vec2> previous,
                                           Pixel origin = {});

/// How far beyond a shape its border normals are made from, px.
[[nodiscard]] int directionMarginPx();

struct MovingShape {
  Mask mask;
  Image<Vec2> flow;  ///< px per frame
};

/// Directions of the last of the frames begin..end-1, as `flowDirection` gives them one frame after
/// the other. They are found backwards instead: a pixel has that of the last frame in which it
/// moved, else the normal of the frame that covered it. So normals are spread in few of the frames.
/// @param end  above `begin`.
/// @param frameOf     asked at most once for each frame, from the last one on.
/// @param distanceOf  gives the signed distance of a frame that was asked for.
/// @param before  directions of frame begin - 1; an empty image where there is no such frame.
[[nodiscard]] Image<Vec2> directionOfLast(int begin, int end,
                                          const std::function<MovingShape(int frame)>& frameOf,
                                          const std::function<Image<float>(int frame)>& distanceOf,
                                          const Image<Vec2>& before);

}  // namespace fluidymation
