#include "pipeline/thread_count.h"

#include <omp.h>

#include <condition_variable>
#include <mutex>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

/// Threads that do nothing but exist until the end of their group.
class IdleThreads {
 public:
  IdleThreads() = default;
  IdleThreads(const IdleThreads&) = delete;
  IdleThreads& operator=(const IdleThreads&) = delete;
  ~IdleThreads() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      over_ = true;
    }
    end_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// @throws std::system_error, std::bad_alloc when there can be no more.
  void add() {
    threads_.emplace_back([this] {
      std::unique_lock<std::mutex> lock(mutex_);
      end_.wait(lock, [this] { return over_; });
    });
  }

  [[nodiscard]] std::size_t count() const { return threads_.size(); }

 private:
  std::mutex mutex_;
  std::condition_variable end_;
  bool over_ = false;
  std::vector<std::thread> threads_;
};

/// OpenMP's runtime ends the program when it cannot start a thread (a limit on processes or on
/// address space), so they are all started once before.
void requireThreads(int threads, int beside) {
  IdleThreads idle;
  std::string reason;
  try {
    const auto wanted = static_cast<std::size_t>(threads) + static_cast<std::size_t>(beside);
    while (idle.count() + 1 < wanted) idle.add();
    return;
  } catch (const std::system_error& failure) {
    reason = failure.code().message();
  } catch (const std::bad_alloc&) {
    reason = "out of memory";
  }
  throw Error("--threads " + std::to_string(threads) + ": only " +
              std::to_string(idle.count() + 1) + " can be started (" + reason +
              "); wanted fewer threads, or a higher limit of the system");
}

}  // namespace

ThreadCount::ThreadCount(int threads, int beside) : before_(omp_get_max_threads()) {
  requireThreads(threads, beside);
  omp_set_num_threads(threads);
}

ThreadCount::~ThreadCount() { omp_set_num_threads(before_); }

}  // namespace fluidymation
