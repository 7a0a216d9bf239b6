#pragma once

#include <algorithm>
#include <cstdint>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Where a target pixel takes its patch from: the thesis' (x, y, k, theta), §3.2. The source pixel
/// for window offset o is (x, y) + R_-theta o.
struct Match {
  float x = 0.0F;  ///< px of the level, pixel centres are integers
  float y = 0.0F;
  std::int32_t frame = -1;  ///< k, 0-based; -1: no match
  Rotation rotation;        ///< R_theta turns source directions into target directions

  [[nodiscard]] bool exists() const { return frame >= 0; }
  [[nodiscard]] int nearestX() const { return floorToInt(x + 0.5F); }
  [[nodiscard]] int nearestY() const { return floorToInt(y + 0.5F); }

  /// The match that continues this one `step` target pixels further.
  [[nodiscard]] Match moved(Vec2 step) const {
    const Vec2 sourceStep = rotation.inverse().apply(step);
    return {x + sourceStep.x, y + sourceStep.y, frame, rotation};
  }
};

/// Whether two matches read the same window of the exemplar but for a rounding error.
[[nodiscard]] inline bool areAlike(const Match& a, const Match& b) {
  constexpr float kAlikePx = 1.0F / 256.0F;
  constexpr float kAlikeTurn = 1.0F / 1024.0F;  // moves a window's corner by kAlikePx at most
  const auto near = [](float u, float v, float tolerance) {
    return u - v < tolerance && v - u < tolerance;
  };
  return a.frame == b.frame && near(a.x, b.x, kAlikePx) && near(a.y, b.y, kAlikePx) &&
         near(a.rotation.cosine, b.rotation.cosine, kAlikeTurn) &&
         near(a.rotation.sine, b.rotation.sine, kAlikeTurn);
}

/// Whether a match shows the same patch of the exemplar as another match at the same pixel: their
/// windows then agree to within a pixel.
[[nodiscard]] inline bool continues(const Match& match, const Match& continuation) {
  constexpr float kNearPx =
      0.3F;  // looser, fields never settle: a match slides on along its neighbours
  constexpr float kTurnCosine = 0.9F;  // 26 degrees move a window's edge by less than a pixel
  const Vec2 away{match.x - continuation.x, match.y - continuation.y};
  const float turn = match.rotation.cosine * continuation.rotation.cosine +
                     match.rotation.sine * continuation.rotation.sine;
  return match.frame == continuation.frame && dot(away, away) <= kNearPx * kNearPx &&
         turn >= kTurnCosine;
}

/// Whether source and target move roughly in opposite directions under a match (thesis §3.5). Unit
/// directions are compared, so that material at rest keeps the answer of its last movement.
[[nodiscard]] inline bool isOpposite(Vec2 targetDirection, Vec2 sourceDirection,
                                     const Rotation& rotation) {
  return dot(targetDirection, rotation.apply(sourceDirection)) < 0.0F;
}

/// One match per pixel of the target; pixels outside the mask have none.
using NearestNeighborField = Image<Match>;

[[nodiscard]] inline bool hasAnyMatch(const NearestNeighborField& nnf) {
  return std::any_of(nnf.begin(), nnf.end(), [](const Match& match) { return match.exists(); });
}

/// Counts the frames of matches from `begin` of the film on, where all of it was counted. A match
/// whose frame is not among the `frameCount` frames from there gets the nearest one that is.
inline void toHeldFrames(NearestNeighborField& nnf, int begin, int frameCount) {
  for (Match& match : nnf) {
    if (match.exists()) match.frame = std::clamp(match.frame - begin, 0, frameCount - 1);
  }
}

/// The reverse.
inline void toFilmFrames(NearestNeighborField& nnf, int begin) {
  if (begin == 0) return;
  for (Match& match : nnf) {
    if (match.exists()) match.frame += begin;
  }
}

/// Identifies one run of a random procedure within a level of a frame.
struct Place {
  int frame = 0;
  int level = 0;
  Pixel origin;  ///< of the images at work within the level's: only a box round the mask is
};

}  // namespace fluidymation
