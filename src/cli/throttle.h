#pragma once

#include <chrono>

namespace fluidymation::cli {

/// Keeps what happens often from being told more often than is of use. `Clock` as in <chrono>.
template <typename Clock = std::chrono::steady_clock>
class Throttle {
 public:
  /// @param pause  from the beginning to what is told first, and from there on.
  explicit Throttle(std::chrono::milliseconds pause) : pause_(pause), last_(Clock::now()) {}

  /// Whether it is time to tell something; then the next pause begins.
  [[nodiscard]] bool isDue() {
    const auto now = Clock::now();
    if (now - last_ < pause_) return false;
    last_ = now;
    return true;
  }

 private:
  std::chrono::milliseconds pause_;
  typename Clock::time_point last_;
};

}  // namespace fluidymation::cli
