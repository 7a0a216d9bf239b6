#include "fluidymation/synthesis/merge.h"

#include <cassert>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/vote.h"

namespace fluidymation {

NearestNeighborField merge(const SearchProblem& problem, const DistanceWeights& weights,
                           const NearestNeighborField& upscaled,
                           const NearestNeighborField& downscaled, TargetLevel& target) {
  assert(&problem.target == &target);  // the errors have to see the pictures written here
  target.picture = vote(problem.exemplar, target.segment, upscaled).color;
  const Image<float> upscaledErrors = matchErrors(problem, weights, upscaled);

  // Where no window of the previous frame reaches, its picture is continued by the other one.
  const VotedPicture remembered = vote(problem.exemplar, target.segment, downscaled);
  forEachRow(target.size().height, [&](int y) {
    for (int x = 0; x < target.size().width; ++x) {
      if (remembered.exists(x, y) != 0) target.picture(x, y) = remembered.color(x, y);
    }
  });
  const Image<float> downscaledErrors = matchErrors(problem, weights, downscaled);

  NearestNeighborField merged = upscaled.clone();
  forEachRow(merged.height(), [&](int y) {
    for (int x = 0; x < merged.width(); ++x) {
      if (downscaledErrors(x, y) < upscaledErrors(x, y)) merged(x, y) = downscaled(x, y);
    }
  });
  return merged;
}

}  // namespace fluidymation
