#pragma once

#include <string>

#include "fluidymation/io/digest.h"
#include "pipeline/existing_frames.h"
#include "pipeline/starting_point.h"

namespace fluidymation {

/// Keeps on the disk what a run may replace, while it replaces it: its manifest tells of its own
/// frames only, and a run that is stopped has to know those of the run before again.
class FrameReplacement {
 public:
  /// @param run  has to last as long.
  /// @param span  frames that the run paints.
  /// @param waysOut  as `ContinuationOptions` has them.
  FrameReplacement(const RunIdentity& run, FrameSpan span, OwnFrames frames, std::string waysOut);

  /// Before anything of what an older run has left is changed. The hidden folder is there.
  /// @throws Error naming the file that cannot be written.
  void begin() const;

  /// Before a frame is written: a run that ends right after knows it for its own.
  /// @param digest  of what is going to be written.
  /// @throws Error naming a frame that must not be replaced, or the file that cannot be written.
  void beforeWriting(int frame, const Digest& digest) const;

  /// All frames of the run are painted, and the manifest tells of them: only what is known of other
  /// frames, which it does not tell of, stays. @throws Error naming the file.
  void finish() const;

 private:
  /// Writes the file, or removes it where there is nothing to write.
  void keep(const FrameDigests& frames) const;

  const RunIdentity& run_;
  FrameSpan span_;
  OwnFrames frames_;
  std::string waysOut_;
};

}  // namespace fluidymation
