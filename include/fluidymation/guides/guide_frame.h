#pragma once

#include "fluidymation/core/frame_part.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/diffusion.h"

namespace fluidymation {

/// All guides of one frame, of the exemplar or of the target, at full resolution. All images have
/// the frame's size; distances and motions in px.
struct GuideFrame {
  Mask mask;                ///< after smoothing (§4.1)
  Image<float> distance;    ///< signed, positive inside, between pixel centres (§3.4)
  Image<Vec2> flow;         ///< from the previous frame to this one, px per frame (§3.8)
  Image<Vec2> direction;    ///< unit direction of the flow, defined on the whole mask
  Image<Vec2> accForward;   ///< motion accumulated since the start; its length is ext+ (§3.5)
  Image<Vec2> accBackward;  ///< motion still to come; its length is ext- (§3.5)
  SolveReport diffusion;    ///< what the solver did, for the flow or its direction: the worse
  Image<float> shape;       ///< mask blurred, 0 to 1 (P§3.1); empty unless it was asked for
  /// How much of each pixel the shape covers, in [0, 1], where the masks are soft. Empty where they
  /// are hard: then the mask says it all.
  Image<float> coverage = {};
  /// How long the material lies there, frames (`TargetAges`, `FilmAges`): where it is given, it
  /// takes the place of the extents. Empty unless it was asked for.
  Image<float> age = {};
  bool ageGrows = false;  ///< whether what stayed covered is older than in the frame before

  [[nodiscard]] float coverageAt(int x, int y) const {
    if (!coverage.empty()) return coverage(x, y);
    return mask(x, y) != 0 ? 1.0F : 0.0F;
  }
};

/// The guides of a part of a frame, which holds all of the shape: all images have the size of its
/// box. What the distances are beyond it is not told.
struct GuidePart {
  FramePart part;
  GuideFrame guides;
};

}  // namespace fluidymation
