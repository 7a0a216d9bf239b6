#include "fluidymation/synthesis/merge.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/vote.h"

namespace fluidymation {

NearestNeighborField merge(const SearchProblem& problem, const DistanceWeights& weights,
                           NearestNeighborField upscaled, const NearestNeighborField& downscaled,
                           TargetLevel& target) {
  assert(&problem.target == &target);  // the errors have to see the pictures written here
  constexpr float kNever = std::numeric_limits<float>::infinity();
  // Where the fields agree there is nothing to decide.
  Image<float> bounds(target.size());
  forEachRow(target.size().height, [&](int y) {
    for (int x = 0; x < target.size().width; ++x) {
      if (!areAlike(upscaled(x, y), downscaled(x, y))) bounds(x, y) = kNever;
    }
  });
  target.picture = vote(problem.exemplar, target.segment, upscaled, problem.options.optVoteSigmaPx);
  const Image<float> upscaledErrors = matchErrors(problem, weights, upscaled, &bounds);

  // Where no window of the previous frame reaches, its picture is continued by the other one.
  forEachRow(target.size().height, [&](int y) {
    for (int x = 0; x < target.size().width; ++x) {
      if (target.previous(x, y).exists()) target.picture(x, y) = target.previous(x, y);
    }
  });
  forEachRow(target.size().height, [&](int y) {
    std::transform(bounds.row(y), bounds.row(y) + bounds.width(), upscaledErrors.row(y),
                   bounds.row(y), [](float bound, float error) { return std::min(bound, error); });
  });
  const Image<float> downscaledErrors = matchErrors(problem, weights, downscaled, &bounds);

  forEachRow(upscaled.height(), [&](int y) {
    for (int x = 0; x < upscaled.width(); ++x) {
      if (downscaledErrors(x, y) < upscaledErrors(x, y)) upscaled(x, y) = downscaled(x, y);
    }
  });
  return upscaled;
}

}  // namespace fluidymation
