#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation {

/// The vote that is painted. Twenty-five turned and interpolated windows blur whatever they do not
/// agree on; weighting a window by the distance of its centre and reading between pixels with a
/// sharp kernel keeps more of the medium's detail (docs/quality.md). Where a sigma is so small that
/// no window that covers a pixel has a weight, its nearest windows count. With
/// VoteOptions::seamWeight the seams between pieces of the exemplar then become slopes: a colour
/// depends on what is painted some pixels around, and may go beyond the exemplar's extremes.
/// @return  black where it is not wanted or no window covers it.
/// @param wanted  nonzero where the picture is wanted: a pixel next to the mask, which the outline
///   cuts, is seen by the windows of its neighbours.
/// @param guides  of the target's finest level, for VoteOptions::depthSigmaPx; null: without.
[[nodiscard]] Image<Lab> paintedVote(const ExemplarLevel& exemplar, const Mask& wanted,
                                     const NearestNeighborField& nnf, const VoteOptions& options,
                                     const Image<FixedGuides>* guides = nullptr);

}  // namespace fluidymation
