#include "shape_change.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

int endOf(const TemporalWeights& window) {
  return window.firstFrame + static_cast<int>(window.weights.size());
}

}  // namespace

ShapeChanges::ShapeChanges(int frameCount, float sigmaFrames, DistanceOf distanceOf)
    : frameCount_(frameCount), sigmaFrames_(sigmaFrames), distanceOf_(std::move(distanceOf)) {}

ShapeChange ShapeChanges::at(int frame) {
  const TemporalWeights window = temporalWeights(frame, frameCount_, sigmaFrames_);
  const TemporalWeights steps = stepWeights(std::max(frame, 1), frameCount_, sigmaFrames_);
  provide(std::min(window.firstFrame, steps.firstFrame), std::max(endOf(window), endOf(steps) + 1));
  depth_ = distanceOf_(frame);
  smooth_ = average(window);
  ShapeChange change{depth_, smooth_, {}, steps.weights};
  for (int i = steps.firstFrame; i <= endOf(steps); ++i) change.fields.push_back(&field(i));
  return change;
}

const Image<float>& ShapeChanges::field(int frame) const {
  return fields_[static_cast<std::size_t>(frame - firstField_)];
}

void ShapeChanges::provide(int first, int end) {
  for (; firstField_ < first; ++firstField_) fields_.pop_front();
  while (firstField_ + static_cast<int>(fields_.size()) < end) {
    const int frame = firstField_ + static_cast<int>(fields_.size());
    fields_.push_back(gaussianBlur(distanceOf_(frame), kStaircaseSigmaPx));
  }
}

Image<float> ShapeChanges::average(const TemporalWeights& window) const {
  Image<float> smooth(fields_.front().size());
  forEachRow(smooth.height(), [&](int y) {
    float* out = smooth.row(y);
    for (std::size_t i = 0; i < window.weights.size(); ++i) {
      const float weight = window.weights[i];
      const float* in = field(window.firstFrame + static_cast<int>(i)).row(y);
      for (int x = 0; x < smooth.width(); ++x) out[x] += weight * in[x];
    }
  });
  return smooth;
}

}  // namespace fluidymation
