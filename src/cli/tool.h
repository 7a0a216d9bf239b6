#pragma once

#include <functional>

#include "cli/streams.h"
#include "fluidymation/pipeline.h"

namespace fluidymation::cli {

/// A run stopped by signal n ends with 128 + n, as shells say it: 130 for SIGINT, 143 for SIGTERM.
inline constexpr int kStoppedBySignal = 128;

/// The engine behind the tool: `stylize`, or a test's stand-in.
using Engine = std::function<void(const Options&, const Observer&)>;

/// Everything `main` does: reads the arguments, runs the engine or a
/// subcommand, reports. Throws nothing.
/// @return  an ExitCode, or `kStoppedBySignal` and the signal's number.
[[nodiscard]] int runTool(int argc, const char* const* argv, const Streams& streams,
                          const Engine& engine, const StopSignal& stopSignal = {}) noexcept;

}  // namespace fluidymation::cli
