#pragma once

#include <functional>

#include "fluidymation/pipeline.h"
#include "pipeline/frame_writer.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// What the frames' files are to hold: what the options say of them, their background as it is
/// found, and what the exemplar's first frame says about its colours. Tells of frames that say
/// other than it, and of what cannot be carried along.
/// @param beforeFile  called before each file that is read; may throw to stop.
/// @throws Error naming a file that cannot be read.
[[nodiscard]] FrameForm formOf(const Options& options, const Inputs& inputs,
                               const Observer& observer, const std::function<void()>& beforeFile);

}  // namespace fluidymation
