#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>

namespace fluidymation {

/// A thread beside the caller's that does one job after the other, in the order they were given.
class Worker {
 public:
  /// @param loopThreads  OpenMP's threads for the parallel loops of its jobs, itself among them.
  /// @throws std::system_error when the system gives no more threads.
  explicit Worker(int loopThreads);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Waits for the job at work; those behind it are dropped.
  ~Worker();

  /// Hands over `job`, which has to be movable. What it returns or throws comes out of the future.
  template <typename Job>
  [[nodiscard]] std::future<std::invoke_result_t<Job>> start(Job job) {
    // std::function wants to be copied, which a task cannot be.
    const auto task =
        std::make_shared<std::packaged_task<std::invoke_result_t<Job>()>>(std::move(job));
    add([task] { (*task)(); });
    return task->get_future();
  }

 private:
  void add(std::function<void()> job);
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  bool over_ = false;
  std::thread thread_;  ///< last, so that all it looks at is there when it starts
};

}  // namespace fluidymation
