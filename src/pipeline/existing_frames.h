#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "checkpoint/replaceable_frames.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"
#include "pipeline/starting_point.h"

namespace fluidymation {

/// Frames that may be replaced only by the same bytes, by their place in the sequence.
using DoubtfulFrames = std::set<int>;

/// What a run may replace.
struct OwnFrames {
  DoubtfulFrames doubtful;
  /// Of files to be replaced, as they are; and what is known of frames that are not going to be
  /// painted, and that the run's manifest will not tell of.
  FrameDigests replaceable;
  /// Whether a run that is stopped needs that to go on: an older one has left frames, or knew some.
  bool recorded = false;
};

/// Makes sure that a run replaces no picture that somebody else has made, or has worked on: files
/// with names of frames that are going to be painted must be as the manifest beside them says, or
/// as a run that was stopped while it replaced them has recorded; but for those that `--restart`
/// finds where a run was stopped. ExistingFrames::kReplace replaces anything.
/// @param beforeEach  called before each file that is read.
/// @return  doubtful are frames that nothing tells of where the run goes on from a state, or with
///   `--resume` where one was stopped before it saved one. What was written after the last state
///   is not recorded unless it replaced something; the same run paints the same bytes once more,
///   see `requireSame`.
/// @throws Error naming the first file that must not be replaced and how many there are.
[[nodiscard]] OwnFrames requireOwnFrames(const ContinuationOptions& options, const RunIdentity& run,
                                         const StartingPoint& start,
                                         const std::function<void()>& beforeEach);

/// @param digest  of what is going to be written there.
/// @param waysOut  as `ContinuationOptions` has them.
/// @throws Error naming the file where there is one with other bytes.
void requireSame(const std::string& path, const Digest& digest, const std::string& waysOut);

/// For ExistingFrames::kKeep: runs that paint the frames that are wanted and not there, those that
/// follow one another together. None where all are there.
/// @param observer  is told how many are kept.
/// @throws Error, UsageError as `validate`, `findFrames` and `wantedFrames`.
[[nodiscard]] std::vector<Options> runsForMissingFrames(const Options& given,
                                                        const Observer& observer);

}  // namespace fluidymation
