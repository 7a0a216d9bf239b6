#include "pipeline/film_window.h"

#include <algorithm>
#include <cstdint>

#include "fluidymation/synthesis/bidirectional_painter.h"

namespace fluidymation {

FilmWindow::FilmWindow(const Options& options, int filmFrames, int targetFrames)
    : heldFrames_(options.sourceWindowFrames == 0
                      ? filmFrames
                      : std::min(options.sourceWindowFrames, filmFrames)),
      filmFrames_(filmFrames),
      targetFramesPerStep_(
          options.synthesis.temporalCoherence == TemporalCoherence::kForward ? 1 : kWindowFrames),
      steps_((targetFrames + targetFramesPerStep_ - 1) / targetFramesPerStep_) {}

int FilmWindow::beginFor(int targetFrame) const {
  if (steps_ == 1) return 0;
  const std::int64_t last = filmFrames_ - heldFrames_;
  const std::int64_t step = targetFrame / targetFramesPerStep_;
  const std::int64_t lastStep = steps_ - 1;
  return static_cast<int>((step * last + lastStep / 2) / lastStep);  // rounded
}

}  // namespace fluidymation
