#pragma once

#include <optional>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// How a medium's colour changes with the distance to its edge: tells how wide its rim is. Not in
/// the thesis, where the user says so (§3.4).
class RimProfile {
 public:
  /// @param bandCount  bands of 1 px that are looked at, from the edge inwards; at least 1.
  explicit RimProfile(int bandCount);

  /// Counts one frame of the film. Only the change from each band to the next one counts, so that
  /// frames of different brightness, and shapes that end before the last band, go together.
  /// @param mask  of the same size, nonzero where the medium is.
  void add(const Image<Lab>& picture, const Mask& mask);

  /// The least distance from which on colours differ no more than is noticed, or by a tenth of all
  /// that they differ by, over a distance of `stepPx`.
  /// @param stepPx  at least 1.
  /// @return  px, from 1 to the number of bands; nothing where no frame had two bands.
  [[nodiscard]] std::optional<float> widthPx(int stepPx) const;

 private:
  struct Change {
    double l = 0.0;
    double a = 0.0;
    double b = 0.0;
    double pixels = 0.0;
  };

  std::vector<Change> changes_;  ///< from band i to band i + 1, summed over pixels
};

}  // namespace fluidymation
