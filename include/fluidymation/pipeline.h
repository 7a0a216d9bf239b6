#pragma once

#include <functional>
#include <string>

#include "fluidymation/options.h"

namespace fluidymation {

/// A target frame that has been painted and written.
struct FrameReport {
  int index = 0;          ///< in the order of painting; 0 for the first frame of the sequence
  int count = 0;          ///< frames of the sequence; with --render-frames, up to the last of these
  int frameNumber = 0;    ///< the user's own number
  double seconds = 0.0;   ///< since the frame before was written, or painting began
  std::string path;       ///< the file written
  bool reversed = false;  ///< whether frames come from the last to the first (--reverse)
};

/// What is gone through before the first frame can be painted.
enum class ReadingStage {
  kFilmMasks,
  kFilmMovement,
  kTargetMasks,
  kTargetMovement,
};

/// So many of the frames of a stage are done.
struct ReadingReport {
  ReadingStage stage = ReadingStage::kFilmMasks;
  int done = 0;
  int count = 0;
};

/// How the engine speaks and listens while it works; all are called from the thread that called
/// `stylize`, and any may be empty.
struct Observer {
  std::function<void(const std::string&)> note;  ///< one sentence for the user
  /// A frame is written. With more than one thread the next one may be painted by then.
  std::function<void(const FrameReport&)> frameDone;
  /// Whether to stop. Asked often; a frame at work is dropped then, and no file half written.
  std::function<bool()> cancelled;
  /// All masks and the exemplar are read, and the first frame (its number from 0 in the sequence)
  /// of so many is begun.
  std::function<void(int frame, int frameCount)> paintingBegins;
  /// Something of the inputs is read, long before painting begins where they are long. Called for
  /// each frame of each stage.
  std::function<void(const ReadingReport&)> reading;
};

/// Validates the options and checks every input, then paints every target frame and writes it, on
/// `given.threads` threads. Keeps a manifest and states beside the frames, and goes on from such a
/// state where `given.continuation` says so. Leaves OpenMP's setting as it was. Widths that are not
/// given are chosen by the sizes of film and animation (automatic.h).
/// @throws Interrupted when `observer.cancelled` asked for it, after the state is saved; Error,
/// UsageError for options that `validate` refuses; prints nothing.
void stylize(const Options& given, const Observer& observer);

}  // namespace fluidymation
