#pragma once

#include <functional>
#include <ostream>

#include "fluidymation/pipeline.h"

namespace fluidymation::cli {

enum ExitCode : int { kDone = 0, kFailed = 1, kWrongUsage = 2 };

/// A run stopped by signal n ends with 128 + n, as shells say it: 130 for SIGINT, 143 for SIGTERM.
inline constexpr int kStoppedBySignal = 128;

/// Where the tool speaks. Help and version go to `out`, everything else to `err`.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool errIsTerminal = false;
};

/// The engine behind the tool: `stylize`, or a test's stand-in.
using Engine = std::function<void(const Options&, const Observer&)>;

/// The signal that asks the run to stop, 0 while there is none.
using StopSignal = std::function<int()>;

/// Everything `main` does: reads the arguments, runs the engine, reports. Throws nothing.
/// @return  an ExitCode, or `kStoppedBySignal` and the signal's number.
[[nodiscard]] int runTool(int argc, const char* const* argv, const Streams& streams,
                          const Engine& engine, const StopSignal& stopSignal = {}) noexcept;

}  // namespace fluidymation::cli
