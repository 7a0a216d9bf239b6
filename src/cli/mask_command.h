#pragma once

#include "cli/streams.h"

namespace fluidymation::cli {

/// `fluidymation mask`: makes masks of a film.
/// @throws UsageError, Error, Interrupted.
[[nodiscard]] ExitCode maskCommand(int argc, const char* const* argv, const Streams& streams,
                                   const StopSignal& stopSignal);

}  // namespace fluidymation::cli
