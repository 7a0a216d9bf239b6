#pragma once

namespace fluidymation {

/// OpenMP's thread count while a run lasts; the caller's own afterwards.
class ThreadCount {
 public:
  /// @throws Error naming --threads when the system does not give that many threads.
  explicit ThreadCount(int threads);
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;
  ~ThreadCount();

 private:
  int before_;
};

}  // namespace fluidymation
