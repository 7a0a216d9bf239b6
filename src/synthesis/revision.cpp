#include <utility>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/depth_fit.h"
#include "fluidymation/synthesis/merge.h"
#include "fluidymation/synthesis/nnf_scaling.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/previous_picture.h"
#include "fluidymation/synthesis/shift.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "fluidymation/synthesis/vote.h"
#include "synthesis/random_passes.h"
#include "synthesis/timed_stage.h"

namespace fluidymation {

void Synthesizer::revise(const Painting& before, const Painting& after, Painting& current) {
  const Work work{current.state.frame - 1, current.state.size, current.state.box};
  const auto here = [&work](const auto& image, const Painting& of) {
    return recropped(image, of.state.box, work.box);
  };
  const auto matchesHere = [&](const Painting& of) {
    NearestNeighborField matches = here(of.state.nnf, of);
    toHeldFrames(matches, filmBegin_, exemplar_.frameCount());
    return matches;
  };
  followFilm();
  const GuideFrame& frame = current.guides;
  GuideFrame next;
  next.flow = here(after.guides.flow, after);
  next.direction = here(after.guides.direction, after);
  next.ageGrows = after.guides.ageGrows;
  Image<float> owed = here(after.state.owed, after);
  NearestNeighborField fromAfter = timed(Stage::kShift, 0, [&] {
    return shiftBack(exemplar_, frame.mask, next, matchesHere(after),
                     options_.carriesMotion ? &owed : nullptr);
  });
  if (!hasAnyMatch(fromAfter)) return;
  std::vector<TargetLevel> levels = timed(Stage::kLevels, 0, [&] { return levelsOf(frame); });
  Image<float> owedBefore = here(before.state.owed, before);
  NearestNeighborField fromBefore = timed(Stage::kShift, 0, [&] {
    return shift(exemplar_, frame, matchesHere(before),
                 options_.carriesMotion ? &owedBefore : nullptr);
  });
  timed(Stage::kShift, 0, [&] {
    fitDepths(exemplar_.level(0), levels.front(), frame.flow, options_.prevDepthReachFrames,
              fromBefore);
    fitDepths(exemplar_.level(0), levels.front(), next.flow, options_.prevDepthReachFrames,
              fromAfter);
  });

  const NearestNeighborField own = matchesHere(current);
  NearestNeighborField nnf;
  for (int l = exemplar_.levelCount() - 1; l >= 0; --l) {
    TargetLevel& target = levels[static_cast<std::size_t>(l)];
    nnf = l < finestOptimized() ? upscaled(nnf, l, target)
                                : revisedField(work, l, nnf, own, fromBefore, fromAfter, target);
  }
  current.state.picture = timed(
      Stage::kPaint, 0, [&] { return paintedPicture(frame, levels.front(), fromBefore, nnf); });
  current.state.nnf = std::move(nnf);
  current.state.filmBegin = filmBegin_;
  toFilmFrames(current.state.nnf, filmBegin_);
  if (!options_.carriesMotion) return;
  forEachRow(owed.height(), [&](int y) {
    for (int x = 0; x < owed.width(); ++x) {
      if (fromAfter(x, y).exists()) current.state.owed(x, y) = owed(x, y);
    }
  });
}

NearestNeighborField Synthesizer::revisedField(const Work& work, int level,
                                               const NearestNeighborField& coarser,
                                               const NearestNeighborField& own,
                                               const NearestNeighborField& before,
                                               const NearestNeighborField& after,
                                               TargetLevel& target) {
  const ExemplarLevel& exemplar = exemplar_.level(level);
  const SearchProblem problem = problemOf(work, level, target);
  const DistanceWeights weights = this->weights();
  const NearestNeighborField next = timed(Stage::kPrevious, level, [&] {
    NearestNeighborField field = downscale(after, level);
    setBothNeighbors(exemplar, exemplar.borderWidthPx(), previousRules(level, work.size),
                     downscale(before, level), field, target);
    return field;
  });
  NearestNeighborField nnf = timed(Stage::kMerge, level, [&] {
    return merge(problem, weights, downscale(own, level), next, target);
  });
  if (level < exemplar_.levelCount() - 1) {
    NearestNeighborField enlarged = upscaled(coarser, level, target);
    nnf = timed(Stage::kMerge, level,
                [&] { return merge(problem, weights, std::move(enlarged), nnf, target); });
  }
  timed(Stage::kRepair, level, [&] { repair(problem, kRepairPass, nnf); });

  // The field is nearly right already: more than one turn changes no figure beyond its noise.
  const LevelIterations count = iterations(level, work.frame);
  if (count.optimization == 0) return nnf;
  target.picture = timed(Stage::kVote, level, [&] {
    return vote(exemplar, target.segment, nnf, options_.optVoteSigmaPx);
  });
  const SearchStatistics done = timed(Stage::kSearch, level, [&] {
    return findNearestNeighbors(problem, weights, count.patchmatch,
                                kFirstPassOfRevision + count.firstPass, nnf, count.candidates);
  });
  if (observer_ != nullptr) observer_->searched(level, done);
  return nnf;
}

}  // namespace fluidymation
