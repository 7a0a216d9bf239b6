#pragma once

#include <string>
#include <vector>

#include "fluidymation/synthesis/nnf.h"

namespace fluidymation {

/// Writes the matches of one frame: `folder`/NNNNN.nnf.pfm (x, y, the source frame's own number;
/// exact up to 2^24; NaN in all three where there is no match: a frame may have any number),
/// .theta.pfm (radians, 0 without match) and, for people, .nnf.png (red = x, green = frame, blue =
/// y, each relative to the exemplar's extent).
/// @param frameNumber    the target frame's own number; NNNNN has at least five digits.
/// @param sourceNumbers  own numbers of the exemplar's frames.
/// @throws Error naming the file that cannot be written.
void dumpNearestNeighborField(const std::string& folder, int frameNumber,
                              const NearestNeighborField& nnf,
                              const std::vector<int>& sourceNumbers, Size exemplarSize);

}  // namespace fluidymation
