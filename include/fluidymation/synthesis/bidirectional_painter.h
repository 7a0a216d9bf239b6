#pragma once

#include <vector>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/synthesis/painting.h"
#include "fluidymation/synthesis/synthesizer.h"

namespace fluidymation {

/// Frames that are revised together; memory grows with it. The whole of 16 frames instead of 8
/// changed no figure of four pairs beyond their noise.
inline constexpr int kWindowFrames = 8;

/// Paints a target in windows of frames, each forwards and then, but for the last frame of a
/// window, once more from its end to its begin (`Synthesizer::revise`): coherence in both
/// directions of time, where the thesis has only one (P§5). Windows end with frames of certain
/// numbers, and what is painted later goes by the frames as they were painted first, so that a run
/// can go on after any frame but amid a hold.
class BidirectionalPainter {
 public:
  /// @param synthesizer  paints the frames forwards; may have painted some already, the last of
  ///   which then comes before the first frame painted here. Must outlive this.
  explicit BidirectionalPainter(Synthesizer& synthesizer) : synthesizer_(synthesizer) {}

  /// Paints the next frame.
  /// @param endsHere  whether it is the last one.
  /// @return  the frames that are finished by that, in order: those of a window, or none. Those a
  ///   run can go on after have `Painting::forward`.
  [[nodiscard]] std::vector<Painting> paint(const GuidePart& frame, bool endsHere);

 private:
  void revise();

  Synthesizer& synthesizer_;
  Painting before_;  ///< the frame before the window; without matches at the beginning
  std::vector<Painting> window_;
};

}  // namespace fluidymation
