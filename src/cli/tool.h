#pragma once

#include <functional>
#include <ostream>

#include "fluidymation/pipeline.h"

namespace fluidymation::cli {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2 };

/// Where the tool speaks. Help and version go to `out`, everything else to `err`.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool errIsTerminal = false;
};

/// The engine behind the tool: `stylize`, or a test's stand-in.
using Engine = std::function<void(const Options&, const Observer&)>;

/// Everything `main` does: reads the arguments, runs the engine, reports. Throws nothing.
[[nodiscard]] ExitCode runTool(int argc, const char* const* argv, const Streams& streams,
                               const Engine& engine) noexcept;

}  // namespace fluidymation::cli
