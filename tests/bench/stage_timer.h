#pragma once

#include "bench/stage_clock.h"
#include "fluidymation/synthesis/stages.h"

namespace fluidymation::bench {

/// Adds what a Synthesizer does to a clock.
class StageTimer final : public StageObserver {
 public:
  /// @param clock  must outlive the timer.
  explicit StageTimer(StageClock& clock) : clock_(clock) {}

  void begins(Stage stage, int level) override;
  void ends(Stage stage, int level) override;
  void searched(int level, const SearchStatistics& done) override;

 private:
  StageClock& clock_;
  Stopwatch stopwatch_;  ///< of the stage that goes on
};

}  // namespace fluidymation::bench
