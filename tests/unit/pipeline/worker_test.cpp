#include "pipeline/worker.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace fluidymation {
namespace {

TEST(Worker, DoesItsJobsInOrderInOneOtherThread) {
  Worker worker(1);
  std::vector<int> order;
  std::vector<std::future<std::thread::id>> results;
  for (int i = 0; i < 100; ++i) {
    results.push_back(worker.start([&order, i] {
      order.push_back(i);
      return std::this_thread::get_id();
    }));
  }
  const std::thread::id first = results.front().get();
  EXPECT_NE(first, std::this_thread::get_id());
  for (std::size_t i = 1; i < results.size(); ++i) EXPECT_EQ(results[i].get(), first);
  ASSERT_EQ(order.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(Worker, GivesItsLoopsTheThreadsItWasToldAndLeavesTheCallersAlone) {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 3}) {
    Worker worker(threads);
    EXPECT_EQ(worker.start([] { return omp_get_max_threads(); }).get(), threads);
  }
  EXPECT_EQ(omp_get_max_threads(), before);
}

TEST(Worker, HandsOverWhatAJobThrowsAndGoesOn) {
  Worker worker(1);
  std::future<int> fault = worker.start([]() -> int { throw std::runtime_error("broken"); });
  EXPECT_THROW((void)fault.get(), std::runtime_error);
  EXPECT_EQ(worker.start([] { return 7; }).get(), 7);
}

TEST(Worker, TakesJobsThatCannotBeCopied) {
  Worker worker(1);
  auto owned = std::make_unique<int>(5);
  EXPECT_EQ(worker.start([owned = std::move(owned)] { return *owned; }).get(), 5);
}

TEST(Worker, WaitsForTheJobAtWorkWhenItEnds) {
  bool done = false;
  {
    Worker worker(1);
    std::promise<void> begun;
    std::future<void> beginning = begun.get_future();
    const std::future<void> ignored = worker.start([&] {
      begun.set_value();
      std::this_thread::yield();
      done = true;
    });
    beginning.get();
  }
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace fluidymation
