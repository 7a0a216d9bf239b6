#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/guides/packed_mask.h"
#include "fluidymation/io/record_store.h"

namespace fluidymation {

/// acc- of all frames of a sequence (thesis §3.5), in order, though each is made of the one after
/// it. The constructor goes through the sequence once from its end and stores what it has at every
/// `kStoredEvery`th frame; from there that many frames are gone through once more when their turn
/// comes. So acc- is what it would be had all of it been kept.
class BackwardMotion {
 public:
  /// Frames from one that is stored to the next: one more vector a pixel on the disk for each of so
  /// many frames, and so many vectors a pixel in memory.
  static constexpr int kStoredEvery = 8;

  struct MovingFrame {
    PackedMask mask;
    std::vector<Vec2> flow;  ///< of its pixels, in row order, px per frame
  };
  using FrameOf = std::function<MovingFrame(int frame)>;

  /// @param frameOf  asked for every frame, from the last to the first.
  /// @param store  must outlive this.
  /// @param keeps  whether what is stored stays there, for `rewind`.
  /// @throws Error when the store cannot be written; whatever `frameOf` throws.
  BackwardMotion(int frameCount, const FrameOf& frameOf, RecordStore& store, bool keeps = false);

  /// acc- of the pixels of the next frame.
  /// @param frameOf  asked for up to `kStoredEvery` + 1 frames from the next one on.
  /// @throws Error when the store cannot be read; whatever `frameOf` throws.
  [[nodiscard]] std::vector<Vec2> next(const FrameOf& frameOf);

  /// Passes over the next frame: no frame is asked for, and none is gone through whose acc- nobody
  /// wants.
  void skip();

  /// Begins anew with the first frame; only where what is stored is kept.
  void rewind();

 private:
  [[nodiscard]] int blockCount() const;
  /// Fills in `waiting_` for the next frame and those after it in its block.
  void provideBlock(const FrameOf& frameOf);

  RecordStore& store_;
  int frameCount_;
  bool keeps_;
  std::vector<RecordStore::Record> firstOfBlocks_;  ///< of all blocks but the first
  int nextFrame_ = 0;
  std::deque<std::vector<Vec2>> waiting_;  ///< of the rest of the block at work, from the next on
};

}  // namespace fluidymation
