#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "fluidymation/guides/backward_motion.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/guides/packed_shape.h"
#include "fluidymation/guides/stored_shapes.h"
#include "fluidymation/io/record_store.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// Gives the flow of frame i where the user has one: the movement from frame i - 1 to i, px per
/// frame, of the frame's size; only what lies inside the mask counts. Called once for every frame,
/// in order, after all masks.
/// @param previousMask  of frame i - 1, after smoothing; empty of material for i = 0.
using FlowReader = std::function<Image<Vec2>(int frame, const Mask& previousMask)>;

/// What a stream of guides tells while it is made, and where it keeps what waits; all may be empty.
struct GuideStreamSetting {
  RecordStorage storage;
  /// Told of the most mask pixels that a frame has after smoothing, when all masks are read; may
  /// throw to end there.
  std::function<void(std::size_t mostPixels)> masksRead;
  /// Called before the flow of each frame is derived; may throw to end there.
  std::function<void()> beforeFlow;
  /// Whether frames are kept in the store after their turn, for `GuideStream::rewind`.
  bool keeps = false;
};

/// Turns a sequence of masks into guides, one frame at a time and in order (thesis figure 4.3).
///
/// Looking ahead is needed twice: the temporal smoothing wants the distance fields of the next
/// 3 sigma frames, and ext- the flow of all later frames. The constructor therefore goes through
/// all frames once, forwards and then backwards, and leaves in a store what each frame is made of
/// when its turn comes: the smoothed mask, one bit a pixel, of soft ones the outline too, the flow
/// of mask pixels, and of some frames the backward accumulator (`BackwardMotion`). With bounded
/// memory for the store, the length of a sequence costs but some tens of bytes a frame.
class GuideStream {
 public:
  /// Reads and smooths all masks and computes all flows. All masks must have one size (asserted);
  /// masks may be empty or full. `frameCount` >= 1.
  /// @param readMask  asked as `StoredShapes` does.
  /// @param readFlow  where given, replaces the flow derived from the masks, and its smoothing.
  /// @throws Error when the store cannot be written or read; what is given may throw.
  GuideStream(int frameCount, const MaskReader& readMask, const GuideOptions& options,
              const FlowReader& readFlow = {}, const GuideStreamSetting& setting = {});
  GuideStream(const GuideStream&) = delete;
  GuideStream& operator=(const GuideStream&) = delete;

  [[nodiscard]] int frameCount() const { return shapes_.frameCount(); }

  /// Whether any mask still has material after smoothing. Asked before the first `next()`.
  [[nodiscard]] bool anyInside() const;

  /// Whether the sequence is lines being drawn, see `Growth` and `DrawnLines`. Asked before the
  /// first `next()`. @throws Error when the store cannot be read.
  [[nodiscard]] bool drawsLines() const;

  /// Whether a frame's mask has no material after smoothing.
  [[nodiscard]] bool isEmpty(int frame) const { return shapes_.pixelCount(frame) == 0; }

  /// Guides of the next frame; it and `skip` must not be called more than `frameCount()` times
  /// together, after a `rewind` as often again.
  /// @throws Error when the store cannot be read.
  [[nodiscard]] GuideFrame next();

  /// The same within a box that holds the shape and at least `marginPx` round it, as far as the
  /// frame reaches; nothing of a frame without a shape.
  [[nodiscard]] GuidePart nextPart(int marginPx);

  /// Passes over the next frames: makes of their guides only what those of later frames depend on,
  /// the motion accumulated so far and the last directions. The frames after them do not notice.
  /// @param beforeEach  where given, called once or twice for each frame, before it is gone
  /// through:
  ///   backwards for directions and forwards for motion. What it throws ends the stream's use.
  /// @param maskOf      where given, is told of the mask of each.
  /// @throws Error when the store cannot be read.
  void skip(int count, const std::function<void()>& beforeEach = {},
            const std::function<void(const Mask&)>& maskOf = {});

  /// Begins anew with the first frame: the same guides once more. Only with
  /// `GuideStreamSetting::keeps`.
  void rewind();

 private:
  struct StoredFlow {
    std::optional<RecordStore::Record> flow;  ///< of mask pixels, in row order; none: zero
    SolveReport diffusion;
  };

  /// The most mask pixels that a frame has.
  [[nodiscard]] std::size_t mostPixels() const;

  /// Flow of the mask pixels of a frame, in row order.
  [[nodiscard]] std::vector<Vec2> flow(int frame) const;
  void setFlow(int frame, const std::vector<Vec2>& flow);
  [[nodiscard]] BackwardMotion::FrameOf movingFrames() const;

  /// Fills in all flows, derived from the masks or as given.
  void deriveFlow(const GuideOptions& options, const std::function<void()>& beforeFlow);
  void takeFlow(const FlowReader& readFlow);

  /// Fills in the flow of frames begin..end-1, a run of frames that all have an edge.
  void computeFlow(int begin, int end, const GuideOptions& options,
                   const std::function<void()>& beforeFlow);

  /// Replaces the flows of such a run by their means over time (P App. A): at each mask pixel a
  /// Gaussian over the frames around that have the pixel in their masks.
  void averageFlow(int begin, int end, float sigmaFrames);

  /// Guides of the next frame within a box that begins with an even pixel and is as large as
  /// `nextPart` says.
  [[nodiscard]] GuideFrame nextWithin(const Box& box);

  /// Fills in what the shape alone says: mask, distance, coverage and blurred mask.
  void addShape(const PackedShape& shape, const Box& box, GuideFrame& guides);

  [[nodiscard]] Box wholeBox() const { return {0, 0, shapes_.size().width, shapes_.size().height}; }

  /// Directions within a box of the frame given last; an empty image before the first one.
  [[nodiscard]] Image<Vec2> lastDirection(const Box& box) const;

  /// Directions of frame end - 1, when `last_` is of the frame before the next one.
  [[nodiscard]] Image<Vec2> directionBefore(int end, const std::function<void()>& beforeEach) const;

  /// Takes the motion accumulated so far, and the mask of `last_`, on to the next frame.
  void accumulate(const PackedMask& mask, const std::vector<Vec2>& flow);

  /// The next frame has had its turn.
  void finishFrame();

  /// Of a shape that the next frame repeats.
  struct HeldShape {
    Box box;
    Image<float> distance;
    Image<float> coverage;
    Image<float> shape;
  };

  /// What is kept of the frame given last, of its mask pixels.
  struct LastFrame {
    PackedMask mask;
    std::vector<Vec2> accForward;
    std::vector<Vec2> direction;
  };

  std::optional<float> shapeBlurRadiusPx_;
  bool keeps_;
  RecordStore store_;
  StoredShapes shapes_;
  std::vector<StoredFlow> flows_;
  std::optional<BackwardMotion> backward_;
  int nextFrame_ = 0;
  std::optional<HeldShape> held_;
  LastFrame last_;
};

}  // namespace fluidymation
