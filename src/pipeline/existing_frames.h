#pragma once

#include <functional>
#include <vector>

#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"
#include "pipeline/starting_point.h"

namespace fluidymation {

/// Makes sure that a run replaces no picture that somebody else has made, or has worked on: files
/// with names of frames that are going to be painted must be as the manifest beside them says. What
/// goes on from a state replaces what the run that left it had begun, as `--resume` and `--restart`
/// do where a run was stopped before it saved one; ExistingFrames::kReplace replaces anything.
/// @param beforeEach  called before each file that is read.
/// @throws Error naming the first such file and how many there are.
void requireOwnFrames(const ContinuationOptions& options, const RunIdentity& run,
                      const StartingPoint& start, const std::function<void()>& beforeEach);

/// For ExistingFrames::kKeep: runs that paint the frames that are wanted and not there, those that
/// follow one another together. None where all are there.
/// @param observer  is told how many are kept.
/// @throws Error, UsageError as `validate`, `findFrames` and `wantedFrames`.
[[nodiscard]] std::vector<Options> runsForMissingFrames(const Options& given,
                                                        const Observer& observer);

}  // namespace fluidymation
