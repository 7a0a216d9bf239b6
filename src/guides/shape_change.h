#pragma once

#include <deque>
#include <functional>

#include "fluidymation/core/image.h"
#include "fluidymation/guides/motion.h"
#include "fluidymation/guides/temporal_smoothing.h"

namespace fluidymation {

/// What the shapes of a run of frames, all of which have an edge, say about their movement. Asked
/// for in the order of the frames; only the distance fields that the temporal kernel reaches exist
/// at a time. A distance is asked for twice: for its field, and for its depth when its turn comes.
class ShapeChanges {
 public:
  /// `continuousDistance` or `outlineDistance`; frames count from the beginning of the run.
  using DistanceOf = std::function<Image<float>(int frame)>;

  /// @param frameCount  of the run, >= 2.
  ShapeChanges(int frameCount, float sigmaFrames, DistanceOf distanceOf);

  /// The change that leads to `frame`; the first frame moves as it does towards the second. Valid
  /// until the next call.
  [[nodiscard]] ShapeChange at(int frame);

 private:
  [[nodiscard]] const Image<float>& field(int frame) const;
  /// Makes the fields of frames first..end-1, and forgets those before.
  void provide(int first, int end);
  [[nodiscard]] Image<float> average(const TemporalWeights& window) const;

  int frameCount_;
  float sigmaFrames_;
  DistanceOf distanceOf_;
  int firstField_ = 0;
  std::deque<Image<float>> fields_;  ///< of frames firstField_, firstField_ + 1, ...
  Image<float> depth_;
  Image<float> smooth_;
};

}  // namespace fluidymation
