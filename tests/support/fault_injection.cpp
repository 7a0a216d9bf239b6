// Preloaded into a program (LD_PRELOAD), makes the system fail as the environment says; a variable
// that is not there changes nothing.
//   FLUIDYMATION_FAULT_FILES     what a path contains for the next three to apply to writes to it
//   FLUIDYMATION_FAULT_ERROR     number of the error that writes fail with
//   FLUIDYMATION_FAULT_AFTER     bytes that can be written before they do (default 0)
//   FLUIDYMATION_FAULT_FLUSH     set: writes work, but fsync fails with that error
//   FLUIDYMATION_FAULT_SLOW_MS   milliseconds that each write and each fsync takes longer
//   FLUIDYMATION_FAULT_PAUSE     what a path contains that is opened or renamed to ...
//   FLUIDYMATION_FAULT_PAUSE_AT  ... for the how manyth time (from 1) for the program to pause
//   FLUIDYMATION_FAULT_FLAG      file that is made then; the program goes on when it is removed
//   FLUIDYMATION_FAULT_CLOCK     set: all clocks run backwards, ten times as fast
//   FLUIDYMATION_FAULT_LOCALE    locale that the program is put into; exit code 77 where it is not
//   there
// The program's files are written by stdio, whose own calls of write cannot be taken over: hence
// fwrite and fflush stand for it.

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <clocale>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

[[nodiscard]] const char* setting(const char* name) { return std::getenv(name); }

[[nodiscard]] int numberIn(const char* name) {
  const char* const text = setting(name);
  return text == nullptr ? 0 : std::atoi(text);
}

template <typename Function>
[[nodiscard]] Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

void sleepMs(int milliseconds) {
  constexpr int kMicroseconds = 1000;
  usleep(static_cast<useconds_t>(kMicroseconds * milliseconds));
}

/// Whether writes to this descriptor are meant; makes them slow where that is wanted.
[[nodiscard]] bool isMeant(int descriptor) {
  const char* const part = setting("FLUIDYMATION_FAULT_FILES");
  if (part == nullptr || descriptor < 0) return false;
  const int error = errno;
  std::array<char, 64> link{};
  std::array<char, 4096> path{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", descriptor);
  const bool found = readlink(link.data(), path.data(), path.size() - 1) > 0 &&
                     std::strstr(path.data(), part) != nullptr;
  if (found) sleepMs(numberIn("FLUIDYMATION_FAULT_SLOW_MS"));
  errno = error;
  return found;
}

/// Whether a write of so many bytes has to fail; errno says why.
[[nodiscard]] bool writeFails(int descriptor, std::size_t byteCount) {
  static std::atomic<std::size_t> written{0};
  if (!isMeant(descriptor) || setting("FLUIDYMATION_FAULT_FLUSH") != nullptr) return false;
  const int error = numberIn("FLUIDYMATION_FAULT_ERROR");
  const auto room = static_cast<std::size_t>(numberIn("FLUIDYMATION_FAULT_AFTER"));
  if (error == 0 || (written += byteCount) <= room) return false;
  errno = error;
  return true;
}

void pauseAt(const char* path) {
  static std::atomic<int> times{0};
  const char* const part = setting("FLUIDYMATION_FAULT_PAUSE");
  const char* const flag = setting("FLUIDYMATION_FAULT_FLAG");
  if (part == nullptr || flag == nullptr || std::strstr(path, part) == nullptr) return;
  if (++times != numberIn("FLUIDYMATION_FAULT_PAUSE_AT")) return;
  constexpr int kMode = 0666;
  constexpr int kLookEveryMs = 5;
  static const auto openFile = next<int (*)(const char*, int, ...)>("open");
  const int descriptor = openFile(flag, O_WRONLY | O_CREAT | O_CLOEXEC, kMode);
  if (descriptor >= 0) close(descriptor);
  while (access(flag, F_OK) == 0) sleepMs(kLookEveryMs);
}

/// Runs before the program's main.
__attribute__((constructor)) void enterLocale() {
  constexpr int kNoSuchLocale = 77;
  const char* const name = setting("FLUIDYMATION_FAULT_LOCALE");
  if (name != nullptr && std::setlocale(LC_ALL, name) == nullptr) _exit(kNoSuchLocale);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const auto mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : mode_t{0};
  va_end(arguments);
  pauseAt(path);
  static const auto call = next<int (*)(const char*, int, ...)>("open");
  return call(path, flags, mode);
}

int rename(const char* from, const char* to) noexcept {
  pauseAt(to);
  static const auto call = next<int (*)(const char*, const char*)>("rename");
  return call(from, to);
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* file) {
  if (writeFails(fileno(file), size * count)) return 0;
  static const auto call = next<size_t (*)(const void*, size_t, size_t, FILE*)>("fwrite");
  return call(data, size, count, file);
}

int fflush(FILE* file) {
  if (file != nullptr && writeFails(fileno(file), 0)) return EOF;
  static const auto call = next<int (*)(FILE*)>("fflush");
  return call(file);
}

ssize_t write(int descriptor, const void* data, size_t count) {
  if (writeFails(descriptor, count)) return -1;
  static const auto call = next<ssize_t (*)(int, const void*, size_t)>("write");
  return call(descriptor, data, count);
}

int fsync(int descriptor) {
  if (isMeant(descriptor) && setting("FLUIDYMATION_FAULT_FLUSH") != nullptr) {
    errno = numberIn("FLUIDYMATION_FAULT_ERROR");
    return -1;
  }
  static const auto call = next<int (*)(int)>("fsync");
  return call(descriptor);
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static const auto call = next<int (*)(clockid_t, timespec*)>("clock_gettime");
  const int result = call(clock, time);
  if (result != 0 || setting("FLUIDYMATION_FAULT_CLOCK") == nullptr) return result;
  constexpr long kNanoseconds = 1'000'000'000;
  constexpr time_t kFrom = 2'000'000'000;  // backwards from here, so that it stays positive
  const time_t since = time->tv_sec % 1'000'000;
  time->tv_sec = kFrom - 10 * since;
  time->tv_nsec = kNanoseconds - 1 - time->tv_nsec;
  return result;
}

}  // extern "C"
