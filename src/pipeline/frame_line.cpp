#include "pipeline/frame_line.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <optional>
#include <utility>

#include "pipeline/worker.h"

namespace fluidymation {
namespace {

/// Makes guides one frame ahead of who takes them.
class GuidesAhead {
 public:
  GuidesAhead(FrameSpan span, const FrameStages& stages, int loopThreads)
      : end_(span.end), stages_(stages), next_(span.begin) {
    if (loopThreads > 0) worker_.emplace(loopThreads);
    beginNext();
  }

  /// Of the next frame. Not called more often than the span has frames.
  [[nodiscard]] GuidePart take() {
    if (!worker_) return stages_.guide(next_++);
    GuidePart guides = coming_.get();
    beginNext();
    return guides;
  }

 private:
  void beginNext() {
    if (!worker_ || next_ == end_) return;
    coming_ = worker_->start([this, frame = next_] { return stages_.guide(frame); });
    ++next_;
  }

  int end_;
  const FrameStages& stages_;
  int next_;
  std::future<GuidePart> coming_;
  std::optional<Worker> worker_;  ///< none where nothing goes on beside the caller
};

/// Writes one frame while others are made.
class WritingBehind {
 public:
  WritingBehind(const FrameStages& stages, const FrameEvents& events, int loopThreads)
      : stages_(stages), events_(events) {
    if (loopThreads > 0) worker_.emplace(loopThreads);
  }

  /// Begins to write a frame; none may be under way.
  void begin(int frame, PaintedFrame painted) {
    frame_ = frame;
    auto write = [this, frame, painted = std::move(painted)] {
      stages_.write(frame, painted);
      return Clock::now();
    };
    if (worker_) {
      going_ = worker_->start(std::move(write));
    } else {
      tell(write());
    }
  }

  /// Waits for the frame that is under way, if any, and tells of it.
  void finish() {
    if (!going_.valid()) return;
    tell(going_.get());
  }

 private:
  using Clock = std::chrono::steady_clock;

  void tell(Clock::time_point done) {
    const std::chrono::duration<double> spent = done - std::exchange(lastDone_, done);
    events_.written(frame_, spent.count());
  }

  const FrameStages& stages_;
  const FrameEvents& events_;
  Clock::time_point lastDone_ = Clock::now();
  int frame_ = 0;
  std::future<Clock::time_point> going_;
  std::optional<Worker> worker_;  ///< none where nothing goes on beside the caller
};

}  // namespace

ThreadShares shareThreads(int threads) {
  if (threads == 1) return {};
  return {threads, std::max(1, threads / 4), 1};
}

void runFrames(FrameSpan span, const FrameStages& stages, const ThreadShares& threads,
               const FrameEvents& events) {
  WritingBehind writing(stages, events, threads.write);
  GuidesAhead guides(span, stages, threads.guide);
  try {
    int finished = span.begin;
    for (int frame = span.begin; frame < span.end; ++frame) {
      events.begins(frame);
      for (PaintedFrame& painted : stages.paint(frame, guides.take())) {
        writing.finish();
        events.painted(finished);
        writing.begin(finished, std::move(painted));
        ++finished;
      }
    }
  } catch (...) {
    writing.finish();
    throw;
  }
  writing.finish();
}

}  // namespace fluidymation
