#include "fluidymation/synthesis/change_blend.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/painted_vote.h"
#include "fluidymation/synthesis/shape_rules.h"

namespace fluidymation {
namespace {

/// Where the frame before shows another piece of the exemplar.
[[nodiscard]] Mask changedPixels(const TargetLevel& target, const NearestNeighborField& previous,
                                 const NearestNeighborField& nnf) {
  Mask changed(nnf.size());
  forEachRow(nnf.height(), [&](int y) {
    for (int x = 0; x < nnf.width(); ++x) {
      const Match& before = previous(x, y);
      const bool hasBoth = target.inside(x, y) && before.exists() && nnf(x, y).exists();
      const bool hasChanged = hasBoth && !areAlike(before, nnf(x, y));
      changed(x, y) = hasChanged ? 1 : 0;
    }
  });
  return changed;
}

/// How much an old piece counts by its depth: 1 where it lies as deep as the pixel.
[[nodiscard]] float oldPieceTrust(const ExemplarLevel& finest, float wantedPx, const Match& match) {
  const int x = std::clamp(match.nearestX(), 0, finest.size().width - 1);
  const int y = std::clamp(match.nearestY(), 0, finest.size().height - 1);
  const float widthPx = finest.borderWidthPx();
  const float apart =
      modulationDifference(wantedPx, finest.modulationDistancePx(x, y, match.frame), widthPx) /
      (kChangeDepthSigmaWidths * widthPx);
  return std::exp(-0.5F * apart * apart);
}

}  // namespace

void blendChanges(const ExemplarLevel& finest, const TargetLevel& target,
                  const NearestNeighborField& previous, const NearestNeighborField& nnf,
                  float share, const VoteOptions& votes, Image<Lab>& picture) {
  assert(share >= 0.0F && share <= 1.0F);
  assert(nnf.size() == target.size() && picture.size() == target.size());
  if (share == 0.0F || previous.empty()) return;
  assert(previous.size() == target.size());
  const Mask changed = changedPixels(target, previous, nnf);
  if (countInside(changed) == 0) return;
  const Image<Lab> before = paintedVote(finest, changed, previous, votes, &target.guides);
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (changed(x, y) == 0) continue;
      const float weight =
          share * oldPieceTrust(finest, target.modulationDistancePx(x, y), previous(x, y));
      const Lab& old = before(x, y);
      Lab& color = picture(x, y);
      color = {color.l + weight * (old.l - color.l), color.a + weight * (old.a - color.a),
               color.b + weight * (old.b - color.b)};
    }
  });
}

}  // namespace fluidymation
