#include "fluidymation/synthesis/bidirectional_painter.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace fluidymation {

std::vector<Painting> BidirectionalPainter::paint(const GuidePart& frame, bool endsHere) {
  if (window_.empty()) before_ = synthesizer_.painting();
  synthesizer_.paint(frame);
  // The frames of a hold are revised as one: none can go on amid them.
  if (synthesizer_.held() && !window_.empty()) window_.back().forward = nullptr;
  window_.push_back(synthesizer_.painting());
  window_.back().forward = std::make_shared<const SynthesisState>(window_.back().state.clone());
  const bool isFull = window_.back().state.frame % kWindowFrames == 0;
  if (!isFull && !endsHere) return {};
  revise();
  return std::exchange(window_, {});
}

void BidirectionalPainter::revise() {
  // A hold is one frame shown several times: it is revised as its first one, by the frame after its
  // last one, and not at all where it goes beyond the window.
  std::size_t after = window_.size() - 1;
  while (after > 0 && window_[after].held) --after;
  while (after > 0) {
    std::size_t first = after - 1;
    while (first > 0 && window_[first].held) --first;
    if (window_[first].held) return;
    const Painting& before = first > 0 ? window_[first - 1] : before_;
    synthesizer_.revise(before, window_[after], window_[first]);
    for (std::size_t held = first + 1; held < after; ++held) {
      window_[held].state.picture = window_[first].state.picture.clone();
      window_[held].state.nnf = window_[first].state.nnf.clone();
      window_[held].state.owed = window_[first].state.owed.clone();
    }
    after = first;
  }
}

}  // namespace fluidymation
