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

}  // namespace

GuideStream::GuideStream(int frameCount, const MaskReader& readMask, const GuideOptions& options,
                         const FlowReader& readFlow, const GuideStreamSetting& setting)
    : shapeBlurRadiusPx_(options.shapeBlurRadiusPx),
      keeps_(setting.keeps),
      store_(setting.storage),
      shapes_(frameCount, readMask, options.mask, store_),
      flows_(at(frameCount)) {
  assert(frameCount >= 1);
  if (setting.masksRead) setting.masksRead(mostPixels());
  if (readFlow) {
    takeFlow(readFlow);
  } else {
    deriveFlow(options, setting.beforeFlow);
  }
  backward_.emplace(frameCount, movingFrames(), store_, keeps_);
}

std::vector<Vec2> GuideStream::flow(int frame) const {
  const StoredFlow& stored = flows_[at(frame)];
  if (stored.flow) return store_.get<Vec2>(*stored.flow);
  return std::vector<Vec2>(shapes_.pixelCount(frame));
}

void GuideStream::setFlow(int frame, const std::vector<Vec2>& flow) {
  std::optional<RecordStore::Record>& record = flows_[at(frame)].flow;
  if (record) store_.drop(*record);
  record = store_.add(flow);
}

BackwardMotion::FrameOf GuideStream::movingFrames() const {
  return [this](int i) {
    return BackwardMotion::MovingFrame{shapes_.shape(i).packedMask(), flow(i)};
  };
}

void GuideStream::deriveFlow(const GuideOptions& options, const std::function<void()>& beforeFlow) {
  // Frames without an edge, empty and full ones, have stand-ins for distances: they end the
  // temporal window on both sides as the ends of the sequence do.
  for (int begin = 0; begin < frameCount(); ++begin) {
    if (!shapes_.hasEdge(begin)) continue;
    int end = begin + 1;
    while (end < frameCount() && shapes_.hasEdge(end)) ++end;
    computeFlow(begin, end, options, beforeFlow);
    begin = end;
  }
}

void GuideStream::takeFlow(const FlowReader& readFlow) {
  Mask previousMask(shapes_.size());
  for (int i = 0; i < frameCount(); ++i) {
    const PackedMask mask = shapes_.shape(i).packedMask();
    setFlow(i, gather(mask, readFlow(i, previousMask)));
    previousMask = mask.unpack();
  }
}

void GuideStream::computeFlow(int begin, int end, const GuideOptions& options,
                              const std::function<void()>& beforeFlow) {
  if (end - begin < 2) return;  // a single frame does not move
  Box shapes;
  for (int i = begin; i < end; ++i) shapes = joined(shapes, shapes_.box(i));
  const Box box = fromEvenPixel(grown(shapes, flowMarginPx(), shapes_.size()));
  ShapeChanges changes(
      end - begin, options.timeBlurSigmaFrames,
      [&](int i) {
        const PackedShape shape = shapes_.shape(begin + i);
        return ShapeChanges::Shape{shape.packedMask().unpack(box), shape.edgeDistance(box)};
      },
      [&](int i) { return shapes_.repeats(begin + i); });
  for (int i = begin; i < end; ++i) {
    if (beforeFlow) beforeFlow();
    const PackedMask mask = shapes_.shape(i).packedMask();
    const MotionField motion =
        motionField(mask.unpack(box), changes.at(i - begin), options.motionModel, box.begin());
    setFlow(i, gather(mask, motion.flow, box));
    flows_[at(i)].diffusion = motion.report;
  }
  if (options.flowBlurSigmaFrames > 0.0F) averageFlow(begin, end, options.flowBlurSigmaFrames);
}

void GuideStream::averageFlow(int begin, int end, float sigmaFrames) {
  FlowAverages averages(end - begin, sigmaFrames, [&](int i) {
    const PackedMask mask = shapes_.shape(begin + i).packedMask();
    return FlowAverages::MovingFrame{mask.unpack(), scatter(mask, flow(begin + i))};
  });
  for (int i = begin; i < end; ++i) {
    const Image<Vec2> average = averages.at(i - begin);
    setFlow(i, gather(shapes_.shape(i).packedMask(), average));
  }
}

bool GuideStream::anyInside() const { return mostPixels() != 0; }

std::size_t GuideStream::mostPixels() const {
  std::size_t most = 0;
  for (int i = 0; i < frameCount(); ++i) most = std::max(most, shapes_.pixelCount(i));
  return most;
}

bool GuideStream::drawsLines() const {
  assert(nextFrame_ == 0);
  Growth growth;
  for (int i = 0; i < frameCount(); ++i) growth.add(shapes_.shape(i).packedMask());
  if (!growth.isDrawing()) return false;
  DrawnLines lines;
  for (int i = 0; i < frameCount(); ++i) {
    const PackedMask mask = shapes_.shape(i).packedMask();
    lines.add(mask.unpack(), scatter(mask, flow(i)));
  }
  return lines.found();
}

void GuideStream::addShape(const PackedShape& shape, const Box& box, GuideFrame& guides) {
  if (held_ && held_->box == box && shapes_.repeats(nextFrame_)) {
    guides.mask = shape.packedMask().unpack(box);
    guides.distance = held_->distance.clone();
    guides.coverage = held_->coverage.clone();
    guides.shape = held_->shape.clone();
  } else {
    shape.addTo(guides, box);
    if (shapeBlurRadiusPx_) guides.shape = blurredMask(guides.mask, *shapeBlurRadiusPx_);
    held_.reset();
    if (shapes_.repeats(nextFrame_ + 1)) {
      held_ =
          HeldShape{box, guides.distance.clone(), guides.coverage.clone(), guides.shape.clone()};
    }
  }
}

Image<Vec2> GuideStream::lastDirection(const Box& box) const {
  return nextFrame_ == 0 ? Image<Vec2>() : scatter(last_.mask, last_.direction, box);
}

Image<Vec2> GuideStream::directionBefore(int end, const std::function<void()>& beforeEach) const {
  return directionOfLast(
      nextFrame_, end,
      [&](int i) {
        if (beforeEach) beforeEach();
        const PackedMask mask = shapes_.shape(i).packedMask();
        return MovingShape{mask.unpack(), scatter(mask, flow(i))};
      },
      [&](int i) {
        GuideFrame guides;
        shapes_.shape(i).addTo(guides);
        return std::move(guides.distance);
      },
      lastDirection(wholeBox()));
}

void GuideStream::accumulate(const PackedMask& mask, const std::vector<Vec2>& flow) {
  if (nextFrame_ == 0) {
    last_.accForward.resize(flow.size());
  } else {
    last_.accForward = accumulateForward(last_.mask, last_.accForward, mask, flow);
  }
  last_.mask = mask;
}

void GuideStream::finishFrame() {
  if (!keeps_) {  // given away, and not asked for again
    shapes_.drop(nextFrame_);
    if (flows_[at(nextFrame_)].flow) store_.drop(*flows_[at(nextFrame_)].flow);
  }
  ++nextFrame_;
}

GuideFrame GuideStream::next() { return nextWithin(wholeBox()); }

GuidePart GuideStream::nextPart(int marginPx) {
  const int widest = std::max({marginPx, kShapeMarginPx, directionMarginPx()});
  const Box box = fromEvenPixel(grown(shapes_.box(nextFrame_), widest, shapes_.size()));
  return {{shapes_.size(), box}, nextWithin(box)};
}

GuideFrame GuideStream::nextWithin(const Box& box) {
  assert(nextFrame_ < frameCount());
  const PackedShape shape = shapes_.shape(nextFrame_);
  const PackedMask& mask = shape.packedMask();
  GuideFrame guides;
  addShape(shape, box, guides);
  guides.accBackward = scatter(mask, backward_->next(movingFrames()), box);
  const std::vector<Vec2> flow = this->flow(nextFrame_);
  guides.flow = scatter(mask, flow, box);
  Image<Vec2> previous = lastDirection(box);
  accumulate(mask, flow);
  guides.accForward = scatter(mask, last_.accForward, box);

  guides.diffusion = flows_[at(nextFrame_)].diffusion;
  const bool isStill =
      shapes_.repeats(nextFrame_) &&
      std::all_of(flow.begin(), flow.end(), [](Vec2 v) { return v.x == 0.0F && v.y == 0.0F; });
  if (isStill) {  // every pixel keeps the direction that it has
    guides.direction = std::move(previous);
  } else {
    DirectionField direction =
        flowDirection(guides.mask, guides.flow, guides.distance, std::move(previous), box.begin());
    guides.direction = std::move(direction.direction);
    guides.diffusion = worse(guides.diffusion, direction.report);
    last_.direction = gather(mask, guides.direction, box);
  }
  finishFrame();
  return guides;
}

void GuideStream::skip(int count, const std::function<void()>& beforeEach,
                       const std::function<void(const Mask&)>& maskOf) {
  assert(count >= 0 && nextFrame_ + count <= frameCount());
  if (count == 0) return;
  const int end = nextFrame_ + count;
  const Image<Vec2> direction = directionBefore(end, beforeEach);
  while (nextFrame_ < end) {
    if (beforeEach) beforeEach();
    const PackedMask mask = shapes_.shape(nextFrame_).packedMask();
    if (maskOf) maskOf(mask.unpack());
    accumulate(mask, flow(nextFrame_));
    backward_->skip();
    finishFrame();
  }
  last_.direction = gather(last_.mask, direction);
  held_.reset();
}

void GuideStream::rewind() {
  assert(keeps_);
  nextFrame_ = 0;
  backward_->rewind();
  held_.reset();
  last_ = {};
}

}  // namespace fluidymation
