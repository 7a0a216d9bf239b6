#pragma once

#include <functional>

#include "checkpoint/fingerprint.h"
#include "fluidymation/options.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// What the frames of this run depend on: reads all input files.
/// @param options     with all widths found, in the order of painting (`inPaintingOrder`).
/// @param beforeEach  called before each file.
/// @throws Error naming a file that cannot be read.
[[nodiscard]] Fingerprint fingerprintOf(const Options& options, const Inputs& inputs,
                                        const std::function<void()>& beforeEach);

}  // namespace fluidymation
