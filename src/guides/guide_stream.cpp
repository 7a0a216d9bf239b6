#include "fluidymation/guides/guide_stream.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "fluidymation/core/index.h"
#include "fluidymation/guides/accumulation.h"
#include "fluidymation/guides/direction.h"
#include "fluidymation/guides/drawn_lines.h"
#include "fluidymation/guides/flow_average.h"
#include "fluidymation/guides/motion.h"
#include "shape_change.h"

namespace fluidymation {
namespace {

/// The values inside the mask, in row order.
std::vector<Vec2> gather(const Mask& mask, const Image<Vec2>& image) {
  std::vector<Vec2> values;
  values.reserve(countInside(mask));
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    if (mask.data()[i] != 0) values.push_back(image.data()[i]);
  }
  return values;
}

/// The inverse of `gather`; zero outside.
Image<Vec2> scatter(const Mask& mask, const std::vector<Vec2>& values) {
  Image<Vec2> image(mask.size());
  auto value = values.begin();
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    if (mask.data()[i] != 0) image.data()[i] = *value++;
  }
  assert(value == values.end());
  return image;
}

}  // namespace

GuideStream::GuideStream(int frameCount, const MaskReader& readMask, const GuideOptions& options,
                         const FlowReader& readFlow, const ShapeWatch& watch)
    : shapeBlurRadiusPx_(options.shapeBlurRadiusPx) {
  assert(frameCount >= 1);
  std::vector<bool> edge;
  for (PackedShape& shape : readShapes(frameCount, readMask, options.mask, watch)) {
    const Mask mask = shape.mask();
    StoredFrame frame{std::move(shape), {}, {}, {}};
    frame.flow.resize(countInside(mask));  // zero, until the frame turns out to move
    frames_.push_back(std::move(frame));
    edge.push_back(hasEdge(mask));
  }

  if (readFlow) {
    takeFlow(readFlow);
  } else {
    deriveFlow(edge, options);
  }

  // Motion still to come, from the last frame backwards (§3.5)
  Mask nextMask = frames_.back().shape.mask();
  Image<Vec2> nextFlow = scatter(nextMask, frames_.back().flow);
  Image<Vec2> accumulated(nextMask.size());
  frames_.back().accBackward.resize(frames_.back().flow.size());
  for (int i = frameCount - 2; i >= 0; --i) {
    StoredFrame& frame = frames_[at(i)];
    Mask mask = frame.shape.mask();
    Image<Vec2> flow = scatter(mask, frame.flow);
    accumulated = accumulateBackward(accumulated, nextFlow, nextMask, flow, mask);
    frame.accBackward = gather(mask, accumulated);
    nextMask = std::move(mask);
    nextFlow = std::move(flow);
  }
}

void GuideStream::deriveFlow(const std::vector<bool>& hasEdge, const GuideOptions& options) {
  // Frames without an edge, empty and full ones, have stand-ins for distances: they end the
  // temporal window on both sides as the ends of the sequence do.
  for (int begin = 0; begin < frameCount(); ++begin) {
    if (!hasEdge[at(begin)]) continue;
    int end = begin + 1;
    while (end < frameCount() && hasEdge[at(end)]) ++end;
    computeFlow(begin, end, options);
    begin = end;
  }
}

void GuideStream::takeFlow(const FlowReader& readFlow) {
  Mask previousMask(frames_.front().shape.size());
  for (int i = 0; i < frameCount(); ++i) {
    Mask mask = frames_[at(i)].shape.mask();
    frames_[at(i)].flow = gather(mask, readFlow(i, previousMask));
    previousMask = std::move(mask);
  }
}

void GuideStream::computeFlow(int begin, int end, const GuideOptions& options) {
  if (end - begin < 2) return;  // a single frame does not move
  ShapeChanges changes(end - begin, options.timeBlurSigmaFrames,
                       [&](int i) { return frames_[at(begin + i)].shape.edgeDistance(); });
  for (int i = begin; i < end; ++i) {
    StoredFrame& frame = frames_[at(i)];
    const Mask mask = frame.shape.mask();
    const MotionField motion = motionField(mask, changes.at(i - begin), options.motionModel);
    frame.flow = gather(mask, motion.flow);
    frame.diffusion = motion.report;
  }
  if (options.flowBlurSigmaFrames > 0.0F) averageFlow(begin, end, options.flowBlurSigmaFrames);
}

void GuideStream::averageFlow(int begin, int end, float sigmaFrames) {
  FlowAverages averages(end - begin, sigmaFrames, [&](int i) {
    Mask mask = frames_[at(begin + i)].shape.mask();
    Image<Vec2> flow = scatter(mask, frames_[at(begin + i)].flow);
    return FlowAverages::MovingFrame{std::move(mask), std::move(flow)};
  });
  for (int i = begin; i < end; ++i) {
    const Image<Vec2> average = averages.at(i - begin);
    frames_[at(i)].flow = gather(frames_[at(i)].shape.mask(), average);
  }
}

bool GuideStream::anyInside() const {
  assert(nextFrame_ == 0);
  return std::any_of(frames_.begin(), frames_.end(),
                     [](const StoredFrame& frame) { return !frame.flow.empty(); });
}

bool GuideStream::drawsLines() const {
  assert(nextFrame_ == 0);
  DrawnLines lines;
  for (const StoredFrame& frame : frames_) {
    const Mask mask = frame.shape.mask();
    lines.add(mask, scatter(mask, frame.flow));
  }
  return lines.found();
}

GuideFrame GuideStream::next() {
  assert(nextFrame_ < frameCount());
  StoredFrame& stored = frames_[at(nextFrame_)];
  GuideFrame guides;
  stored.shape.addTo(guides);
  guides.flow = scatter(guides.mask, stored.flow);
  guides.accBackward = scatter(guides.mask, stored.accBackward);
  if (shapeBlurRadiusPx_) guides.shape = blurredMask(guides.mask, *shapeBlurRadiusPx_);
  stored.flow = {};  // given away, and not asked for again
  stored.accBackward = {};

  DirectionField direction = flowDirection(guides.mask, guides.flow, guides.distance, direction_);
  guides.direction = std::move(direction.direction);
  guides.diffusion = worse(stored.diffusion, direction.report);
  guides.accForward = nextFrame_ == 0 ? Image<Vec2>(guides.mask.size())
                                      : accumulateForward(accForward_, guides.flow, guides.mask);
  direction_ = guides.direction.clone();
  accForward_ = guides.accForward.clone();
  ++nextFrame_;
  return guides;
}

}  // namespace fluidymation
