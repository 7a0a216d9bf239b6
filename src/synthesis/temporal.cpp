#include "fluidymation/synthesis/temporal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/vote.h"

namespace fluidymation {
namespace {

/// The frame of the exemplar, from `start` onwards in direction `step` (+1 or -1), at which the
/// motion accumulated at (x, y) since `start` comes closest to `amountPx`.
template <typename Accumulated>
int frameAfterMotion(const ExemplarLevel& exemplar, const Accumulated& accumulated, int x, int y,
                     int start, int step, float amountPx) {
  const Vec2 origin = accumulated(start)(x, y);
  int best = start;
  float bestError = amountPx;
  for (int k = start + step; k >= 0 && k < exemplar.frameCount(); k += step) {
    if (exemplar.segment(x, y, k) == Segment::kOutside) break;
    const float error = std::abs(amountPx - length(accumulated(k)(x, y) - origin));
    if (error < bestError) {
      bestError = error;
      best = k;
    }
  }
  return best;
}

}  // namespace

NearestNeighborField shift(const Exemplar& exemplar, const GuideFrame& target,
                           const NearestNeighborField& previous) {
  const ExemplarLevel& finest = exemplar.level(0);
  NearestNeighborField shifted(previous.size());
  forEachRow(previous.height(), [&](int y) {
    for (int x = 0; x < previous.width(); ++x) {
      const Match& match = previous(x, y);
      if (target.mask(x, y) == 0 || !match.exists()) continue;
      Match& moved = shifted(x, y);
      moved = match;
      const int sx = match.nearestX();
      const int sy = match.nearestY();
      // A match that was only upscaled may lie just outside the exemplar's mask: it has no motion.
      if (sx < 0 || sy < 0 || sx >= finest.size().width || sy >= finest.size().height ||
          finest.segment(sx, sy, match.frame) == Segment::kOutside) {
        continue;
      }
      const float amountPx = length(target.flow(x, y));
      const bool opposite =
          isOpposite(target.direction(x, y), finest.direction(sx, sy, match.frame), match.rotation);
      moved.frame =
          opposite
              ? frameAfterMotion(
                    finest, [&](int k) -> const Image<Vec2>& { return exemplar.accBackward(k); },
                    sx, sy, match.frame, -1, amountPx)
              : frameAfterMotion(
                    finest, [&](int k) -> const Image<Vec2>& { return exemplar.accForward(k); }, sx,
                    sy, match.frame, +1, amountPx);
    }
  });
  return shifted;
}

float smoothstep(float x, float l, float u) {
  const float v = std::clamp((x - l) / (u - l), 0.0F, 1.0F);
  return v * v * (3.0F - 2.0F * v);
}

void setPrevious(const ExemplarLevel& exemplar, float borderWidthPx, const ModulationBounds& bounds,
                 const NearestNeighborField& shifted, TargetLevel& target) {
  VotedPicture previous = vote(exemplar, target.segment, shifted);
  target.previous = std::move(previous.color);
  target.hasPrevious = std::move(previous.exists);
  forEachRow(shifted.height(), [&](int y) {
    for (int x = 0; x < shifted.width(); ++x) {
      const Match& match = shifted(x, y);
      target.modulation(x, y) = 0.0F;
      if (!match.exists() || !target.inside(x, y)) continue;
      const int sx = std::clamp(match.nearestX(), 0, exemplar.size().width - 1);
      const int sy = std::clamp(match.nearestY(), 0, exemplar.size().height - 1);
      const float sourceDistancePx =
          exemplar.pixel(sx, sy, match.frame)[kEdge] / kEdgeScale * borderWidthPx;
      target.modulation(x, y) =
          smoothstep(std::abs(target.clampedDistancePx(x, y) - sourceDistancePx), bounds.upperPx,
                     bounds.lowerPx);
    }
  });
}

}  // namespace fluidymation
