#include "fluidymation/synthesis/previous_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/shape_rules.h"
#include "fluidymation/synthesis/vote.h"

namespace fluidymation {
namespace {

/// The mean of two colours by their weights.
FixedLab mixed(const FixedLab& a, float weightOfA, const FixedLab& b, float weightOfB) {
  const float shareOfB = weightOfB / (weightOfA + weightOfB);
  const auto mix = [shareOfB](std::int16_t u, std::int16_t v) {
    const auto from = static_cast<float>(u);
    const auto to = static_cast<float>(v);
    return static_cast<std::int16_t>(floorToInt(from + shareOfB * (to - from) + 0.5F));
  };
  return {mix(a.l, b.l), mix(a.a, b.a), mix(a.b, b.b), 1};
}

/// `color` changed by a share of `change`.
FixedLab changedBy(const FixedLab& color, float share, const Lab& change) {
  const Lab lab = color.lab();
  return FixedLab::of(
      {lab.l + share * change.l, lab.a + share * change.a, lab.b + share * change.b});
}

/// How much a colour counts that is so many standard deviations beyond what is trusted in full,
/// where the target moves by `speedPx` in this frame.
float trustIn(float deviationsBeyond, float speedPx) {
  // Slower movement forgets more slowly, and rest not at all: the surface of what hardly moves
  // would else be as restless as that of what sweeps on.
  constexpr float kFullSpeedPx = 0.25F;
  const float z = std::max(deviationsBeyond, 0.0F);
  return std::exp(-0.5F * z * z * std::min(speedPx / kFullSpeedPx, 1.0F));
}

}  // namespace

float smoothstep(float x, float l, float u) {
  const float v = std::clamp((x - l) / (u - l), 0.0F, 1.0F);
  return v * v * (3.0F - 2.0F * v);
}

ModulationBoundsPx inPixels(const ModulationBounds& bounds, float borderWidthPx, Size target) {
  float unitPx = 1.0F;
  switch (bounds.unit) {
    case ModulationUnit::kPixels:
      break;
    case ModulationUnit::kBorderWidths:
      unitPx = borderWidthPx;
      break;
    case ModulationUnit::kTargetSides:
      unitPx = static_cast<float>(std::max(target.width, target.height));
      break;
  }
  return {bounds.upper * unitPx, bounds.lower * unitPx};
}

void setPrevious(const ExemplarLevel& exemplar, float borderWidthPx, const PreviousRules& rules,
                 const NearestNeighborField& shifted, TargetLevel& target) {
  target.previous = vote(exemplar, target.segment, shifted, rules.voteSigmaPx);
  forEachRow(shifted.height(), [&](int y) {
    for (int x = 0; x < shifted.width(); ++x) {
      const Match& match = shifted(x, y);
      float& modulation = target.modulation(x, y);
      modulation = 0.0F;
      if (!match.exists() || !target.inside(x, y)) continue;
      const int sx = std::clamp(match.nearestX(), 0, exemplar.size().width - 1);
      const int sy = std::clamp(match.nearestY(), 0, exemplar.size().height - 1);
      const float differencePx =
          modulationDifference(target.modulationDistancePx(x, y),
                               exemplar.modulationDistancePx(sx, sy, match.frame), borderWidthPx);
      modulation = smoothstep(differencePx, rules.bounds.upper, rules.bounds.lower);
      FixedLab& previous = target.previous(x, y);
      const float speedPx = target.speed(x, y);
      if (rules.filmColors == nullptr || speedPx == 0.0F || !previous.exists()) continue;
      const int depthThere = exemplar.texel(sx, sy, match.frame).guides.edge;
      const int depthHere = target.guides(x, y).edge;
      previous = changedBy(previous, std::min(rules.deepening * speedPx / borderWidthPx, 1.0F),
                           rules.filmColors->change(match.frame, depthThere, depthHere));
      if (rules.outlierSigmas > 0.0F) {
        const float deviations =
            rules.filmColors->deviations(match.frame, depthHere, previous.lab());
        modulation *= trustIn(deviations - rules.outlierSigmas, speedPx);
      }
    }
  });
}

void setBothNeighbors(const ExemplarLevel& exemplar, float borderWidthPx,
                      const PreviousRules& rules, const NearestNeighborField& before,
                      const NearestNeighborField& after, TargetLevel& target) {
  // Where neither counts at the pixel itself, its neighbours' windows still read both alike.
  constexpr float kLeastWeight = 1.0F / 1024.0F;
  setPrevious(exemplar, borderWidthPx, rules, before, target);
  const Image<FixedLab> picture = std::move(target.previous);
  const Image<float> modulation = target.modulation.clone();
  setPrevious(exemplar, borderWidthPx, rules, after, target);
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (!picture(x, y).exists()) continue;
      FixedLab& color = target.previous(x, y);
      float& weight = target.modulation(x, y);
      color = color.exists() ? mixed(picture(x, y), modulation(x, y) + kLeastWeight, color,
                                     weight + kLeastWeight)
                             : picture(x, y);
      weight = std::max(weight, modulation(x, y));
    }
  });
}

}  // namespace fluidymation
