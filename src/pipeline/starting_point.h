#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint/checkpoint.h"
#include "checkpoint/run_files.h"
#include "fluidymation/options.h"
#include "pipeline/frame_line.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// What a run of a target is.
struct RunIdentity {
  RunFiles files;
  std::vector<int> numbers;             ///< of the target's frames, the user's own
  std::vector<std::string> framePaths;  ///< likewise, to be written
  Fingerprint fingerprint;
  CheckpointLimits limits;

  [[nodiscard]] int frameCount() const { return static_cast<int>(numbers.size()); }
};

/// @param outPaths    frames to be written, one for each of the target's.
/// @param beforeEach  called before each input file that is read.
[[nodiscard]] RunIdentity identityOf(const Options& options, const Inputs& inputs,
                                     const std::vector<std::string>& outPaths,
                                     const std::function<void()>& beforeEach);

/// Where a run begins.
struct StartingPoint {
  FrameSpan span;                       ///< frames to paint; empty where all are there already
  int chainBegin = 0;                   ///< of the run's checkpoints, see `Checkpoint::begin`
  FrameRecords known;                   ///< frames that are painted already
  std::optional<SynthesisState> state;  ///< to go on from; none: the first frame starts afresh
  std::string statePath;  ///< its file, where it is one that this run replaces by newer ones
  std::string note;       ///< one sentence for the user; may be empty
};

/// Whether a run over frames `wanted` is one over the whole target.
[[nodiscard]] bool isWhole(FrameSpan wanted, const RunIdentity& run);

/// Frames that `--render-frames` asks for, else all.
/// @throws UsageError naming the option and the target's frames unless both ends are among them.
[[nodiscard]] FrameSpan wantedFrames(const Options& options, const std::vector<int>& numbers);

/// Finds out what there is to do, from the options and from what other runs have left. Changes
/// nothing on the disk.
/// @param beforeEach  called before each file that is read.
/// @throws Error naming file and reason where the user wants to go on and that is not possible: the
///   state is damaged or of another run, or frames before it have changed since; also where the
///   user does not say whether to go on after a run that was stopped.
[[nodiscard]] StartingPoint findStart(const ContinuationOptions& options, FrameSpan wanted,
                                      const RunIdentity& run,
                                      const std::function<void()>& beforeEach);

}  // namespace fluidymation
