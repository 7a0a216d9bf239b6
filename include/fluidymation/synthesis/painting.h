#pragma once

#include <memory>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/synthesis/synthesis_state.h"

namespace fluidymation {

/// A painted frame with what the frames before and after it need of it, as far as that lies in
/// `state.box`, a box round its mask.
struct Painting {
  SynthesisState state;  ///< matches and picture; once it is revised, `forward` is another one
  /// To go on from after the frame, as it was painted first; none amid a hold, and none before a
  /// `BidirectionalPainter` has seen the frame.
  std::shared_ptr<const SynthesisState> forward;
  GuideFrame guides;
  bool held = false;  ///< whether it is the frame before once more
};

}  // namespace fluidymation
