#include "fluidymation/guides/backward_motion.h"

#include <cassert>
#include <utility>

#include "fluidymation/core/index.h"
#include "fluidymation/guides/accumulation.h"

namespace fluidymation {
namespace {

using MovingFrame = BackwardMotion::MovingFrame;

std::vector<Vec2> oneFrameEarlier(const MovingFrame& later, const std::vector<Vec2>& ofLater,
                                  const MovingFrame& frame) {
  return accumulateBackward(later.mask, ofLater, later.flow, frame.mask, frame.flow);
}

}  // namespace

BackwardMotion::BackwardMotion(int frameCount, const FrameOf& frameOf, RecordStore& store,
                               bool keeps)
    : store_(store), frameCount_(frameCount), keeps_(keeps), firstOfBlocks_(at(blockCount())) {
  MovingFrame later = frameOf(frameCount - 1);
  std::vector<Vec2> motion(later.flow.size());
  for (int i = frameCount - 1; i > 0; --i) {
    if (i % kStoredEvery == 0) firstOfBlocks_[at(i / kStoredEvery)] = store_.add(motion);
    MovingFrame frame = frameOf(i - 1);
    motion = oneFrameEarlier(later, motion, frame);
    later = std::move(frame);
  }
}

int BackwardMotion::blockCount() const { return (frameCount_ + kStoredEvery - 1) / kStoredEvery; }

std::vector<Vec2> BackwardMotion::next(const FrameOf& frameOf) {
  assert(nextFrame_ < frameCount_);
  if (waiting_.empty()) provideBlock(frameOf);
  ++nextFrame_;
  std::vector<Vec2> motion = std::move(waiting_.front());
  waiting_.pop_front();
  return motion;
}

void BackwardMotion::skip() {
  assert(nextFrame_ < frameCount_);
  const bool isProvided = !waiting_.empty();
  if (isProvided) waiting_.pop_front();
  ++nextFrame_;
  const int block = nextFrame_ / kStoredEvery;
  const bool endsBlock = nextFrame_ % kStoredEvery == 0 && block < blockCount();
  if (endsBlock && !isProvided && !keeps_) store_.drop(firstOfBlocks_[at(block)]);
}

void BackwardMotion::rewind() {
  assert(keeps_);
  nextFrame_ = 0;
  waiting_.clear();
}

void BackwardMotion::provideBlock(const FrameOf& frameOf) {
  const int block = nextFrame_ / kStoredEvery;
  const bool isLast = block + 1 == blockCount();
  const int known = isLast ? frameCount_ - 1 : (block + 1) * kStoredEvery;
  MovingFrame later = frameOf(known);
  std::vector<Vec2> motion;
  if (isLast) {
    motion.resize(later.flow.size());  // nothing is still to come
    waiting_.push_front(motion);
  } else {
    const RecordStore::Record first = firstOfBlocks_[at(block + 1)];
    motion = store_.get<Vec2>(first);
    if (!keeps_) store_.drop(first);
  }
  for (int i = known - 1; i >= nextFrame_; --i) {
    MovingFrame frame = frameOf(i);
    motion = oneFrameEarlier(later, motion, frame);
    waiting_.push_front(motion);
    later = std::move(frame);
  }
}

}  // namespace fluidymation
