#pragma once

#include <utility>

#include "fluidymation/core/box.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/guides/outline.h"
#include "fluidymation/guides/packed_mask.h"

namespace fluidymation {

/// How far beyond a shape its distances and coverage are made from, px: a pixel that it covers in
/// part lies next to it, and the gradient there looks one further.
inline constexpr int kShapeMarginPx = 2;

/// The smoothed shape of one frame of a long sequence that waits for its turn: one bit a pixel, and
/// of a soft sequence the sub-pixel outline.
class PackedShape {
 public:
  explicit PackedShape(const Mask& mask) : mask_(mask) {}
  explicit PackedShape(OutlinedMask shape)
      : mask_(shape.mask), soft_(true), outline_(std::move(shape.outline)) {}
  explicit PackedShape(PackedMask mask) : mask_(std::move(mask)) {}
  /// A soft one. @param outline  made with this mask.
  PackedShape(PackedMask mask, Outline outline)
      : mask_(std::move(mask)), soft_(true), outline_(std::move(outline)) {}

  friend bool operator==(const PackedShape& a, const PackedShape& b) {
    return a.soft_ == b.soft_ && a.mask_ == b.mask_ && a.outline_ == b.outline_;
  }

  [[nodiscard]] Size size() const { return mask_.size(); }
  [[nodiscard]] const PackedMask& packedMask() const { return mask_; }
  [[nodiscard]] bool isSoft() const { return soft_; }
  [[nodiscard]] const Outline& outline() const { return outline_; }  ///< of a soft shape
  [[nodiscard]] Mask mask() const { return mask_.unpack(); }

  /// `continuousDistance` of a hard shape, `outlineDistance` of a soft one, within a box that holds
  /// the shape and its neighbouring pixels. The shape must have an edge: it is neither empty nor
  /// full.
  [[nodiscard]] Image<float> edgeDistance(const Box& box) const;

  /// Fills in mask, distance and coverage.
  void addTo(GuideFrame& guides) const;
  /// The same within a box that holds the shape and `kShapeMarginPx` round it, as far as the frame
  /// reaches.
  void addTo(GuideFrame& guides, const Box& box) const;

 private:
  PackedMask mask_;
  bool soft_ = false;
  Outline outline_;  ///< of a soft shape
};

}  // namespace fluidymation
