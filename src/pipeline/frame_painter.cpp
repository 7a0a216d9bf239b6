#include "pipeline/frame_painter.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "fluidymation/core/box.h"

namespace fluidymation {
namespace {

/// The whole frame of a painting; of its guides only what is always written.
PaintedFrame wholeFrame(const Painting& painting, bool withMatches) {
  const Size size = painting.state.size;
  const auto whole = [&](const auto& part) {
    return recropped(part, painting.state.box, {0, 0, size.width, size.height});
  };
  PaintedFrame frame;
  frame.picture = whole(painting.picture);
  frame.guides.mask = whole(painting.guides.mask);
  if (!painting.guides.coverage.empty()) frame.guides.coverage = whole(painting.guides.coverage);
  if (withMatches) frame.nnf = whole(painting.state.nnf);
  return frame;
}

}  // namespace

FrameSpan FramePainter::painted() const {
  if (coherence_ == TemporalCoherence::kForward) return wanted_;
  const int windows = (wanted_.end + kWindowFrames - 1) / kWindowFrames;
  return {wanted_.begin, std::min(windows * kWindowFrames, frameCount_)};
}

std::vector<PaintedFrame> FramePainter::paint(int frame, GuideFrame guides) {
  if (coherence_ == TemporalCoherence::kBidirectional) {
    return paintBidirectionally(std::move(guides), frame + 1 == frameCount_);
  }
  std::vector<PaintedFrame> painted;
  painted.push_back(paintForward(std::move(guides)));
  return painted;
}

PaintedFrame FramePainter::paintForward(GuideFrame guides) {
  PaintedFrame painted;
  if (dumps_) {
    painted.picture = synthesizer_.paint(guides);
    painted.guides = std::move(guides);
    painted.nnf = synthesizer_.nnf();
  } else {
    painted.guides.mask = guides.mask.clone();
    painted.guides.coverage = guides.coverage.clone();
    painted.picture = synthesizer_.paint(std::move(guides));
  }
  painted.state = std::make_shared<const SynthesisState>(synthesizer_.state());
  return painted;
}

std::vector<PaintedFrame> FramePainter::paintBidirectionally(GuideFrame guides, bool endsHere) {
  std::vector<PaintedFrame> finished;
  std::vector<Painting> window = bidirectional_.paint(guides, endsHere);
  if (dumps_) waiting_.push_back(std::move(guides));
  for (std::size_t i = 0; i < window.size() && window[i].state.frame <= wanted_.end; ++i) {
    finished.push_back(wholeFrame(window[i], dumps_));
    finished.back().state = std::move(window[i].forward);
    if (dumps_) finished.back().guides = std::move(waiting_[i]);
    window[i] = {};
  }
  if (!window.empty()) waiting_.clear();
  return finished;
}

}  // namespace fluidymation
