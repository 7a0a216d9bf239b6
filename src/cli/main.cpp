#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "cli/stop_signal.h"
#include "cli/thread_waiting.h"
#include "cli/tool.h"
#include "fluidymation/pipeline.h"

namespace {

/// A caller may have closed the standard streams; the next file opened would then take the number
/// of, say, stderr, and progress would be written into a painted frame.
void occupyStandardStreams() {
  int descriptor = open("/dev/null", O_RDWR);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDWR);
  if (descriptor >= 0) close(descriptor);
}

/// Every frame takes and returns the same large buffers. Left to itself the C library hands them
/// back to the kernel, which clears their pages anew for the next frame: 7 % of the time of a run.
/// And all threads take them from one heap: with one each, what the guides of a frame leave behind
/// is of no use to its search, and a run of 1000x800 takes 34 MiB more.
void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kLargestBytes = 32 << 20;  // that may lie in the heap, says mallopt(3)
  // NOLINTBEGIN(concurrency-mt-unsafe): no thread has been started yet
  mallopt(M_MMAP_THRESHOLD, kLargestBytes);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_ARENA_MAX, 1);
  // NOLINTEND(concurrency-mt-unsafe)
#endif
}

}  // namespace

int main(int argc, char** argv) {
  fluidymation::cli::keepWaitingThreadsFromSpinning(argv);
  occupyStandardStreams();
  keepFreedMemory();
  // A closed terminal or pipe costs the progress lines, not the painting.
  std::signal(SIGPIPE, SIG_IGN);
  // Beyond a limit on file sizes a write then fails with a reason instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  fluidymation::cli::listenForStopSignals();
  const bool errIsTerminal = isatty(STDERR_FILENO) != 0;
  return fluidymation::cli::runTool(argc, argv, {std::cout, std::cerr, errIsTerminal},
                                    fluidymation::stylize, fluidymation::cli::receivedStopSignal);
}
