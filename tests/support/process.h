#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fluidymation::test {

/// What a program finds in place of standard output or standard error.
enum class StreamKind {
  kCaptured,    ///< a pipe that the test reads to its end
  kClosed,      ///< nothing: the descriptor is not open
  kBrokenPipe,  ///< a pipe that nobody reads any more
  kFullDevice,  ///< a device that has no room for a single byte
};

/// How a program is run.
struct ProcessSetup {
  std::string workingFolder = ".";
  StreamKind out = StreamKind::kCaptured;
  StreamKind err = StreamKind::kCaptured;
  bool inputClosed = false;                        ///< standard input too
  std::map<std::string, std::string> environment;  ///< added to the test's own
  /// No file may become larger: stands for a full disk, which shows in the same calls.
  std::optional<std::uint64_t> largestFileBytes;
  /// No more address space than this, as after ulimit -v. Not for programs with a sanitizer.
  std::optional<std::uint64_t> addressSpaceBytes;
  /// As an ordinary user where the test runs as root; the folder has to be that user's.
  bool unprivileged = false;
  /// Sent once, as soon as the program has written so many lines to standard error.
  std::optional<int> signalAfterOutput;
  int linesBeforeSignal = 1;
  /// For the slowest build; a program that runs longer is ended and counts as hung.
  std::chrono::seconds timeout{240};
};

struct ProcessResult {
  int exitCode = -1;  ///< -1 when a signal ended it
  int signal = 0;     ///< that signal
  bool timedOut = false;
  std::string out;
  std::string err;
  double seconds = 0.0;
  double secondsAfterSignal = 0.0;  ///< from the signal to the program's end
  std::int64_t peakBytes = 0;       ///< largest resident memory
};

/// Runs the program of that path with these arguments, no shell in between, and waits for its end.
[[nodiscard]] ProcessResult runProcess(const std::string& program,
                                       const std::vector<std::string>& arguments,
                                       const ProcessSetup& setup = {});

}  // namespace fluidymation::test
