#pragma once

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// Depths that differ by no more count as equal when matches are fitted, px: the distance to the
/// edge of a hard mask is known no better.
inline constexpr float kFittingDepthPx = 0.5F;
/// What a frame has to gain over the nearer ones, px: half of that, so that a match does not wander
/// off in time for the mask's jitter.
inline constexpr float kLeastDepthGainPx = 0.25F;
/// By how many times what the target moves in a frame the depth of a match may change with it: an
/// edge that comes nearer by a pixel moves the shape's inside by a part of that only.
inline constexpr float kMostDepthPerMovement = 4.0F;

/// Moves matches on along the exemplar's time, after `shift`, to where their places lie as deep
/// inside the exemplar's mask as their pixels do inside the target's. The shift alone follows the
/// accumulated motion, which inside a shape is a mean of what its edges do: the exemplar's edge
/// then comes closer to a place, or less close, than the target's edge does to the pixel, the edge
/// guide drives the match away, and the surface of a rim dissolves where the exemplar's stays. Not
/// in the thesis; docs/quality.md has the figures.
///
/// A place keeps its frame where depths agree within kFittingDepthPx. Else frames are tried one by
/// one away from it, the later one first, in either direction as long as the place stays inside the
/// mask; each that brings the depths closer by kLeastDepthGainPx than those before is taken, until
/// they agree or `reachFrames` are tried. Depths are the distances that the temporal modulation
/// compares, up to the border's width; where thin parts are stretched (`stretchedDistance`) the
/// target's are, and a pixel of theirs is several of depth. The depth changes by at most
/// kMostDepthPerMovement times what the pixel moves: a hold stays still, and what hardly moves
/// hardly changes. Where ages are compared nothing is changed: there the frame is the age, and new
/// lines would look old in patches.
/// @param finest   the exemplar at full resolution.
/// @param target   guides of the frame that the matches were shifted to.
/// @param flow     what the target has moved in the step, px; of the target's size.
/// @param reachFrames  >= 0; 0: nothing is changed.
/// @param shifted  the matches, of the target's size; their frames alone are changed.
void fitDepths(const ExemplarLevel& finest, const TargetLevel& target, const Image<Vec2>& flow,
               int reachFrames, NearestNeighborField& shifted);

}  // namespace fluidymation
