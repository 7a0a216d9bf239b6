#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/frame_part.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/synthesis_state.h"

namespace fluidymation {

/// A painted frame on its way to the disk.
struct PaintedFrame {
  FramePart part;  ///< what picture and guides show: all that is painted of the frame
  Image<Lab> picture;
  GuideFrame guides;                        ///< mask and coverage; everything where it is dumped
  std::optional<NearestNeighborField> nnf;  ///< where it is dumped, of the whole frame
  /// What is needed to go on after this frame; none where that is not possible.
  std::shared_ptr<const SynthesisState> state;
};

/// Frames of a target, counted from 0.
struct FrameSpan {
  int begin = 0;
  int end = 0;  ///< behind the last one
};

/// What is done with each frame of a target. Each stage gets the frames in order, one at a time.
struct FrameStages {
  std::function<GuidePart(int frame)> guide;
  /// @return  the frames that are finished by this one, in order; they may be fewer in all than
  ///   are painted.
  std::function<std::vector<PaintedFrame>(int frame, GuidePart guides)> paint;
  std::function<void(int frame, const PaintedFrame& painted)> write;
};

/// What the caller wants to hear; called from its own thread, for each frame in order.
struct FrameEvents {
  /// Before a frame is painted; may throw to stop.
  std::function<void(int frame)> begins;
  /// The frame is finished, all before it are written and told of.
  std::function<void(int frame)> painted;
  /// The frame is written, `seconds` after the one before it was, or after painting began.
  std::function<void(int frame, double seconds)> written;
};

/// Threads of a run: of the search and of what goes on beside it.
struct ThreadShares {
  int paint = 1;  ///< for the parallel loops of the stage `paint`, the caller's thread among them
  int guide = 0;  ///< likewise, in a thread beside the caller's; 0: nothing goes on beside
  int write = 0;  ///< likewise

  /// Threads besides those of `paint`.
  [[nodiscard]] int beside() const { return guide + write; }
};

/// How a run with so many threads is shared out. Guides and files are little work next to the
/// search; they fill what it leaves of the processors where its threads wait for each other. The
/// guides of a frame are a small part of its work and many short loops: a quarter of the threads
/// lets them keep up, and where that is one, no loop of theirs waits for a second thread that the
/// search keeps busy (docs/performance.md).
[[nodiscard]] ThreadShares shareThreads(int threads);

/// Takes the frames of `span` through all stages. `paint` runs in the caller's thread. With
/// threads beside it, the guides of the next frame are made and the frame before is written
/// meanwhile; at any time there is at most one frame in each stage and one between `guide` and
/// `paint`. Without, nothing is done before it is wanted: one stage after the other.
///
/// However it ends, no stage is at work afterwards, and every frame that was painted, and
/// told to be, before the fault is written and told of. The fault of the earliest frame is the one
/// that comes out.
/// @throws whatever stages and events throw; std::system_error when a thread cannot be started.
void runFrames(FrameSpan span, const FrameStages& stages, const ThreadShares& threads,
               const FrameEvents& events);

}  // namespace fluidymation
