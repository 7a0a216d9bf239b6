#pragma once

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"

namespace fluidymation {

/// shiftNNF (thesis §3.7): every match of the previous frame keeps its place and moves along the
/// exemplar's time, to the frame whose accumulated motion differs from the match's by what the
/// target moves in this step: forwards along acc+, or backwards along acc- where the directions are
/// opposite. The smallest step wins ties; the walk stops where the place leaves the exemplar's mask
/// and at the sequence's ends. The documents print differences of norms for the target's
/// movement; they turn negative where motion turns back, and nothing would ever shift.
///
/// The exemplar has whole frames only, so that a step moves a match by somewhat more or less than
/// the target moved. In the thesis the rest is lost: a target slower than half the exemplar's
/// movement per frame never takes a step, and freezes. `owed` keeps the rest for the pixel's next
/// step.
///
/// Where ages are compared in the place of extents, every match moves by one frame forwards in
/// frames in which ages grow, and by none in the others; nothing is owed.
/// @param target  guides of the new frame, full resolution.
/// @param owed    if given: movement still to be made, px along the exemplar's time (negative:
///   backwards); the target's size, or empty at first. It is at most half of the exemplar's step
///   on which the walk passes the movement wanted. Pixels without a match owe nothing, nor do those
///   whose walk never gets that far: where the exemplar stands still, swings less, or ends. A pixel
///   at rest keeps what it owes and its frame.
/// @return  matches for pixels of the new mask that had one before.
[[nodiscard]] NearestNeighborField shift(const Exemplar& exemplar, const GuideFrame& target,
                                         const NearestNeighborField& previous,
                                         Image<float>* owed = nullptr);

/// The same step made backwards: the next frame's matches as they lay in the frame before it. What
/// moved forwards along the exemplar's time moves backwards, and the reverse.
/// @param mask  of the frame that the matches are moved to.
/// @param next  guides of the frame that `matches` belong to; of them only the flow, its direction
///   and whether ages grow are read.
/// @param owed  if given: of the next frame; what the frame before it would have owed afterwards.
/// @return  matches for pixels of `mask` that have one in the next frame.
[[nodiscard]] NearestNeighborField shiftBack(const Exemplar& exemplar, const Mask& mask,
                                             const GuideFrame& next,
                                             const NearestNeighborField& matches,
                                             Image<float>* owed = nullptr);

}  // namespace fluidymation
