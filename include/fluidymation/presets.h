#pragma once

#include "fluidymation/options.h"

namespace fluidymation {

/// Sets everything that shapes the picture to the thesis' own rules and numbers (§4.5), whatever
/// the defaults have become since. Paths, numbering, scales, seed and threads stay as they are.
void applyThesisPreset(Options& options);

/// The same for the paper: table 1 and the rules of P§3 and its appendix A; what it leaves open is
/// as in the thesis. Its widths are pixels of targets of 500 to 1000 px a side.
void applyPaperPreset(Options& options);

}  // namespace fluidymation
