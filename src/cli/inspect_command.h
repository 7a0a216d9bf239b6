#pragma once

#include "cli/streams.h"

namespace fluidymation::cli {

/// `fluidymation inspect`: the options of painting, and what to expect of them.
/// @return  kFailed where a fault keeps the run from being painted.
/// @throws UsageError, Error, Interrupted.
[[nodiscard]] ExitCode inspectCommand(int argc, const char* const* argv, const Streams& streams,
                                      const StopSignal& stopSignal);

}  // namespace fluidymation::cli
