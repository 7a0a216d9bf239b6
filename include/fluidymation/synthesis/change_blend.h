#pragma once

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// Sigma, in border widths, of the Gaussian by which an old piece counts less the more its depth
/// differs from the pixel's: where an edge has come nearer, colours of the inside are to go at
/// once.
inline constexpr float kChangeDepthSigmaWidths = 0.2F;

/// Lets a pixel whose match has changed show the old piece of the exemplar for one frame more, as a
/// share of its colour: pieces dissolve into each other in time, as they do in space along softened
/// seams. The old piece is read where and when the new frame would have continued it, so that it
/// has moved on as the film does, and is as sharp. A pixel that kept its match stays as it is, and
/// the search knows nothing of all this. A hold shows the same picture all the time, with what
/// dissolves in its first frame. A pixel outside the mask that only an outline cuts has no match,
/// and changes at once. Depths are those that the temporal modulation compares, as `fitDepths`
/// does. Not in the thesis; docs/quality.md has the figures.
/// @param finest    the exemplar at full resolution.
/// @param target    guides of the frame; the edge guide and the depths are read.
/// @param previous  matches of the frame before, shifted to this one (`shift`, `fitDepths`); of the
///   target's size; empty, or without matches, where there is no such frame. Where frames are
///   searched once more by the one after them, those that it had at first: a run has to go on alike
///   after any frame, and knows no others then.
/// @param nnf       matches of this frame, of which `picture` is the vote.
/// @param share     of the old piece where it lies as deep as the pixel, in [0, 1].
/// @param votes     how both pieces are voted, see `paintedVote`.
/// @param picture   of the target's size; changed inside the mask only.
void blendChanges(const ExemplarLevel& finest, const TargetLevel& target,
                  const NearestNeighborField& previous, const NearestNeighborField& nnf,
                  float share, const VoteOptions& votes, Image<Lab>& picture);

}  // namespace fluidymation
