#pragma once

namespace fluidymation::cli {

/// From now on the first SIGINT (Ctrl-C), SIGTERM or SIGHUP (the terminal is closed) is remembered
/// instead of ending the process, so that the run can save its state; a second SIGINT or SIGTERM
/// ends the process at once, a second SIGHUP says nothing new. A signal that the caller has this
/// process ignore, as nohup and shell scripts do, stays ignored.
void listenForStopSignals();

/// The signal received since, or 0.
[[nodiscard]] int receivedStopSignal();

}  // namespace fluidymation::cli
