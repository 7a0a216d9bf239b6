#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "fluidymation/core/image.h"
#include "fluidymation/guides/motion.h"
#include "fluidymation/guides/temporal_smoothing.h"

namespace fluidymation {

/// What the shapes of a run of frames, all of which have an edge, say about their movement. Asked
/// for in the order of the frames; only the distance fields that the temporal kernel reaches exist
/// at a time.
class ShapeChanges {
 public:
  struct Shape {
    Mask mask;
    Image<float> distance;  ///< `continuousDistance` or `outlineDistance`
  };
  /// Asked for at most once, in order; frames count from the beginning of the run.
  using ShapeOf = std::function<Shape(int frame)>;

  /// Whether a frame has the shape of the one before it, which is then not asked for anew.
  using Repeats = std::function<bool(int frame)>;

  /// @param frameCount  of the run, >= 2.
  ShapeChanges(
      int frameCount, float sigmaFrames, ShapeOf shapeOf,
      Repeats repeats = [](int) { return false; });

  /// The change that leads to `frame`; the first frame moves as it does towards the second. Valid
  /// until the next call.
  [[nodiscard]] ShapeChange at(int frame);

 private:
  struct MeasuredShape {
    std::vector<float> thicknesses;
    Image<float> field;
  };

  [[nodiscard]] const MeasuredShape& shape(int frame) const;
  /// Measures the frames first..end-1, and forgets those before.
  void provide(int first, int end);

  int frameCount_;
  float sigmaFrames_;
  ShapeOf shapeOf_;
  Repeats repeats_;
  int firstShape_ = 0;
  std::deque<MeasuredShape> shapes_;  ///< of frames firstShape_, firstShape_ + 1, ...
};

}  // namespace fluidymation
