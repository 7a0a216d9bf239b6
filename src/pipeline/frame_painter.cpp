#include "pipeline/frame_painter.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "fluidymation/core/frame_part.h"

namespace fluidymation {
namespace {

/// A finished frame of a window; of its guides only what is always written.
PaintedFrame finishedFrame(Painting painting, bool dumps) {
  PaintedFrame frame;
  frame.part = {painting.state.size, painting.state.box};
  frame.picture = std::move(painting.state.picture);
  frame.guides.mask = std::move(painting.guides.mask);
  frame.guides.coverage = std::move(painting.guides.coverage);
  if (dumps) frame.nnf = wholeFrame(painting.state.nnf, frame.part);
  frame.state = std::move(painting.forward);
  return frame;
}

/// What is dumped of a frame is all of it.
void showWhole(GuideFrame guides, PaintedFrame& frame) {
  frame.picture = wholeFrame(frame.picture, frame.part);
  frame.guides = std::move(guides);
  frame.part = FramePart::whole(frame.part.frame);
}

}  // namespace

FrameSpan FramePainter::painted() const {
  if (coherence_ == TemporalCoherence::kForward) return wanted_;
  const int windows = (wanted_.end + kWindowFrames - 1) / kWindowFrames;
  return {wanted_.begin, std::min(windows * kWindowFrames, frameCount_)};
}

std::vector<PaintedFrame> FramePainter::paint(int frame, GuidePart guides) {
  if (coherence_ == TemporalCoherence::kBidirectional) {
    return paintBidirectionally(std::move(guides), frame + 1 == frameCount_);
  }
  std::vector<PaintedFrame> painted;
  painted.push_back(paintForward(std::move(guides)));
  return painted;
}

PaintedFrame FramePainter::paintForward(GuidePart guides) {
  PaintedFrame painted;
  const auto paint = [&](auto&& part) {
    synthesizer_.paint(std::forward<decltype(part)>(part));
    painted.part = synthesizer_.part();
    painted.picture = synthesizer_.picture().clone();
  };
  if (dumps_) {
    paint(guides);
    showWhole(std::move(guides.guides), painted);
    painted.nnf = synthesizer_.nnf();
  } else {
    paint(std::move(guides));
    painted.guides.mask = synthesizer_.guides().mask.clone();
    painted.guides.coverage = synthesizer_.guides().coverage.clone();
  }
  painted.state = std::make_shared<const SynthesisState>(synthesizer_.state());
  return painted;
}

std::vector<PaintedFrame> FramePainter::paintBidirectionally(GuidePart guides, bool endsHere) {
  std::vector<PaintedFrame> finished;
  std::vector<Painting> window = bidirectional_.paint(guides, endsHere);
  if (dumps_) waiting_.push_back(std::move(guides.guides));
  for (std::size_t i = 0; i < window.size() && window[i].state.frame <= wanted_.end; ++i) {
    finished.push_back(finishedFrame(std::move(window[i]), dumps_));
    if (dumps_) showWhole(std::move(waiting_[i]), finished.back());
  }
  if (!window.empty()) waiting_.clear();
  return finished;
}

}  // namespace fluidymation
