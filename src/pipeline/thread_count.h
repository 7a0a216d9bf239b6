#pragma once

namespace fluidymation {

/// OpenMP's thread count while a run lasts; the caller's own afterwards.
class ThreadCount {
 public:
  /// @param beside  threads that the run starts besides those of OpenMP's loops.
  /// @throws Error naming --threads when the system does not give that many threads.
  explicit ThreadCount(int threads, int beside = 0);
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;
  ~ThreadCount();

 private:
  int before_;
};

}  // namespace fluidymation
