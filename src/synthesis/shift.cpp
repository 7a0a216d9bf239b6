#include "fluidymation/synthesis/shift.h"

#include <algorithm>
#include <cmath>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// A walk along the exemplar's time at one place.
struct Walk {
  int frame = 0;            ///< where it ends
  float movedPx = 0.0F;     ///< how far from the start the place has moved by then
  float farthestPx = 0.0F;  ///< the largest distance that it could have moved
};

/// Walks from `start` in direction `step` (+1 or -1) to the frame at which the motion accumulated
/// at (x, y) comes closest to `amountPx`; the smallest step wins ties.
template <typename Accumulated>
Walk walk(const ExemplarLevel& exemplar, const Accumulated& accumulated, int x, int y, int start,
          int step, float amountPx) {
  const auto canStepFrom = [&](int k) {
    return k + step >= 0 && k + step < exemplar.frameCount() &&
           exemplar.segment(x, y, k + step) != Segment::kOutside;
  };
  const Vec2 origin = accumulated(start)(x, y);
  Walk best{start, 0.0F, 0.0F};
  float bestError = amountPx;
  for (int k = start; canStepFrom(k); k += step) {
    const float movedPx = length(accumulated(k + step)(x, y) - origin);
    best.farthestPx = std::max(best.farthestPx, movedPx);
    const float error = std::abs(amountPx - movedPx);
    if (error >= bestError) continue;
    bestError = error;
    best.frame = k + step;
    best.movedPx = movedPx;
  }
  return best;
}

/// Moves `match` along the exemplar's time by `amountPx`, negative: backwards. @return  what is
/// left to be moved.
float moveInTime(const Exemplar& exemplar, float amountPx, Match& match) {
  const int x = match.nearestX();
  const int y = match.nearestY();
  const bool backwards = amountPx < 0.0F;
  const Walk made = walk(
      exemplar.level(0),
      [&](int k) -> const Image<Vec2>& {
        return backwards ? exemplar.accBackward(k) : exemplar.accForward(k);
      },
      x, y, match.frame, backwards ? -1 : +1, std::abs(amountPx));
  match.frame = made.frame;
  // The walk passes the amount within one step of the exemplar, and one end of that step is at most
  // half of it away. What the exemplar has no movement for would add up without bound.
  if (made.farthestPx <= std::abs(amountPx)) return 0.0F;
  const float rest = std::abs(amountPx) - made.movedPx;
  return backwards ? -rest : rest;
}

/// A frame further (+1) or back (-1), while the place stays inside the mask and the film lasts.
void moveByOneFrame(const ExemplarLevel& exemplar, int step, Match& match) {
  const int next = match.frame + step;
  if (next >= 0 && next < exemplar.frameCount() &&
      exemplar.segment(match.nearestX(), match.nearestY(), next) != Segment::kOutside) {
    match.frame = next;
  }
}

enum class TimeDirection { kForwards, kBackwards };

/// @param mask  of the frame that the matches move to.
/// @param step  guides of the later one of the two frames.
NearestNeighborField shifted(const Exemplar& exemplar, const Mask& mask, const GuideFrame& step,
                             const NearestNeighborField& previous, TimeDirection time,
                             Image<float>* owed) {
  const bool backwards = time == TimeDirection::kBackwards;
  const ExemplarLevel& finest = exemplar.level(0);
  NearestNeighborField moved(previous.size());
  const Image<float> before =
      owed == nullptr || owed->empty() ? Image<float>(previous.size()) : owed->clone();
  if (owed != nullptr) *owed = Image<float>(previous.size());
  forEachRow(previous.height(), [&](int y) {
    for (int x = 0; x < previous.width(); ++x) {
      const Match& match = previous(x, y);
      if (mask(x, y) == 0 || !match.exists()) continue;
      Match& movedMatch = moved(x, y);
      movedMatch = match;
      const int sx = match.nearestX();
      const int sy = match.nearestY();
      // A match that was only upscaled may lie just outside the exemplar's mask: it has no motion.
      if (sx < 0 || sy < 0 || sx >= finest.size().width || sy >= finest.size().height ||
          finest.segment(sx, sy, match.frame) == Segment::kOutside) {
        continue;
      }
      if (finest.comparesAges()) {
        if (step.ageGrows) moveByOneFrame(finest, backwards ? -1 : +1, movedMatch);
        continue;
      }
      const float amountPx = length(step.flow(x, y));
      const bool opposite =
          isOpposite(step.direction(x, y), finest.direction(sx, sy, match.frame), match.rotation);
      const float prescribed = opposite != backwards ? -amountPx : amountPx;
      if (owed == nullptr) {
        moveInTime(exemplar, prescribed, movedMatch);
      } else if (amountPx == 0.0F) {
        (*owed)(x, y) = before(x, y);
      } else {
        (*owed)(x, y) = moveInTime(exemplar, before(x, y) + prescribed, movedMatch);
      }
    }
  });
  return moved;
}

}  // namespace

NearestNeighborField shift(const Exemplar& exemplar, const GuideFrame& target,
                           const NearestNeighborField& previous, Image<float>* owed) {
  return shifted(exemplar, target.mask, target, previous, TimeDirection::kForwards, owed);
}

NearestNeighborField shiftBack(const Exemplar& exemplar, const Mask& mask, const GuideFrame& next,
                               const NearestNeighborField& matches, Image<float>* owed) {
  return shifted(exemplar, mask, next, matches, TimeDirection::kBackwards, owed);
}

}  // namespace fluidymation
