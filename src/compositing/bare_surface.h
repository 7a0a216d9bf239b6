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

 private:
  Image<Rgb> sum_;
  Image<float> count_;
};

/// A surface of any size with the grain of `surface`, pixel by pixel: its middle where it is large
/// enough, else mirrored at its sides again and again, without its shading, which would show as a
/// pattern.
[[nodiscard]] Image<Rgb> spread(const Image<Rgb>& surface, Size size);

}  // namespace fluidymation
