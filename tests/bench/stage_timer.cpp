#include "bench/stage_timer.h"

#include <cassert>

namespace fluidymation::bench {
namespace {

StageOfLevel timedStage(Stage stage, int level) {
  switch (stage) {
    case Stage::kLevels:
      return {TimedStage::kLevels, kNoLevel};
    case Stage::kShift:
      return {TimedStage::kShift, kNoLevel};
    case Stage::kPaint:
      return {TimedStage::kPaint, kNoLevel};
    case Stage::kUpscale:
      return {TimedStage::kUpscale, level};
    case Stage::kPrevious:
      return {TimedStage::kPrevious, level};
    case Stage::kMerge:
      return {TimedStage::kMerge, level};
    case Stage::kRepair:
      return {TimedStage::kRepair, level};
    case Stage::kVote:
      return {TimedStage::kVote, level};
    case Stage::kSearch:
      return {TimedStage::kSearch, level};
  }
  assert(false);
  return {TimedStage::kOther, kNoLevel};
}

}  // namespace

void StageTimer::begins(Stage /*stage*/, int /*level*/) { stopwatch_ = Stopwatch(); }

void StageTimer::ends(Stage stage, int level) {
  clock_.add(timedStage(stage, level), stopwatch_.elapsed());
}

void StageTimer::searched(int level, const SearchStatistics& done) {
  Cost cost;
  cost.distances = static_cast<double>(done.distances);
  cost.samples = static_cast<double>(done.samples);
  clock_.add(timedStage(Stage::kSearch, level), cost);
}

}  // namespace fluidymation::bench
