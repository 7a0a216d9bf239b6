#include "fluidymation/synthesis/previous_picture.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/shape_rules.h"
#include "fluidymation/synthesis/vote.h"
#include "synthesis/color_drift.h"

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

/// Slower movement is corrected more slowly, and rest not at all: the surface of what hardly moves
/// would else be as restless as that of what sweeps on.
float shareOfFullSpeed(float speedPx) {
  constexpr float kFullSpeedPx = 0.25F;  // of the finest level, in a frame
  return std::min(speedPx / kFullSpeedPx, 1.0F);
}

/// Whether something is remembered at a pixel that moves: there the film's colours have a say.
bool remembersInMotion(const TargetLevel& target, int x, int y) {
  return target.inside(x, y) && target.speed(x, y) > 0.0F && target.previous(x, y).exists();
}

/// The place of a match, moved into its frame where it lies outside.
Pixel nearestPlace(const ExemplarLevel& exemplar, const Match& match) {
  return {std::clamp(match.nearestX(), 0, exemplar.size().width - 1),
          std::clamp(match.nearestY(), 0, exemplar.size().height - 1)};
}

void setModulation(const ExemplarLevel& exemplar, float borderWidthPx,
                   const ModulationBoundsPx& bounds, const NearestNeighborField& shifted,
                   TargetLevel& target) {
  forEachRow(shifted.height(), [&](int y) {
    for (int x = 0; x < shifted.width(); ++x) {
      const Match& match = shifted(x, y);
      float& modulation = target.modulation(x, y);
      modulation = 0.0F;
      if (!match.exists() || !target.inside(x, y)) continue;
      const Pixel place = nearestPlace(exemplar, match);
      const float differencePx = modulationDifference(
          target.modulationDistancePx(x, y),
          exemplar.modulationDistancePx(place.x, place.y, match.frame), borderWidthPx);
      modulation = smoothstep(differencePx, bounds.upper, bounds.lower);
    }
  });
}

/// Changes colours as the film's do from the depths of their matches to those of their pixels.
void deepen(const ExemplarLevel& exemplar, float borderWidthPx, const PreviousRules& rules,
            const NearestNeighborField& shifted, TargetLevel& target) {
  forEachRow(shifted.height(), [&](int y) {
    for (int x = 0; x < shifted.width(); ++x) {
      const Match& match = shifted(x, y);
      if (!match.exists() || !remembersInMotion(target, x, y)) continue;
      const Pixel place = nearestPlace(exemplar, match);
      const int depthThere = exemplar.texel(place.x, place.y, match.frame).guides.edge;
      const int depthHere = target.guides(x, y).edge;
      const float share = std::min(rules.deepening * target.speed(x, y) / borderWidthPx, 1.0F);
      FixedLab& previous = target.previous(x, y);
      previous =
          changedBy(previous, share, rules.filmColors->change(match.frame, depthThere, depthHere));
    }
  });
}

/// What remembered colours are off the film's, of pixels with a match: it says of which frame.
ColorDrift driftOf(const DepthColors& filmColors, const NearestNeighborField& shifted,
                   const TargetLevel& target) {
  std::vector<DriftSums> ofRows(static_cast<std::size_t>(shifted.height()));
  forEachRow(shifted.height(), [&](int y) {
    for (int x = 0; x < shifted.width(); ++x) {
      const Match& match = shifted(x, y);
      if (!match.exists() || !remembersInMotion(target, x, y)) continue;
      const int depth = target.guides(x, y).edge;
      const Lab wanted = filmColors.mean(match.frame, depth);
      const Lab remembered = target.previous(x, y).lab();
      ofRows[static_cast<std::size_t>(y)].add(
          depth, {remembered.l - wanted.l, remembered.a - wanted.a, remembered.b - wanted.b},
          target.speed(x, y));
    }
  });
  DriftSums all;
  for (const DriftSums& row : ofRows) all.add(row);
  return ColorDrift(all);
}

/// Takes a share of the drift away from all colours.
void correctDrift(const ColorDrift& drift, float share, TargetLevel& target) {
  forEachRow(target.size().height, [&](int y) {
    for (int x = 0; x < target.size().width; ++x) {
      if (!remembersInMotion(target, x, y)) continue;
      FixedLab& previous = target.previous(x, y);
      previous = changedBy(previous, -share * shareOfFullSpeed(target.speed(x, y)),
                           drift.at(target.guides(x, y).edge));
    }
  });
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
  setModulation(exemplar, borderWidthPx, rules.bounds, shifted, target);
  if (rules.filmColors == nullptr) return;
  if (rules.deepening > 0.0F) deepen(exemplar, borderWidthPx, rules, shifted, target);
  if (rules.colorCorrection > 0.0F) {
    correctDrift(driftOf(*rules.filmColors, shifted, target), rules.colorCorrection, target);
  }
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
