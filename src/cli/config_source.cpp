#include "cli/config_source.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <system_error>

#include "cli/stop_signal.h"
#include "fluidymation/core/error.h"

namespace fluidymation::cli {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;  // all options with the longest paths take 64 KiB

/// An open file.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }

  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

[[nodiscard]] std::string reason() { return " (" + std::generic_category().message(errno) + ")"; }

/// Waits until there is something to read. Unlike `read`, `poll` is never taken up again after a
/// signal.
void waitFor(int descriptor, const std::string& path) {
  // A signal that comes just before the waiting would go unnoticed: so wait for a while only
  constexpr int kAWhileMs = 200;
  if (receivedStopSignal() != 0) throw Interrupted("interrupted while " + path + " was read");
  pollfd waiting{descriptor, POLLIN, 0};
  (void)poll(&waiting, 1, kAWhileMs);
}

}  // namespace

std::string configSource(const std::string& path) {
  // Without O_NONBLOCK a named pipe would wait for a writer for ever.
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.number() < 0) throw Error(path + ": cannot be opened" + reason());
  struct stat status {};
  if (fstat(file.number(), &status) != 0) throw Error(path + ": cannot be read" + reason());
  const bool isPipe = S_ISFIFO(status.st_mode);
  if (!isPipe && !S_ISREG(status.st_mode)) {
    throw Error(path + ": is " + (S_ISDIR(status.st_mode) ? "a folder" : "no regular file") +
                "; wanted a config file");
  }
  std::string text(kMostBytes + 1, '\0');
  std::size_t length = 0;
  while (length < text.size()) {
    const ssize_t count = read(file.number(), text.data() + length, text.size() - length);
    if (count == 0) break;
    if (count > 0) {
      length += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      waitFor(file.number(), path);
    } else if (errno != EINTR) {
      throw Error(path + ": cannot be read" + reason());
    }
  }
  text.resize(length);
  if (isPipe && text.empty()) {
    throw Error(path + ": is a pipe that nobody writes into; wanted a config file");
  }
  if (text.size() > kMostBytes) throw Error(path + ": is too large; wanted a config file");
  return text;
}

}  // namespace fluidymation::cli
