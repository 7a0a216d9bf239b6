// Preloaded into a program (LD_PRELOAD), ends it by SIGKILL just before the call number
// FLUIDYMATION_KILL_AT (from 1) of those that change what is on the disk: as kill -9 would, or a
// machine that stops, at a moment that can be told. FLUIDYMATION_KILL_SIGNAL is the number of
// another signal to send instead.

#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace {

int numberIn(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

void count() {
  static std::atomic<int> calls{0};
  static const int wanted = numberIn("FLUIDYMATION_KILL_AT", 0);
  if (++calls == wanted) kill(getpid(), numberIn("FLUIDYMATION_KILL_SIGNAL", SIGKILL));
}

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int rename(const char* from, const char* to) noexcept {
  count();
  static const auto call = next<int (*)(const char*, const char*)>("rename");
  return call(from, to);
}

int fsync(int descriptor) {
  count();
  static const auto call = next<int (*)(int)>("fsync");
  return call(descriptor);
}

int remove(const char* path) noexcept {
  count();
  static const auto call = next<int (*)(const char*)>("remove");
  return call(path);
}

int unlink(const char* path) noexcept {
  count();
  static const auto call = next<int (*)(const char*)>("unlink");
  return call(path);
}

int mkdir(const char* path, unsigned mode) noexcept {
  count();
  static const auto call = next<int (*)(const char*, unsigned)>("mkdir");
  return call(path, mode);
}

}  // extern "C"
