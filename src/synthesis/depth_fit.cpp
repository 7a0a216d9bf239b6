#include "fluidymation/synthesis/depth_fit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Whether the exemplar's mask covers a place.
bool covers(const ExemplarLevel& exemplar, int x, int y, int frame) {
  const Size size = exemplar.size();
  return x >= 0 && y >= 0 && x < size.width && y < size.height && frame >= 0 &&
         frame < exemplar.frameCount() && exemplar.segment(x, y, frame) != Segment::kOutside;
}

/// How deep a place lies, up to the border's width: infinitely deep ones too.
float depthPx(const ExemplarLevel& exemplar, int x, int y, int frame) {
  return std::min(exemplar.modulationDistancePx(x, y, frame), exemplar.borderWidthPx());
}

/// The frame near `match` in which its place is about as deep as `wantedPx`.
/// @param mostPx  by how much its depth may change.
int fittingFrame(const ExemplarLevel& exemplar, float wantedPx, float mostPx, int reachFrames,
                 const Match& match) {
  const int x = match.nearestX();
  const int y = match.nearestY();
  if (!covers(exemplar, x, y, match.frame)) return match.frame;
  const float startPx = depthPx(exemplar, x, y, match.frame);
  struct Walk {
    int step;
    bool isOpen;
  };
  std::array<Walk, 2> walks{{{+1, true}, {-1, true}}};
  int best = match.frame;
  float leastPx = std::abs(wantedPx - startPx);
  for (int r = 1; r <= reachFrames && (walks[0].isOpen || walks[1].isOpen); ++r) {
    for (Walk& walk : walks) {
      if (leastPx <= kFittingDepthPx) return best;
      const int frame = match.frame + walk.step * r;
      walk.isOpen = walk.isOpen && covers(exemplar, x, y, frame);
      if (!walk.isOpen) continue;
      const float foundPx = depthPx(exemplar, x, y, frame);
      const float differencePx = std::abs(wantedPx - foundPx);
      if (differencePx > leastPx - kLeastDepthGainPx || std::abs(foundPx - startPx) > mostPx) {
        continue;
      }
      leastPx = differencePx;
      best = frame;
    }
  }
  return best;
}

}  // namespace

void fitDepths(const ExemplarLevel& finest, const TargetLevel& target, const Image<Vec2>& flow,
               int reachFrames, NearestNeighborField& shifted) {
  assert(reachFrames >= 0);
  assert(shifted.size() == target.size() && shifted.size() == flow.size());
  if (reachFrames == 0 || finest.comparesAges()) return;
  forEachRow(shifted.height(), [&](int y) {
    for (int x = 0; x < shifted.width(); ++x) {
      Match& match = shifted(x, y);
      const float movedPx = length(flow(x, y));
      if (movedPx == 0.0F || !match.exists() || !target.inside(x, y)) continue;
      const float wantedPx = std::min(target.modulationDistancePx(x, y), finest.borderWidthPx());
      match.frame =
          fittingFrame(finest, wantedPx, kMostDepthPerMovement * movedPx, reachFrames, match);
    }
  });
}

}  // namespace fluidymation
