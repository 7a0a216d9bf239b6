#pragma once

namespace fluidymation {

/// How much work goes into making a PNG file small: from 0, pixels stored as they are, to 9. Pixels
/// are the same for all. 1 to 3 look for runs of equal bytes only, which is nearly all that the
/// filtered rows of painted frames have to offer; they differ by the filter: Average, Paeth, the
/// best one for each row. From 4 on zlib's search for repetitions of that level is added.
inline constexpr int kLeastCompression = 0;
inline constexpr int kMostCompression = 9;
/// Painted frames become at most 4 % larger than by zlib's own default, in less than a third of its
/// time (docs/performance.md).
inline constexpr int kDefaultCompression = 2;

}  // namespace fluidymation
