#pragma once

#include "cli/paint_run.h"
#include "cli/streams.h"

namespace fluidymation::cli {

/// A run stopped by signal n ends with 128 + n, as shells say it: 130 for SIGINT, 143 for SIGTERM.
inline constexpr int kStoppedBySignal = 128;

/// Everything `main` does: reads the arguments, runs the engine or a
/// subcommand, reports. Throws nothing.
/// @return  an ExitCode, or `kStoppedBySignal` and the signal's number.
[[nodiscard]] int runTool(int argc, const char* const* argv, const Streams& streams,
                          const Engine& engine, const StopSignal& stopSignal = {}) noexcept;

}  // namespace fluidymation::cli
