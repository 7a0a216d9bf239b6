#include "fluidymation/synthesis/depth_fit.h"

#include <array>
#include <cassert>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/shape_rules.h"

namespace fluidymation {
namespace {

/// Whether the exemplar's mask covers a place.
bool covers(const ExemplarLevel& exemplar, int x, int y, int frame) {
  const Size size = exemplar.size();
  return x >= 0 && y >= 0 && x < size.width && y < size.height && frame >= 0 &&
         frame < exemplar.frameCount() && exemplar.segment(x, y, frame) != Segment::kOutside;
}

/// The frame near `match` in which its place is about as deep as `depthPx`.
int fittingFrame(const ExemplarLevel& exemplar, float depthPx, int reachFrames,
                 const Match& match) {
  const int x = match.nearestX();
  const int y = match.nearestY();
  if (!covers(exemplar, x, y, match.frame)) return match.frame;
  const auto differencePx = [&](int frame) {
    return modulationDifference(depthPx, exemplar.modulationDistancePx(x, y, frame),
                                exemplar.borderWidthPx());
  };
  int best = match.frame;
  float leastPx = differencePx(best);
  std::array<bool, 2> isOpen{true, true};  // forwards and backwards in time
  for (int r = 1; r <= reachFrames && (isOpen[0] || isOpen[1]); ++r) {
    for (const int side : {0, 1}) {
      if (leastPx <= kFittingDepthPx) return best;
      bool& open = isOpen[static_cast<std::size_t>(side)];
      const int frame = match.frame + (side == 0 ? r : -r);
      open = open && covers(exemplar, x, y, frame);
      if (!open) continue;
      const float foundPx = differencePx(frame);
      if (foundPx > leastPx - kLeastDepthGainPx) continue;
      leastPx = foundPx;
      best = frame;
    }
  }
  return best;
}

}  // namespace

void fitDepths(const ExemplarLevel& finest, const TargetLevel& target, const Image<Vec2>& flow,
               int reachFrames, NearestNeighborField& shifted) {
  assert(shifted.size() == target.size() && shifted.size() == flow.size());
  if (reachFrames == 0 || finest.comparesAges()) return;
  forEachRow(shifted.height(), [&](int y) {
    for (int x = 0; x < shifted.width(); ++x) {
      Match& match = shifted(x, y);
      const bool moves = flow(x, y).x != 0.0F || flow(x, y).y != 0.0F;
      if (!moves || !match.exists() || !target.inside(x, y)) continue;
      match.frame = fittingFrame(finest, target.modulationDistancePx(x, y), reachFrames, match);
    }
  });
}

}  // namespace fluidymation
