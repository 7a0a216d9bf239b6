#pragma once

#include <cstdint>
#include <vector>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// How often each difference to the bare surface occurs in a film, and what follows from that.
class DifferenceHistogram {
 public:
  DifferenceHistogram();

  /// @param grainLevel  of this frame (`grainLevel` of film_difference.h).
  void add(const Image<float>& difference, float grainLevel);

  /// The difference from which on a pixel counts as paint, one for the whole film: Otsu's threshold
  /// (1979) of the differences' square roots. The root brings pale and strong paint together;
  /// without it pale edges count as bare. It is never below
  /// four times the grain (the median of the frames'), nor below what can just be seen.
  [[nodiscard]] float automaticThreshold() const;

 private:
  std::vector<std::int64_t> counts_;
  std::vector<float> grainLevels_;  ///< one a frame
};

}  // namespace fluidymation
