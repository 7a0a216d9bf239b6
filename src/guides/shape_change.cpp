#include "shape_change.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

int endOf(const TemporalWeights& window) {
  return window.firstFrame + static_cast<int>(window.weights.size());
}

}  // namespace

ShapeChanges::ShapeChanges(int frameCount, float sigmaFrames, ShapeOf shapeOf, Repeats repeats)
    : frameCount_(frameCount),
      sigmaFrames_(sigmaFrames),
      shapeOf_(std::move(shapeOf)),
      repeats_(std::move(repeats)) {}

ShapeChange ShapeChanges::at(int frame) {
  const TemporalWeights window = temporalWeights(frame, frameCount_, sigmaFrames_);
  const TemporalWeights steps = stepWeights(std::max(frame, 1), frameCount_, sigmaFrames_);
  provide(std::min(window.firstFrame, steps.firstFrame), std::max(endOf(window), endOf(steps) + 1));
  ShapeChange change{shape(frame).thicknesses, {}, {}, steps.weights};
  for (int i = window.firstFrame; i < endOf(window); ++i) {
    const auto place = static_cast<std::size_t>(i - window.firstFrame);
    change.smooth.push_back({&shape(i).field, window.weights[place]});
  }
  for (int i = steps.firstFrame; i <= endOf(steps); ++i) change.fields.push_back(&shape(i).field);
  return change;
}

const ShapeChanges::MeasuredShape& ShapeChanges::shape(int frame) const {
  return shapes_[static_cast<std::size_t>(frame - firstShape_)];
}

void ShapeChanges::provide(int first, int end) {
  for (; firstShape_ < first; ++firstShape_) shapes_.pop_front();
  while (firstShape_ + static_cast<int>(shapes_.size()) < end) {
    const int frame = firstShape_ + static_cast<int>(shapes_.size());
    if (!shapes_.empty() && repeats_(frame)) {
      shapes_.push_back({shapes_.back().thicknesses, shapes_.back().field.clone()});
      continue;
    }
    const Shape shape = shapeOf_(frame);
    shapes_.push_back({partThicknesses(shape.mask, shape.distance),
                       gaussianBlur(shape.distance, kStaircaseSigmaPx)});
  }
}

}  // namespace fluidymation
