#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/guides/input_mask.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/guides/outline.h"
#include "fluidymation/guides/packed_mask.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// The smoothed shape of one frame of a long sequence that waits for its turn: one bit a pixel, and
/// of a soft sequence the sub-pixel outline.
class PackedShape {
 public:
  explicit PackedShape(const Mask& mask) : mask_(mask) {}
  explicit PackedShape(OutlinedMask shape)
      : mask_(shape.mask), soft_(true), outline_(std::move(shape.outline)) {}

  friend bool operator==(const PackedShape& a, const PackedShape& b) {
    return a.soft_ == b.soft_ && a.mask_ == b.mask_ && a.outline_ == b.outline_;
  }

  [[nodiscard]] Size size() const { return mask_.size(); }
  [[nodiscard]] const PackedMask& packedMask() const { return mask_; }
  [[nodiscard]] std::size_t crossingCount() const { return outline_.crossingCount(); }
  [[nodiscard]] Mask mask() const { return mask_.unpack(); }

  /// `continuousDistance` of a hard shape, `outlineDistance` of a soft one, within a box that holds
  /// the shape and its neighbouring pixels. The shape must have an edge: it is neither empty nor
  /// full.
  [[nodiscard]] Image<float> edgeDistance(const Box& box) const;

  /// Fills in mask, distance and coverage.
  void addTo(GuideFrame& guides) const;

 private:
  PackedMask mask_;
  bool soft_ = false;
  Outline outline_;  ///< of a soft shape
};

/// What decides about the memory of the shapes read so far, all of them smoothed.
struct ShapeTally {
  int frames = 0;
  std::int64_t maskPixels = 0;
  std::int64_t crossings = 0;  ///< of soft shapes
};

/// Told of the shapes read so far, after each; may throw to end the reading.
using ShapeWatch = std::function<void(const ShapeTally& tally)>;

/// Reads and smooths all masks of a sequence, which must have one size (asserted). A sequence is
/// soft when any of its masks is; then all of them keep their sub-pixel outline. Otherwise all are
/// cut at one half before they are smoothed.
[[nodiscard]] std::vector<PackedShape> readShapes(int frameCount, const MaskReader& readMask,
                                                  const MaskOptions& options,
                                                  const ShapeWatch& watch = {});

}  // namespace fluidymation
