#pragma once

namespace fluidymation::cli {

/// Has threads that wait for others sleep soon instead of spinning. Left to themselves GCC's spin
/// for milliseconds and LLVM's for a fifth of a second, and where other programs want the
/// processors the spinning threads keep from them those that they wait for: on 2 processors with 6
/// other jobs a run took 2 to 3 times as long (docs/performance.md). OpenMP reads such settings
/// from the environment before `main`, so the program is started anew once, in the same process.
/// Where the environment already says how to wait, or the program cannot be started anew, nothing
/// happens. To be called first: nothing that is open or set may get lost.
void keepWaitingThreadsFromSpinning(char* const* argv);

}  // namespace fluidymation::cli
