#pragma once

#include <omp.h>

#include <exception>
#include <mutex>

namespace fluidymation {

/// Runs `body(i)` for i in [0, count) on all threads of the current OpenMP setting, `chunk`
/// indices at a time, or on the first `workers` of them. A body writes only what belongs to its own
/// index, so that the result cannot depend on the number of threads. The first exception is carried
/// out of the region.
template <typename Body>
void parallelFor(int count, int chunk, const Body& body, int workers = omp_get_max_threads()) {
  std::exception_ptr failure;
  std::mutex failureMutex;
#pragma omp parallel for schedule(dynamic, chunk) num_threads(workers) default(none) \
    shared(count, chunk, body, failure, failureMutex)
  for (int i = 0; i < count; ++i) {
    try {
      body(i);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(failureMutex);
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

/// `parallelFor` over the rows of an image.
template <typename Body>
void forEachRow(int rows, const Body& body) {
  constexpr int kRowsAtATime = 8;  // enough work to hide the scheduling, small enough to balance
  parallelFor(rows, kRowsAtATime, body);
}

/// Number of the calling thread within a parallel loop, and how many there can be: for scratch
/// memory of a thread's own, never for anything that shows in a result.
[[nodiscard]] inline int threadIndex() { return omp_get_thread_num(); }
[[nodiscard]] inline int threadLimit() { return omp_get_max_threads(); }

}  // namespace fluidymation
