#include "support/process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "support/privileges.h"

namespace fluidymation::test {
namespace {

constexpr int kNotStarted = 127;  // exit code

[[noreturn]] void fail(const char* call) {
  throw std::system_error(errno, std::generic_category(), call);
}

/// An open descriptor, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { reset(); }

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool isOpen() const { return number_ >= 0; }
  void reset() {
    if (number_ >= 0) close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// Both ends of what stands in for a stream: the program's, and the test's where it reads.
struct Stream {
  Descriptor program;
  Descriptor test;
};

[[nodiscard]] Stream openStream(StreamKind kind) {
  Stream stream;
  if (kind == StreamKind::kClosed) return stream;
  if (kind == StreamKind::kFullDevice) {
    stream.program = Descriptor(open("/dev/full", O_WRONLY | O_CLOEXEC));
    if (!stream.program.isOpen()) fail("open /dev/full");
    return stream;
  }
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe2");
  stream.test = Descriptor(ends[0]);
  stream.program = Descriptor(ends[1]);
  if (kind == StreamKind::kBrokenPipe) stream.test.reset();
  return stream;
}

[[nodiscard]] std::vector<std::string> environmentOf(const ProcessSetup& setup) {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (setup.environment.count(text.substr(0, text.find('='))) == 0) entries.push_back(text);
  }
  for (const auto& [name, value] : setup.environment) entries.push_back(name + "=" + value);
  return entries;
}

[[nodiscard]] std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

void connect(const Descriptor& from, int to) {
  if (from.isOpen()) {
    dup2(from.number(), to);
  } else {
    close(to);
  }
}

/// Reads both streams until the program closes them; false when the time was over first. Calls
/// `afterLines` once, when so many lines have come from standard error.
[[nodiscard]] bool readToEnd(Stream& out, Stream& err, ProcessResult& result,
                             std::chrono::steady_clock::time_point deadline, int lines,
                             const std::function<void()>& afterLines) {
  bool told = false;
  while (out.test.isOpen() || err.test.isOpen()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) return false;
    std::array<pollfd, 2> waits = {pollfd{out.test.number(), POLLIN, 0},
                                   pollfd{err.test.number(), POLLIN, 0}};
    if (poll(waits.data(), waits.size(), static_cast<int>(left.count())) < 0 && errno != EINTR) {
      fail("poll");
    }
    for (std::size_t i = 0; i < waits.size(); ++i) {
      if (waits[i].revents == 0) continue;
      std::array<char, 4096> buffer{};
      const ssize_t count = read(waits[i].fd, buffer.data(), buffer.size());
      Descriptor& end = i == 0 ? out.test : err.test;
      std::string& text = i == 0 ? result.out : result.err;
      if (count > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(count));
        const auto ended = std::count(result.err.begin(), result.err.end(), '\n');
        if (i == 1 && ended >= lines && !std::exchange(told, true)) afterLines();
      } else if (count == 0 || errno != EINTR) {
        end.reset();
      }
    }
  }
  return true;
}

/// Waits for the program's end; kills it when the time is over. Where no stream is captured nothing
/// tells of the end, so it is asked for.
void waitForEnd(pid_t child, bool outOfTime, std::chrono::steady_clock::time_point deadline,
                ProcessResult& result) {
  int status = 0;
  rusage usage{};
  for (;;) {
    if (!result.timedOut && (outOfTime || std::chrono::steady_clock::now() >= deadline)) {
      kill(child, SIGKILL);
      result.timedOut = true;
    }
    const pid_t ended = wait4(child, &status, result.timedOut ? 0 : WNOHANG, &usage);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) fail("wait4");
    usleep(1000);
  }
  if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  result.peakBytes = std::int64_t{usage.ru_maxrss} * 1024;
}

}  // namespace

ProcessResult runProcess(const std::string& program, const std::vector<std::string>& arguments,
                         const ProcessSetup& setup) {
  std::vector<std::string> argumentTexts = {program};
  argumentTexts.insert(argumentTexts.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = pointersTo(argumentTexts);
  std::vector<std::string> environmentTexts = environmentOf(setup);
  const std::vector<char*> envp = pointersTo(environmentTexts);
  Stream out = openStream(setup.out);
  Stream err = openStream(setup.err);
  const Descriptor executable(open(program.c_str(), O_RDONLY | O_CLOEXEC));
  const Descriptor in(setup.inputClosed ? -1 : open("/dev/null", O_RDONLY | O_CLOEXEC));

  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) fail("fork");
  if (child == 0) {
    // Only calls that are safe after a fork among threads.
    connect(in, STDIN_FILENO);
    connect(out.program, STDOUT_FILENO);
    connect(err.program, STDERR_FILENO);
    if (setup.largestFileBytes) {
      const rlimit limit{*setup.largestFileBytes, *setup.largestFileBytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (setup.addressSpaceBytes) {
      const rlimit limit{*setup.addressSpaceBytes, *setup.addressSpaceBytes};
      setrlimit(RLIMIT_AS, &limit);
    }
    // Where the tests run in the background of a script the shell has these ignored.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, SIG_DFL);
    if (chdir(setup.workingFolder.c_str()) != 0) _exit(kNotStarted);
    if (setup.unprivileged) dropPrivileges();
    // By descriptor: the ordinary user need not be able to reach the build folder.
    fexecve(executable.number(), argv.data(), envp.data());
    _exit(kNotStarted);
  }
  out.program.reset();
  err.program.reset();

  ProcessResult result;
  const auto deadline = start + setup.timeout;
  auto signalled = start;
  const bool complete = readToEnd(out, err, result, deadline, setup.linesBeforeSignal, [&] {
    if (!setup.signalAfterOutput) return;
    kill(child, *setup.signalAfterOutput);
    signalled = std::chrono::steady_clock::now();
  });
  waitForEnd(child, !complete, deadline, result);
  const auto end = std::chrono::steady_clock::now();
  result.seconds = std::chrono::duration<double>(end - start).count();
  result.secondsAfterSignal = std::chrono::duration<double>(end - signalled).count();
  return result;
}

}  // namespace fluidymation::test
