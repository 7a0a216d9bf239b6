#include "fluidymation/io/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

[[noreturn]] void fail(const std::string& path, int code) {
  throw Error(path + ": cannot be locked (" + std::generic_category().message(code) + ")");
}

[[nodiscard]] std::string thisProcess() {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) != 0) host = {'?'};
  return "process " + std::to_string(getpid()) + " on host " + host.data();
}

[[nodiscard]] bool isUnprintable(char c) { return c < ' ' || c > '~'; }

/// The holder's words, as far as they are short; what is not printable is replaced.
[[nodiscard]] std::string contentOf(int descriptor) {
  std::array<char, 300> buffer{};
  const ssize_t count = pread(descriptor, buffer.data(), buffer.size(), 0);
  std::string text(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  text.erase(std::find(text.begin(), text.end(), '\n'), text.end());
  std::replace_if(text.begin(), text.end(), isUnprintable, '?');
  return text;
}

/// Whether the file of that name is still the one that is open: its holder removes it at the end.
[[nodiscard]] bool isStillThere(const std::string& path, int descriptor) {
  struct stat named {};
  struct stat opened {};
  return stat(path.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 &&
         named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

enum class Attempt { kLocked, kHeldByOther, kNoLocksHere, kFailed };

[[nodiscard]] Attempt tryLock(int descriptor) {
  while (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    switch (errno) {
      case EINTR:
        break;
      case EWOULDBLOCK:
        return Attempt::kHeldByOther;
      case ENOLCK:
      case ENOSYS:
      case EOPNOTSUPP:
      case EINVAL:
        return Attempt::kNoLocksHere;
      default:
        return Attempt::kFailed;  // errno says why
    }
  }
  return Attempt::kLocked;
}

}  // namespace

FileLock::FileLock(std::string path, const std::string& work) : path_(std::move(path)) {
  for (;;) {
    constexpr mode_t kMode = 0666;  // less the user's mask
    descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, kMode);
    if (descriptor_ < 0) fail(path_, errno);
    const Attempt attempt = tryLock(descriptor_);
    if (attempt == Attempt::kFailed) {
      const int code = errno;
      close(descriptor_);
      fail(path_, code);
    }
    if (attempt == Attempt::kHeldByOther) {
      const std::string holder = contentOf(descriptor_);
      close(descriptor_);
      throw Error(path_ + ": " + (holder.empty() ? "another process" : holder) + " is " + work +
                  "; wanted one run at a time (end that one, or choose another --out-path)");
    }
    held_ = attempt == Attempt::kLocked;
    if (!held_ || isStillThere(path_, descriptor_)) break;
    close(descriptor_);  // the holder has just gone, and its file too
  }
  if (!held_) return;  // the words in it may be those of another run
  abandonedBy_ = contentOf(descriptor_);
  const std::string holder = thisProcess() + "\n";
  // For people to read; the lock holds without it, on a full disk too.
  if (ftruncate(descriptor_, 0) != 0) return;
  [[maybe_unused]] const ssize_t ignored = pwrite(descriptor_, holder.data(), holder.size(), 0);
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      held_(std::exchange(other.held_, false)),
      abandonedBy_(std::move(other.abandonedBy_)) {}

FileLock::~FileLock() {
  if (descriptor_ < 0) return;
  if (held_) unlink(path_.c_str());
  close(descriptor_);
}

}  // namespace fluidymation
