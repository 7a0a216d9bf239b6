#pragma once

#include <functional>

#include "fluidymation/pipeline.h"
#include "fluidymation/synthesis/stages.h"
#include "pipeline/run_journal.h"

namespace fluidymation {

/// Ends a run when its caller wants that, and says how far it came.
class Stopping {
 public:
  /// The observer must outlive this.
  Stopping(const Observer& observer, int frameCount)
      : observer_(observer), frameCount_(frameCount) {}

  /// @throws Interrupted when the caller wants no more.
  void check() const;

  /// So many of `count` frames are written.
  void setWritten(int frames, int count) {
    written_ = frames;
    frameCount_ = count;
  }

 private:
  const Observer& observer_;
  int frameCount_;
  int written_ = 0;
};

/// To be called before each frame of a stage in turn: asks whether to stop, and tells the observer
/// how far the stage has come. What it is given must outlive what it returns.
/// @throws Interrupted, when called.
[[nodiscard]] std::function<void()> countsReading(const Stopping& stopping,
                                                  const Observer& observer, ReadingStage stage,
                                                  int count);

/// Lets a frame be dropped at the beginning of any of its stages.
class StopAtStages : public StageObserver {
 public:
  /// `stopping` must outlive this.
  explicit StopAtStages(const Stopping& stopping) : stopping_(stopping) {}

  void begins(Stage /*stage*/, int /*level*/) override { stopping_.check(); }
  void ends(Stage /*stage*/, int /*level*/) override {}
  void searched(int /*level*/, const SearchStatistics& /*done*/) override {}

 private:
  const Stopping& stopping_;
};

/// Paints, and saves the state when that is stopped or fails.
/// @throws what `paint` throws; where that is Interrupted, with the way to go on.
void paintSavingState(RunJournal& journal, const std::function<void()>& paint);

}  // namespace fluidymation
