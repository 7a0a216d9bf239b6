#pragma once

#include "fluidymation/synthesis/patchmatch.h"

namespace fluidymation {

/// What a frame is painted in, as far as it is worth measuring.
enum class Stage {
  kLevels,    ///< guides on all levels, cut to the box that is worked with
  kShift,     ///< the previous frame's matches, moved along the exemplar's time
  kUpscale,   ///< matches of the coarser level, enlarged
  kPrevious,  ///< shifted matches on the level, their picture and what it counts
  kMerge,     ///< the better of the two fields
  kRepair,
  kVote,
  kSearch,
  kPaint,  ///< the picture: votes, blended changes, restored detail
};

/// Is told, in the painting thread, what a Synthesizer does.
class StageObserver {
 public:
  StageObserver() = default;
  StageObserver(const StageObserver&) = delete;
  StageObserver& operator=(const StageObserver&) = delete;
  virtual ~StageObserver() = default;

  /// Stages do not overlap. `begins` may throw: then the frame is dropped, `ends` is not called,
  /// and the Synthesizer is of no use any more. `level` is 0 where a stage concerns all levels.
  virtual void begins(Stage stage, int level) = 0;
  virtual void ends(Stage stage, int level) = 0;
  virtual void searched(int level, const SearchStatistics& done) = 0;
};

}  // namespace fluidymation
