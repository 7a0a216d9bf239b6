#pragma once

#include <gtest/gtest.h>

#include <string>

namespace fluidymation::test {

/// How far a painted frame may be from the committed one. Within one build the bytes are equal
/// (that is tested elsewhere); the tolerance is for other compilers and libraries only.
///
/// Measured when it was chosen, against GCC 12 at -O3: byte-identical with GCC at -O0 and -O2 and
/// with Clang 14 at -O0 and -O3. GCC's -ffast-math, and a cube root that is off by its last bit at
/// random, each moved one pixel in a thousand by 1 of 255. What is allowed beyond that is for a
/// search that takes another, equally good match somewhere; a different seed is far outside.
struct GoldenTolerance {
  int threshold = 4;       ///< of 255 per channel; a pixel beyond it counts as different
  double share = 0.01;     ///< of the painted pixels may be different
  int hardLimit = 48;      ///< of 255 per channel; no pixel may be further away
  double meanColor = 0.1;  ///< of 255; the mean of each channel over the painted pixels
};

/// Whether `actual` is the picture of `expected` within the tolerance; alpha has to be identical.
/// Says otherwise the largest error, the share and the first pixel beyond the threshold.
[[nodiscard]] ::testing::AssertionResult isGolden(const std::string& expectedPath,
                                                  const std::string& actualPath,
                                                  const GoldenTolerance& tolerance);

}  // namespace fluidymation::test
