#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/guides/packed_shape.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// Gives the flow of frame i where the user has one: the movement from frame i - 1 to i, px per
/// frame, of the frame's size; only what lies inside the mask counts. Called once for every frame,
/// in order, after all masks.
/// @param previousMask  of frame i - 1, after smoothing; empty of material for i = 0.
using FlowReader = std::function<Image<Vec2>(int frame, const Mask& previousMask)>;

/// Turns a sequence of masks into guides, one frame at a time and in order (thesis figure 4.3).
///
/// Looking ahead is needed twice: the temporal smoothing wants the distance fields of the next
/// 3 sigma frames, and ext- the flow of all later frames. The constructor therefore reads all
/// masks once and stores, packed to one bit a pixel, the smoothed masks, of soft ones the outline
/// too, and, for mask pixels only, the flow and the backward accumulator. A full GuideFrame exists
/// only while the caller holds it.
class GuideStream {
 public:
  /// Reads and smooths all masks and computes all flows. All masks must have one size (asserted);
  /// masks may be empty or full. `frameCount` >= 1.
  /// @param readFlow  where given, replaces the flow derived from the masks, and its smoothing.
  /// @param watch  told of what is stored, as the masks are read.
  /// @param beforeFlow  called before the flow of each frame is derived; may throw to stop.
  GuideStream(int frameCount, const MaskReader& readMask, const GuideOptions& options,
              const FlowReader& readFlow = {}, const ShapeWatch& watch = {},
              const std::function<void()>& beforeFlow = {});

  [[nodiscard]] int frameCount() const { return static_cast<int>(frames_.size()); }

  /// Whether any mask still has material after smoothing. Asked before the first `next()`.
  [[nodiscard]] bool anyInside() const;

  /// Whether the sequence is lines being drawn, see `Growth` and `DrawnLines`. Asked before the
  /// first `next()`.
  [[nodiscard]] bool drawsLines() const;

  /// Guides of the next frame; must not be called more than `frameCount()` times.
  [[nodiscard]] GuideFrame next();

 private:
  struct StoredFrame {
    PackedShape shape;
    std::vector<Vec2> flow;         ///< of mask pixels, in row order
    std::vector<Vec2> accBackward;  ///< likewise
    SolveReport diffusion;
  };

  /// Fills in all flows, derived from the masks or as given.
  void deriveFlow(const std::vector<bool>& edge, const GuideOptions& options,
                  const std::function<void()>& beforeFlow);
  void takeFlow(const FlowReader& readFlow);

  /// Fills in the flow of frames begin..end-1, a run of frames that all have an edge.
  void computeFlow(int begin, int end, const GuideOptions& options,
                   const std::function<void()>& beforeFlow);

  /// Replaces the flows of such a run by their means over time (P App. A): at each mask pixel a
  /// Gaussian over the frames around that have the pixel in their masks.
  void averageFlow(int begin, int end, float sigmaFrames);

  /// Whether a frame has the shape of the one before it.
  [[nodiscard]] bool repeatsShape(int frame) const;
  /// Fills in what the shape alone says: mask, distance, coverage and blurred mask.
  void addShape(const PackedShape& shape, GuideFrame& guides);

  /// Of a shape that the next frame repeats.
  struct HeldShape {
    Image<float> distance;
    Image<float> coverage;
    Image<float> shape;
  };

  std::optional<float> shapeBlurRadiusPx_;
  std::vector<StoredFrame> frames_;
  int nextFrame_ = 0;
  HeldShape held_;
  std::vector<Vec2> accForward_;  ///< of the mask pixels of the frame given last
  std::vector<Vec2> direction_;   ///< likewise
};

}  // namespace fluidymation
