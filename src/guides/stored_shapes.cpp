#include "fluidymation/guides/stored_shapes.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

#include "fluidymation/core/index.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/guides/outline.h"

namespace fluidymation {
namespace {

bool isEqual(const Image<float>& a, const Image<float>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

PackedShape smoothed(const InputMask& input, const MaskOptions& options, bool soft) {
  if (soft) return PackedShape(outlinedMask(input.coverage, options));
  return PackedShape(smoothMask(input.cut(), options));
}

}  // namespace

StoredShapes::StoredShapes(int frameCount, const MaskReader& readMask, const MaskOptions& options,
                           RecordStore& store)
    : store_(store) {
  if (readAll(frameCount, readMask, options, false)) return;
  for (int i = 0; i < this->frameCount(); ++i) drop(i);
  frames_.clear();
  readAll(frameCount, readMask, options, true);
}

bool StoredShapes::readAll(int frameCount, const MaskReader& readMask, const MaskOptions& options,
                           bool soft) {
  InputMask last;
  std::optional<PackedShape> lastShape;
  for (int i = 0; i < frameCount; ++i) {
    InputMask input = readMask(i);
    if (input.soft && !soft) {
      if (i > 0) return false;
      soft = true;
    }
    const bool isHold = lastShape && isEqual(input.coverage, last.coverage);
    std::optional<PackedShape> shape;
    if (!isHold) shape.emplace(smoothed(input, options, soft));
    if (isHold || (lastShape && *shape == *lastShape)) {
      frames_.push_back(frames_.back());
      frames_.back().repeats = true;
    } else {
      assert(!lastShape || shape->size() == size_);
      size_ = shape->size();
      frames_.push_back(stored(*shape));
      lastShape = std::move(shape);
    }
    last = std::move(input);
  }
  return true;
}

StoredShapes::Stored StoredShapes::stored(const PackedShape& shape) {
  const PackedMask& mask = shape.packedMask();
  Stored stored;
  stored.mask = store_.add(mask.words());
  if (shape.isSoft()) stored.outline = store_.add(shape.outline().shares());
  stored.box = mask.box();
  stored.pixelCount = mask.count();
  return stored;
}

PackedShape StoredShapes::shape(int frame) const {
  const Stored& stored = of(frame);
  PackedMask mask(size_, store_.get<std::uint64_t>(stored.mask));
  if (!stored.outline) return PackedShape(std::move(mask));
  return {std::move(mask), Outline(store_.get<std::uint16_t>(*stored.outline))};
}

bool StoredShapes::hasEdge(int frame) const {
  const std::size_t inside = of(frame).pixelCount;
  return inside != 0 && inside != at(size_.width) * at(size_.height);
}

bool StoredShapes::repeats(int frame) const { return frame < frameCount() && of(frame).repeats; }

void StoredShapes::drop(int frame) {
  if (repeats(frame + 1)) return;
  store_.drop(of(frame).mask);
  if (of(frame).outline) store_.drop(*of(frame).outline);
}

const StoredShapes::Stored& StoredShapes::of(int frame) const { return frames_[at(frame)]; }

}  // namespace fluidymation
