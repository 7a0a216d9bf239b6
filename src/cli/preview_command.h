#pragma once

#include "cli/streams.h"

namespace fluidymation::cli {

/// `fluidymation preview`: shows frames that are painted already.
/// @throws UsageError, Error.
[[nodiscard]] ExitCode previewCommand(int argc, const char* const* argv, const Streams& streams,
                                      const StopSignal& stopSignal);

}  // namespace fluidymation::cli
