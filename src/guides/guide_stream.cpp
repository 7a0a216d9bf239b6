#include "fluidymation/guides/guide_stream.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "fluidymation/core/box.h"
#include "fluidymation/core/index.h"
#include "fluidymation/guides/accumulation.h"
#include "fluidymation/guides/direction.h"
#include "fluidymation/guides/drawn_lines.h"
#include "fluidymation/guides/flow_average.h"
#include "fluidymation/guides/gaussian.h"
#include "fluidymation/guides/motion.h"
#include "fluidymation/guides/packed_mask.h"
#include "shape_change.h"

namespace fluidymation {
namespace {

/// What the flow at a border pixel is made of beside it: the gradient's neighbours, smoothed by
/// `kStaircaseSigmaPx`.
int flowMarginPx() { return 1 + gaussianReach(kStaircaseSigmaPx); }

bool hasEdge(const PackedMask& mask) {
  const std::size_t inside = mask.count();
  return inside != 0 && inside != at(mask.size().width) * at(mask.size().height);
}

}  // namespace

GuideStream::GuideStream(int frameCount, const MaskReader& readMask, const GuideOptions& options,
                         const FlowReader& readFlow, const ShapeWatch& watch,
                         const std::function<void()>& beforeFlow)
    : shapeBlurRadiusPx_(options.shapeBlurRadiusPx) {
  assert(frameCount >= 1);
  std::vector<bool> edge;
  for (PackedShape& shape : readShapes(frameCount, readMask, options.mask, watch)) {
    edge.push_back(hasEdge(shape.packedMask()));
    const std::size_t inside = shape.packedMask().count();
    StoredFrame frame{std::move(shape), {}, {}, {}};
    frame.flow.resize(inside);  // zero, until the frame turns out to move
    frames_.push_back(std::move(frame));
  }

  if (readFlow) {
    takeFlow(readFlow);
  } else {
    deriveFlow(edge, options, beforeFlow);
  }

  // Motion still to come, from the last frame backwards (§3.5)
  frames_.back().accBackward.resize(frames_.back().flow.size());
  for (int i = frameCount - 2; i >= 0; --i) {
    const StoredFrame& next = frames_[at(i + 1)];
    StoredFrame& frame = frames_[at(i)];
    frame.accBackward = accumulateBackward(next.shape.packedMask(), next.accBackward, next.flow,
                                           frame.shape.packedMask(), frame.flow);
  }
}

void GuideStream::deriveFlow(const std::vector<bool>& edge, const GuideOptions& options,
                             const std::function<void()>& beforeFlow) {
  // Frames without an edge, empty and full ones, have stand-ins for distances: they end the
  // temporal window on both sides as the ends of the sequence do.
  for (int begin = 0; begin < frameCount(); ++begin) {
    if (!edge[at(begin)]) continue;
    int end = begin + 1;
    while (end < frameCount() && edge[at(end)]) ++end;
    computeFlow(begin, end, options, beforeFlow);
    begin = end;
  }
}

void GuideStream::takeFlow(const FlowReader& readFlow) {
  Mask previousMask(frames_.front().shape.size());
  for (int i = 0; i < frameCount(); ++i) {
    Mask mask = frames_[at(i)].shape.mask();
    frames_[at(i)].flow = gather(frames_[at(i)].shape.packedMask(), readFlow(i, previousMask));
    previousMask = std::move(mask);
  }
}

void GuideStream::computeFlow(int begin, int end, const GuideOptions& options,
                              const std::function<void()>& beforeFlow) {
  if (end - begin < 2) return;  // a single frame does not move
  Box shapes;
  for (int i = begin; i < end; ++i) {
    shapes = joined(shapes, frames_[at(i)].shape.packedMask().box());
  }
  const Box box = fromEvenPixel(grown(shapes, flowMarginPx(), frames_[at(begin)].shape.size()));
  ShapeChanges changes(
      end - begin, options.timeBlurSigmaFrames,
      [&](int i) {
        const PackedShape& shape = frames_[at(begin + i)].shape;
        return ShapeChanges::Shape{shape.packedMask().unpack(box), shape.edgeDistance(box)};
      },
      [&](int i) { return repeatsShape(begin + i); });
  for (int i = begin; i < end; ++i) {
    if (beforeFlow) beforeFlow();
    StoredFrame& frame = frames_[at(i)];
    const PackedMask& mask = frame.shape.packedMask();
    const MotionField motion =
        motionField(mask.unpack(box), changes.at(i - begin), options.motionModel, box.begin());
    frame.flow = gather(mask, motion.flow, box);
    frame.diffusion = motion.report;
  }
  if (options.flowBlurSigmaFrames > 0.0F) averageFlow(begin, end, options.flowBlurSigmaFrames);
}

void GuideStream::averageFlow(int begin, int end, float sigmaFrames) {
  FlowAverages averages(end - begin, sigmaFrames, [&](int i) {
    const StoredFrame& frame = frames_[at(begin + i)];
    return FlowAverages::MovingFrame{frame.shape.mask(),
                                     scatter(frame.shape.packedMask(), frame.flow)};
  });
  for (int i = begin; i < end; ++i) {
    const Image<Vec2> average = averages.at(i - begin);
    frames_[at(i)].flow = gather(frames_[at(i)].shape.packedMask(), average);
  }
}

bool GuideStream::anyInside() const {
  assert(nextFrame_ == 0);
  return std::any_of(frames_.begin(), frames_.end(),
                     [](const StoredFrame& frame) { return !frame.flow.empty(); });
}

bool GuideStream::drawsLines() const {
  assert(nextFrame_ == 0);
  Growth growth;
  for (const StoredFrame& frame : frames_) growth.add(frame.shape.packedMask());
  if (!growth.isDrawing()) return false;
  DrawnLines lines;
  for (const StoredFrame& frame : frames_) {
    lines.add(frame.shape.mask(), scatter(frame.shape.packedMask(), frame.flow));
  }
  return lines.found();
}

bool GuideStream::repeatsShape(int frame) const {
  return frame > 0 && frame < frameCount() &&
         frames_[at(frame)].shape == frames_[at(frame - 1)].shape;
}

void GuideStream::addShape(const PackedShape& shape, GuideFrame& guides) {
  if (repeatsShape(nextFrame_)) {
    guides.mask = shape.mask();
    guides.distance = held_.distance.clone();
    guides.coverage = held_.coverage.clone();
    guides.shape = held_.shape.clone();
  } else {
    shape.addTo(guides);
    if (shapeBlurRadiusPx_) guides.shape = blurredMask(guides.mask, *shapeBlurRadiusPx_);
    held_ = {};
    if (repeatsShape(nextFrame_ + 1)) {
      held_ = {guides.distance.clone(), guides.coverage.clone(), guides.shape.clone()};
    }
  }
}

GuideFrame GuideStream::next() {
  assert(nextFrame_ < frameCount());
  StoredFrame& stored = frames_[at(nextFrame_)];
  GuideFrame guides;
  addShape(stored.shape, guides);
  const PackedMask& mask = stored.shape.packedMask();
  guides.flow = scatter(mask, stored.flow);
  guides.accBackward = scatter(mask, stored.accBackward);
  if (nextFrame_ == 0) {
    accForward_.resize(stored.flow.size());
  } else {
    accForward_ = accumulateForward(frames_[at(nextFrame_ - 1)].shape.packedMask(), accForward_,
                                    mask, stored.flow);
  }
  guides.accForward = scatter(mask, accForward_);
  const bool isStill =
      repeatsShape(nextFrame_) && std::all_of(stored.flow.begin(), stored.flow.end(),
                                              [](Vec2 v) { return v.x == 0.0F && v.y == 0.0F; });
  std::vector<Vec2>().swap(stored.flow);  // given away, and not asked for again
  std::vector<Vec2>().swap(stored.accBackward);

  Image<Vec2> previous;
  if (nextFrame_ > 0) {
    previous = scatter(frames_[at(nextFrame_ - 1)].shape.packedMask(), direction_);
  }
  if (isStill) {  // every pixel keeps the direction that it has
    guides.direction = std::move(previous);
    guides.diffusion = stored.diffusion;
  } else {
    DirectionField direction =
        flowDirection(guides.mask, guides.flow, guides.distance, std::move(previous));
    guides.direction = std::move(direction.direction);
    guides.diffusion = worse(stored.diffusion, direction.report);
    direction_ = gather(mask, guides.direction);
  }
  ++nextFrame_;
  return guides;
}

}  // namespace fluidymation
