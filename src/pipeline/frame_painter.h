#pragma once

#include <vector>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/bidirectional_painter.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "pipeline/frame_line.h"

namespace fluidymation {

/// Has frames painted, forwards or in both directions of time, and keeps of each what is written.
class FramePainter {
 public:
  /// @param synthesizer  must outlive this.
  /// @param wanted      frames that are written.
  /// @param frameCount  of the whole target.
  /// @param dumps  whether guides and matches are written, too: those of whole frames.
  FramePainter(Synthesizer& synthesizer, TemporalCoherence coherence, FrameSpan wanted,
               int frameCount, bool dumps)
      : synthesizer_(synthesizer),
        bidirectional_(synthesizer),
        coherence_(coherence),
        wanted_(wanted),
        frameCount_(frameCount),
        dumps_(dumps) {}

  /// Frames that have to be painted: to the end of the window that the last wanted one lies in.
  [[nodiscard]] FrameSpan painted() const;

  /// The stage `paint` of FrameStages: gives the wanted ones of the frames that are finished.
  [[nodiscard]] std::vector<PaintedFrame> paint(int frame, GuidePart guides);

 private:
  [[nodiscard]] PaintedFrame paintForward(GuidePart guides);
  [[nodiscard]] std::vector<PaintedFrame> paintBidirectionally(GuidePart guides, bool endsHere);

  Synthesizer& synthesizer_;
  BidirectionalPainter bidirectional_;
  TemporalCoherence coherence_;
  FrameSpan wanted_;
  int frameCount_;
  bool dumps_;
  std::vector<GuideFrame> waiting_;  ///< guides to be dumped of frames that are not finished
};

}  // namespace fluidymation
