#pragma once

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/depth_colors.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/target_level.h"

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

/// 0 for v <= 0, 1 for v >= 1, 3v^2 - 2v^3 between, with v = (x - l) / (u - l); l > u falls.
[[nodiscard]] float smoothstep(float x, float l, float u);

/// ModulationBounds in pixels.
struct ModulationBoundsPx {
  float upper = 0.0F;
  float lower = 0.0F;
};

/// @param target  full-resolution size of its frames.
[[nodiscard]] ModulationBoundsPx inPixels(const ModulationBounds& bounds, float borderWidthPx,
                                          Size target);

/// What is remembered of the frame before, and how much it counts.
struct PreviousRules {
  ModulationBoundsPx bounds;
  const DepthColors* filmColors = nullptr;  ///< of the exemplar's level; null: the next two are off
  float deepening = 0.0F;                   ///< see SynthesisOptions::prevDeepening
  float outlierSigmas = 0.0F;               ///< see SynthesisOptions::prevOutlierSigmas
  float voteSigmaPx = 0.0F;                 ///< see `vote`
};

/// Fills previous and modulation of `target` from the shifted matches at its level:
/// T^prev is their vote, m(q) = smoothstep(|T^dist - S^dist|, m_u, m_l) with both distances clamped
/// at the border width unless the level's ShapeRules say otherwise (unclamped, coherence is lost
/// deep inside every target that is thicker than the exemplar), 0 without match (§3.7).
///
/// Material that was painted as a rim and now lies inside would stay as pale as rims are, and
/// paintings of moving shapes lose their body colours frame by frame (docs/quality.md). Two rules
/// that the thesis does not have act against it, where the target moves and at pixels with a match
/// of their own. T^prev is changed as the exemplar's colours do from the depth of the pixel's match
/// to the pixel's own, in the proportion of what the target moves there in this frame to the border
/// width, times `deepening`, at most by the whole difference. And a colour that is then, at
/// that depth, z > outlierSigmas standard deviations from the exemplar's mean counts by
/// exp(-(z - outlierSigmas)^2 / 2) where the target moves by a quarter of a pixel in this frame or
/// more, by a root of it where it moves less.
void setPrevious(const ExemplarLevel& exemplar, float borderWidthPx, const PreviousRules& rules,
                 const NearestNeighborField& shifted, TargetLevel& target);

/// The same for a frame between two that are painted, by the matches of either shifted to it. Two
/// temporal terms, m_b |S - T^before|^2 + m_a |S - T^after|^2, are one for the mean of both
/// pictures weighted by their modulations, but for a constant; it gets the larger of the two
/// modulations, so that a frame between two weighs no more than one after another. What the frame
/// itself moves counts for the rules of both.
void setBothNeighbors(const ExemplarLevel& exemplar, float borderWidthPx,
                      const PreviousRules& rules, const NearestNeighborField& before,
                      const NearestNeighborField& after, TargetLevel& target);

}  // namespace fluidymation
