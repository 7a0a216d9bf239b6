#pragma once

#include <functional>
#include <optional>

#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/options.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// How the guides of a sequence are made whose masks are smoothed by this sigma and which moves by
/// this model.
/// @param options  with a border width.
[[nodiscard]] GuideOptions guideOptions(const Options& options, float blurSigmaPx,
                                        MotionModel motionModel);

/// Reads the given flow; empty where there is none.
/// @param flow        must outlive the reader.
/// @param beforeEach  called before each frame.
[[nodiscard]] FlowReader flowReader(const std::optional<FlowSequence>& flow,
                                    const std::function<void()>& beforeEach);

}  // namespace fluidymation
