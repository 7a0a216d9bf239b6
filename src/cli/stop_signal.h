#pragma once

namespace fluidymation::cli {

/// From now on the first SIGINT (Ctrl-C) or SIGTERM is remembered instead of ending the process, so
/// that the run can end between two frames; a second one ends the process at once. A signal that
/// the caller has this process ignore, as nohup and shell scripts do, stays ignored.
void listenForStopSignals();

/// The signal received since, or 0.
[[nodiscard]] int receivedStopSignal();

}  // namespace fluidymation::cli
