#pragma once

#include "fluidymation/options.h"

namespace fluidymation {

/// Sets everything that shapes the picture to the thesis' own rules and numbers (§4.5), whatever
/// the defaults have become since. Paths, numbering, scales, seed and threads stay as they are.
void applyThesisPreset(Options& options);

}  // namespace fluidymation
