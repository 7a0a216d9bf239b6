#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/guides/outline.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// A mask as read from the user, before smoothing.
struct InputMask {
  InputMask() = default;
  InputMask(Image<float> coverageOfPixels, bool isSoft)
      : coverage(std::move(coverageOfPixels)), soft(isSoft) {}
  /// A hard one.
  InputMask(const Mask& mask);  // NOLINT: a mask is an input mask

  /// Cut at one half.
  [[nodiscard]] Mask cut() const;

  Image<float> coverage;  ///< how much of each pixel lies inside, in [0, 1]
  /// Whether any pixel was stored as partly covered. Hard masks, which are not, may have partly
  /// covered pixels too, once they are scaled.
  bool soft = false;
};

/// Gives the mask of frame i (0-based). Called once for every frame, in order.
using MaskReader = std::function<InputMask(int frame)>;

/// The smoothed shape of one frame of a long sequence that waits for its turn: one bit a pixel, and
/// of a soft sequence the sub-pixel outline.
class PackedShape {
 public:
  explicit PackedShape(const Mask& mask) : mask_(mask) {}
  explicit PackedShape(OutlinedMask shape)
      : mask_(shape.mask), soft_(true), outline_(std::move(shape.outline)) {}

  [[nodiscard]] Size size() const { return mask_.size(); }
  [[nodiscard]] Mask mask() const { return mask_.unpack(); }

  /// `continuousDistance` of a hard shape, `outlineDistance` of a soft one. The shape must have an
  /// edge: it is neither empty nor full.
  [[nodiscard]] Image<float> edgeDistance() const;

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

/// A shape without an edge within the image has no distance to it.
[[nodiscard]] bool hasEdge(const Mask& mask);

}  // namespace fluidymation
