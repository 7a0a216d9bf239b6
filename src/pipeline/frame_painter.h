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
  /// @param end    number of the frame behind the last one to be painted.
  /// @param dumps  whether guides and matches are written, too.
  FramePainter(Synthesizer& synthesizer, TemporalCoherence coherence, int end, bool dumps)
      : synthesizer_(synthesizer),
        bidirectional_(synthesizer),
        coherence_(coherence),
        end_(end),
        dumps_(dumps) {}

  /// The stage `paint` of FrameStages.
  [[nodiscard]] std::vector<PaintedFrame> paint(int frame, GuideFrame guides);

 private:
  [[nodiscard]] PaintedFrame paintForward(GuideFrame guides);
  [[nodiscard]] std::vector<PaintedFrame> paintBidirectionally(GuideFrame guides, bool endsHere);

  Synthesizer& synthesizer_;
  BidirectionalPainter bidirectional_;
  TemporalCoherence coherence_;
  int end_;
  bool dumps_;
  std::vector<GuideFrame> waiting_;  ///< guides to be dumped of frames that are not finished
};

}  // namespace fluidymation
