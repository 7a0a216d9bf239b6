#pragma once

#include <deque>
#include <functional>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// How many frames on either side enter an average: 2 sigma, rounded up, which are 3 for the
/// paper's 1.5 (P App. A).
[[nodiscard]] int flowAverageReach(float sigmaFrames);

/// Flows averaged over time (P App. A), for a run of frames that all have an edge: at each pixel of
/// a frame's mask the mean over the frames around whose masks hold the pixel, weighted by a
/// Gaussian. Asked for in the order of the frames; only the frames of one average exist at a time.
class FlowAverages {
 public:
  struct MovingFrame {
    Mask mask;
    Image<Vec2> flow;
  };
  using FrameOf = std::function<MovingFrame(int frame)>;  ///< as derived; asked for once, in order

  /// @param sigmaFrames  above 0.
  FlowAverages(int frameCount, float sigmaFrames, FrameOf frameOf);

  /// Average of `frame`; zero outside its mask.
  [[nodiscard]] Image<Vec2> at(int frame);

 private:
  /// Asks for the frames first..end-1, and forgets those before.
  void provide(int first, int end);

  int frameCount_;
  float sigmaFrames_;
  FrameOf frameOf_;
  int firstFrame_ = 0;
  std::deque<MovingFrame> frames_;  ///< firstFrame_, firstFrame_ + 1, ...
};

}  // namespace fluidymation
