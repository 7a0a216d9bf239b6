#pragma once

#include "fluidymation/options.h"
#include "fluidymation/synthesis/depth_colors.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

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
  float colorCorrection = 0.0F;             ///< see SynthesisOptions::prevColorCorrection
  float voteSigmaPx = 0.0F;                 ///< see `vote`
};

/// Fills previous and modulation of `target` from the shifted matches at its level:
/// T^prev is their vote, m(q) = smoothstep(|T^dist - S^dist|, m_u, m_l) with both distances clamped
/// at the border width unless the level's ShapeRules say otherwise (unclamped, coherence is lost
/// deep inside every target that is thicker than the exemplar), 0 without match (§3.7).
///
/// Material that was painted as a rim and now lies inside would stay as pale as rims are, and
/// paintings of moving shapes lose their body colours frame by frame (docs/quality.md). Two rules
/// that the thesis does not have act against it where the target moves, one after the other.
///   1. At pixels with a match of their own, T^prev is changed as the exemplar's colours do from
///      the depth of the match to the pixel's, in the proportion of what the target moves there in
///      this frame to the border width, times `deepening`, at most by the whole difference.
///   2. From each T^prev `colorCorrection` times the drift at the pixel's depth is taken away: the
///      mean over the target, each pixel with a match weighted by what it moves, of T^prev less the
///      exemplar's mean colour at that depth in the frame of the pixel's match (`ColorDrift`). All
///      pixels of a depth are changed alike, so that the texture stays; less, in proportion, where
///      the target moves by less than a quarter of a pixel in this frame.
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
