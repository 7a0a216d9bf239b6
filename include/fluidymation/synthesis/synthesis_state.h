#pragma once

#include "fluidymation/core/box.h"
#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"
#include "fluidymation/synthesis/nnf.h"

namespace fluidymation {

/// What a Synthesizer needs to go on after a frame, beside that frame's guides, which can be made
/// again: after each frame alike, so that it may be taken after any. All images are of the box's
/// size.
struct SynthesisState {
  int frame = 0;             ///< frames painted so far
  Size size;                 ///< of the whole frame; 0x0 before the first
  Box box;                   ///< what was worked on of it
  NearestNeighborField nnf;  ///< of the box; frames are numbered as in the whole film
  Image<float> owed;         ///< likewise; movement kept for later, px, 0 where there is no match
  Image<Lab> picture;        ///< likewise; what was painted, which a hold shows once more
  /// The first film frame that was held (`Exemplar::firstFrame`) when the matches were found.
  int filmBegin = 0;

  [[nodiscard]] SynthesisState clone() const {
    return {frame, size, box, nnf.clone(), owed.clone(), picture.clone(), filmBegin};
  }
};

}  // namespace fluidymation
