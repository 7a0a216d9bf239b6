#pragma once

#include <functional>
#include <ostream>

namespace fluidymation::cli {

enum ExitCode : int { kDone = 0, kFailed = 1, kWrongUsage = 2 };

/// Where the tool speaks. What was asked for goes to `out`, everything else to `err`.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool errIsTerminal = false;
};

/// The signal that asks the run to stop, 0 while there is none.
using StopSignal = std::function<int()>;

/// Flushes `out`. @throws Error where not all that was said has arrived.
void requireWritten(const Streams& streams);

}  // namespace fluidymation::cli
