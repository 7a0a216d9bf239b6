#pragma once

#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"

namespace fluidymation {

/// The same frames from the last to the first.
/// @param sequence  of as many frames as it says.
[[nodiscard]] SequenceOptions backwards(SequenceOptions sequence);

/// The options of a run in the order that its frames are painted in: where --reverse asks for it,
/// the target is played backwards, all of its frames are demanded, and `reverse` is kOn; else it is
/// kOff, and the target as it was. Says so, and why where that was found out.
/// @throws Error, UsageError as `openInputs` does, where the target has to be looked at.
[[nodiscard]] Options inPaintingOrder(const Options& given, const Observer& observer);

}  // namespace fluidymation
