#pragma once

#include <array>
#include <cstddef>

#include "fluidymation/synthesis/channels.h"

namespace fluidymation {

/// Samples that are compared between two looks at whether to stop.
inline constexpr int kSampleBlock = 8;
inline constexpr int kSampleBlocks = (kPatchArea + kSampleBlock - 1) / kSampleBlock;
inline constexpr int kPaddedSamples = kSampleBlock * kSampleBlocks;

/// Offsets of the window's samples in the order in which they are compared, px. The first block
/// lies on the rim of the window: neighbours tell much the same, and most candidates are rejected
/// by it. Samples 2 i and 2 i + 1 lie opposite each other, so that a half turn exchanges them; the
/// centre comes last, and again as padding.
struct SampleOffsets {
  std::array<float, kPaddedSamples> x;
  std::array<float, kPaddedSamples> y;
};
alignas(32) inline constexpr SampleOffsets kSampleOffsets{
    {-2, 2, 2, -2, 0,  0, -2, 2,  -1, 1, 1, -1, 0, 0, -1, 1,  //
     -2, 2, 2, -2, -1, 1, 1,  -1, 0,  0, 0, 0,  0, 0, 0,  0},
    {-2, 2, -2, 2, -2, 2, 0,  0, -1, 1, -1, 1, -1, 1, 0, 0,  //
     -1, 1, -1, 1, -2, 2, -2, 2, 0,  0, 0,  0, 0,  0, 0, 0}};

[[nodiscard]] inline int sampleOffsetX(std::size_t i) {
  return static_cast<int>(kSampleOffsets.x[i]);
}
[[nodiscard]] inline int sampleOffsetY(std::size_t i) {
  return static_cast<int>(kSampleOffsets.y[i]);
}

}  // namespace fluidymation
