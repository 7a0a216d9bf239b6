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
/// What another frame has to gain over the nearer ones, px.
inline constexpr float kLeastDepthGainPx = 0.25F;

/// Moves matches on along the exemplar's time, after `shift`, to where their places lie as deep
/// inside the exemplar's mask as their pixels do inside the target's. The shift alone follows the
/// accumulated motion, which inside a shape is a mean of what its edges do: the exemplar's edge
/// then comes closer to a place, or less close, than the target's edge does to the pixel, the edge
/// guide drives the match away, and the surface of a rim dissolves where the exemplar's stays. Not
/// in the thesis; docs/quality.md has the figures.
///
/// A place keeps its frame where depths agree within kFittingDepthPx. Else frames are tried one by
/// one away from it, the later one first, as long as the place stays inside the mask; one that
/// brings the depths closer by kLeastDepthGainPx is taken, until they agree or `reachFrames` are
/// tried. Depths are compared as by the temporal modulation (`modulationDifference`). Where nothing
/// moves nothing is changed: a hold stays still. Nor is it where ages are compared: there the frame
/// is the age, and new lines would look old in patches.
/// @param finest   the exemplar at full resolution.
/// @param target   guides of the frame that the matches were shifted to, of their size.
/// @param flow     what the target has moved in the step, px; of the same size.
/// @param reachFrames  >= 0; 0: nothing is changed.
void fitDepths(const ExemplarLevel& finest, const TargetLevel& target, const Image<Vec2>& flow,
               int reachFrames, NearestNeighborField& shifted);

}  // namespace fluidymation
