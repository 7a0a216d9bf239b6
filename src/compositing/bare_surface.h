#pragma once

#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// The surface of an exemplar without any paint on it, from the pixels that lie bare in some frame.
class BareSurface {
 public:
  explicit BareSurface(Size size) : sum_(size), count_(size, 0.0F) {}

  /// @param coverage  of the frame's mask; a margin round it does not count either, for paint that
  /// the mask does not hold.
  void add(const Image<Rgb>& picture, const Image<float>& coverage);

  /// Whether any pixel was ever bare.
  [[nodiscard]] bool known() const;

  /// Each pixel's mean while it was bare. The others get the smooth shading of those around them
  /// and the grain of a bare place nearby. Some pixel must be known (asserted).
  [[nodiscard]] Image<Rgb> filled() const;

  /// A surface of any size: the middle of this one, filled, where it is large enough. Else its
  /// grain, quilted from places that stayed bare long, which no pale paint has reached; without its
  /// shading, which would show as a pattern. Where there are too few such places, it is mirrored at
  /// its sides again and again. Some pixel must be known (asserted).
  [[nodiscard]] Image<Rgb> spread(Size size) const;

 private:
  /// What was bare in at least this share of the frames in which the barest pixel was.
  [[nodiscard]] Mask bareFor(float share) const;

  Image<Rgb> sum_;
  Image<float> count_;
};

}  // namespace fluidymation
