#include "cli/stop_signal.h"

#include <array>
#include <atomic>
#include <csignal>

namespace fluidymation::cli {
namespace {

constexpr std::array<int, 2> kStopSignals = {SIGINT, SIGTERM};

// Any thread may receive the signal, and a handler must not wait for a lock.
std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void rememberSignal(int number) {
  received.store(number);
  for (const int signal : kStopSignals) std::signal(signal, SIG_DFL);
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
