#pragma once

#include <functional>

#include "fluidymation/layers.h"
#include "layers/layer_inputs.h"
#include "pipeline/starting_point.h"

namespace fluidymation {

/// The composited frames as those of a run, whose fingerprint is still empty.
[[nodiscard]] RunIdentity compositedFrames(const LayeredShot& shot, const LayerInputs& layers);

/// All frames of the shot: compositing always begins with the first.
[[nodiscard]] StartingPoint wholeShot(const LayerInputs& layers);

/// Makes sure, before the layers are painted, that no composited frame would be refused then, as
/// far as that can be told by now: see `requireOwnFrames`.
/// @param beforeEach  called before each file that is read.
/// @throws Error naming the frame; Error where another run is at work on them.
void requireOwnComposite(const LayeredShot& shot, const LayerInputs& layers,
                         const std::function<void()>& beforeEach);

}  // namespace fluidymation
