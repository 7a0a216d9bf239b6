#include "pipeline/worker.h"

#include <omp.h>

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace fluidymation {
namespace {

/// The caller's thread comes first: its loops end when the last of their threads does, and what a
/// worker takes from one of them all wait for. So its jobs fill the gaps that the loops leave.
void giveWay() {
#ifdef __linux__  // where each thread has a priority of its own; threads started from here take it
                  // over
  constexpr int kNicer = 10;  // a tenth of the weight
  const int priority = getpriority(PRIO_PROCESS, 0);
  setpriority(PRIO_PROCESS, 0, priority + kNicer);
#endif
}

}  // namespace

Worker::Worker(int loopThreads)
    : thread_([this, loopThreads] {
        omp_set_num_threads(loopThreads);  // of this thread only
        giveWay();
        work();
      }) {}

Worker::~Worker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Worker::add(std::function<void()> job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  changed_.notify_one();
}

void Worker::work() {
  for (;;) {
    std::function<void()> job;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return over_ || !jobs_.empty(); });
      if (over_) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
  }
}

}  // namespace fluidymation
