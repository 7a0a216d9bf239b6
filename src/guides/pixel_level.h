#pragma once

#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"
#include "region_graph.h"

namespace fluidymation {

/// A piece of work; also one partial sum.
inline constexpr int kUnknownsAtATime = 8192;

/// Stands for a neighbour that is no unknown.
inline constexpr int kNoUnknown = -1;

/// Unknowns of one colour in one row whose neighbours are numbered alike: `begin + k` is the pixel
/// at x + 2 k, its left neighbour is unknown `left + k`, and so on. What is done to all of them is
/// done without looking at any link.
struct PixelSpan {
  int begin = 0;
  int end = 0;
  int left = kNoUnknown;
  int right = kNoUnknown;
  int up = kNoUnknown;
  int down = kNoUnknown;
  int given = 0;          ///< sides of each pixel at which a border pixel lies
  float diagonal = 0.0F;  ///< these sides and those with an unknown
  int x = 0;              ///< pixel of `begin`
  int y = 0;
};

/// Finest level of the hierarchy: interior pixels, red ones (x + y even) before black ones, each
/// colour in row order; all links weigh 1. See `GraphLevel` for the coarser ones.
struct PixelLevel {
  int redCount = 0;
  int count = 0;
  int redSpans = 0;
  std::vector<PixelSpan> spans;  ///< in the order of their unknowns, cut at each piece of work
  std::vector<int> firstSpan;    ///< of each piece of work, and the end
  std::vector<int> parent;       ///< unknown of the next coarser level

  [[nodiscard]] bool hasLinks() const;
};

/// Unknowns of `region` without its border pixels, and without parts that no border pixel touches.
[[nodiscard]] PixelLevel pixelLevel(const Mask& region, const Mask& isBorder);

/// Level of 2x2 blocks above `fine`, whose `parent` is filled in.
/// @param size    of the image.
/// @param origin  even: where the image's first pixel lies in the grid of blocks.
[[nodiscard]] GraphLevel coarserLevel(PixelLevel& fine, Size size, Pixel origin);

}  // namespace fluidymation
