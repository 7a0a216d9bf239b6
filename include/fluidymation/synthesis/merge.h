#pragma once

#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/patch_distance.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// mergeNNF (thesis §3.9): per pixel the match with the smaller error; the upscaled one among
/// equals. Each field is measured against its own vote and with its own occurrence map; an illegal
/// or missing match loses. Where no window of the previous frame reaches, its picture is continued
/// by the vote of the other field.
/// @param problem     its `target` is `target`; the search's place does not matter.
/// @param upscaled    matches of the coarser level.
/// @param downscaled  matches of the previous frame, shifted; same size.
/// @param target      its `picture` is overwritten; everything else is read, `previous` as the vote
///   of `downscaled` with its colours corrected (`setPrevious`): where they have drifted, a match
///   of the previous frame pays for it, and the enlarged one wins more easily.
[[nodiscard]] NearestNeighborField merge(const SearchProblem& problem,
                                         const DistanceWeights& weights,
                                         NearestNeighborField upscaled,
                                         const NearestNeighborField& downscaled,
                                         TargetLevel& target);

}  // namespace fluidymation
