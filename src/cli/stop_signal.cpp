#include "cli/stop_signal.h"

#include <array>
#include <atomic>
#include <csignal>

namespace fluidymation::cli {
namespace {

constexpr std::array<int, 3> kStopSignals = {SIGINT, SIGTERM, SIGHUP};

// Any thread may receive the signal, and a handler must not wait for a lock.
std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void rememberSignal(int number) {
  received.store(number);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  // A closed terminal is told of twice: by the kernel and by the shell.
  std::signal(SIGHUP, SIG_IGN);
}

}  // namespace

void listenForStopSignals() {
  for (const int signal : kStopSignals) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = rememberSignal;
    action.sa_flags = SA_RESTART;  // a write to the disk goes on
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

int receivedStopSignal() { return received.load(); }

}  // namespace fluidymation::cli
