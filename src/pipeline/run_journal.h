#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint/manifest.h"
#include "fluidymation/checkpoint_share.h"
#include "pipeline/starting_point.h"

namespace fluidymation {

/// What the first state is expected to take, before any was saved: the upper end of what the
/// horse's takes to be taken, encoded and written (docs/performance.md).
inline constexpr double kFirstSavingSeconds = 0.02;

/// When a state is due.
class CheckpointClock {
 public:
  using Seconds = std::chrono::duration<double>;

  /// @param every  frames from one state to the next; none: as `kCheckpointShare` allows.
  explicit CheckpointClock(std::optional<int> every) : every_(every) {}

  /// @param framesSince  frames written since the last state, this one included.
  /// @param elapsed      since painting began.
  [[nodiscard]] bool isDue(int framesSince, Seconds elapsed) const;

  /// A state has been saved, which took so long.
  void saved(Seconds duration);

 private:
  std::optional<int> every_;
  Seconds total_{0.0};
  Seconds last_{kFirstSavingSeconds};
};

/// Keeps what a run knows of itself on the disk while it paints: states to go on from, and the
/// manifest. Belongs to the stage that writes.
class RunJournal {
 public:
  RunJournal(RunIdentity run, FrameSpan wanted, const StartingPoint& start,
             std::vector<std::pair<std::string, std::string>> paths,
             const ContinuationOptions& options);

  /// Forgets states that no run can go on from any more, where all frames are painted anew; those
  /// of the part that is painted anew where the user restarts a part.
  void discardOldStates() const;

  /// A frame is on the disk; frames come in order.
  /// @param state  as after this frame; none where no run can go on after it.
  /// @throws Error naming a file that cannot be written.
  void frameWritten(int frame, const Digest& digest, std::shared_ptr<const SynthesisState> state);

  /// Saves the state after the last frame that has one, unless it is saved already.
  /// @return  whether there is a state on the disk that a run can go on from.
  /// @throws Error naming a file that cannot be written.
  bool save();

  /// All frames wanted are written.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void writeManifest(bool complete) const;
  /// Once the state of `path` is safe, the one before it is not needed.
  void replaceState(const std::string& path);

  RunIdentity run_;
  FrameSpan wanted_;
  int chainBegin_;
  FrameRecords frames_;
  std::vector<std::pair<std::string, std::string>> paths_;
  bool keepStates_;
  bool startsAnew_;
  bool restarts_;
  std::string statePath_;  ///< of the state on the disk that belongs to this run; may be empty
  std::shared_ptr<const SynthesisState> latest_;  ///< still to be saved; may be none
  CheckpointClock clock_;
  int framesSince_ = 0;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point lastWritten_ = begun_;
};

}  // namespace fluidymation
