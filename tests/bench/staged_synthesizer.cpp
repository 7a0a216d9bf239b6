#include "bench/staged_synthesizer.h"

#include <algorithm>
#include <utility>

#include "fluidymation/guides/local_thickness.h"
#include "fluidymation/synthesis/merge.h"
#include "fluidymation/synthesis/nnf_scaling.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/temporal.h"
#include "fluidymation/synthesis/vote.h"

namespace fluidymation::bench {
namespace {

// The numbers of random passes in the engine.
constexpr int kRandomFieldPass = -1;
constexpr int kRepairPass = -2;

/// How often a level is worked over.
struct Iterations {
  int optimization = 0;
  int patchmatch = 0;
  Candidates candidates = Candidates::kAll;
  int firstPass = 0;
};

int valueAt(const std::vector<int>& list, int level, int coarsest) {
  return list[std::min(static_cast<std::size_t>(coarsest - level), list.size() - 1)];
}

Iterations iterationsOf(const SynthesisOptions& options, int level, int coarsest, int frame) {
  if (level == 0 && coarsest > 0) {
    return {std::min(valueAt(options.optIterations, level, coarsest), 1), 1, Candidates::kNeighbors,
            frame % 2};
  }
  return {valueAt(options.optIterations, level, coarsest),
          valueAt(options.patchmatchIterations, level, coarsest)};
}

Mask paintedPixels(const GuideFrame& frame) {
  Mask painted(frame.mask.size());
  for (int y = 0; y < painted.height(); ++y) {
    for (int x = 0; x < painted.width(); ++x) {
      painted(x, y) = frame.mask(x, y) != 0 || frame.coverageAt(x, y) > 0.0F ? 1 : 0;
    }
  }
  return painted;
}

}  // namespace

StagedSynthesizer::StagedSynthesizer(const Exemplar& exemplar, const SynthesisOptions& options)
    : exemplar_(exemplar), options_(options) {
  for (int l = 0; l < exemplar.levelCount(); ++l) {
    expectedUse_.emplace_back(exemplar.level(l), options.occRadiusFrames);
  }
}

void StagedSynthesizer::paint(const GuideFrame& frame, StageClock& clock) {
  const int coarsest = exemplar_.levelCount() - 1;
  NearestNeighborField shifted = nnf_.empty() ? NearestNeighborField(frame.mask.size())
                                              : clock.time(Stage::kShift, kNoLevel, [&] {
                                                  return shift(exemplar_, frame, nnf_, &owed_);
                                                });
  const bool fresh = std::none_of(shifted.begin(), shifted.end(),
                                  [](const Match& match) { return match.exists(); });

  std::vector<GuideLevel> guides;
  clock.time(Stage::kPyramid, kNoLevel, [&] {
    guides.push_back(finestLevel(frame));
    guides.back().distance = stretchedDistance(frame.distance, exemplar_.level(0).borderWidthPx());
    for (int l = 1; l <= coarsest; ++l) guides.push_back(halve(guides.back()));
  });

  NearestNeighborField nnf(frame.mask.size());
  for (int l = coarsest; l >= 0 && countInside(frame.mask) > 0; --l) {
    TargetLevel target = clock.time(Stage::kTargetLevel, l, [&] {
      return TargetLevel(guides[static_cast<std::size_t>(l)], exemplar_.level(0).borderWidthPx(),
                         exemplar_.extentScale(), options_.shape);
    });
    nnf = optimizedField(l, nnf, shifted, fresh, target, clock);
  }
  static_cast<void>(clock.time(Stage::kPaintedVote, kNoLevel, [&] {
    return paintedVote(exemplar_.level(0), paintedPixels(frame), nnf, options_.paintedVote);
  }));
  nnf_ = std::move(nnf);
  ++frame_;
}

NearestNeighborField StagedSynthesizer::optimizedField(int level,
                                                       const NearestNeighborField& coarser,
                                                       const NearestNeighborField& shifted,
                                                       bool fresh, TargetLevel& target,
                                                       StageClock& clock) const {
  const ExemplarLevel& exemplar = exemplar_.level(level);
  const SearchProblem problem{exemplar, expectedUse_[static_cast<std::size_t>(level)], target,
                              options_, Place{frame_, level}};
  const int coarsest = exemplar_.levelCount() - 1;
  const Iterations count = iterationsOf(options_, level, coarsest, frame_);
  const DistanceWeights weights{options_.texWeight, options_.edgeGain * options_.distWeight,
                                options_.flowWeight, options_.prevWeight, options_.dirWeight};
  int pass = count.firstPass;
  const auto search = [&](const DistanceWeights& w, NearestNeighborField& nnf) {
    clock.time(Stage::kSearch, level, [&] {
      findNearestNeighbors(problem, w, count.patchmatch, pass, nnf, count.candidates);
    });
    // The one place for what a search counts: `Cost::counts` of this stage and level. The report
    // has columns for it as soon as there is any.
    pass += count.patchmatch;
  };
  const auto enlarged = [&] {
    return clock.time(Stage::kUpscale, level, [&] { return upscale(coarser, target.segment); });
  };
  const auto voteAgain = [&](const NearestNeighborField& nnf) {
    target.picture = clock.time(
        Stage::kVote, level, [&] { return std::move(vote(exemplar, target.segment, nnf).color); });
  };
  const auto repairAll = [&](int passNumber, NearestNeighborField& nnf) {
    clock.time(Stage::kRepair, level, [&] { repair(problem, passNumber, nnf); });
  };

  NearestNeighborField nnf(target.size());
  if (fresh && level == coarsest) {
    repairAll(kRandomFieldPass, nnf);
    search({0.0F, weights.dist, weights.flow, 0.0F, weights.dir}, nnf);
  } else if (fresh) {
    nnf = enlarged();
  } else {
    NearestNeighborField downscaled =
        clock.time(Stage::kDownscale, level, [&] { return downscale(shifted, level); });
    clock.time(Stage::kPrevious, level, [&] {
      const float borderWidthPx = exemplar.borderWidthPx();
      setPrevious(exemplar, borderWidthPx,
                  inPixels(options_.prevModulation, borderWidthPx, shifted.size()), downscaled,
                  target);
    });
    if (level == coarsest) {
      nnf = std::move(downscaled);
    } else {
      const NearestNeighborField upscaled = enlarged();
      nnf = clock.time(Stage::kMerge, level,
                       [&] { return merge(problem, weights, upscaled, downscaled, target); });
    }
  }
  repairAll(kRepairPass, nnf);
  voteAgain(nnf);
  for (int i = 0; i < count.optimization; ++i) {
    search(weights, nnf);
    voteAgain(nnf);
  }
  return nnf;
}

bool agree(const NearestNeighborField& a, const NearestNeighborField& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const Match& m, const Match& n) {
           return m.x == n.x && m.y == n.y && m.frame == n.frame &&
                  m.rotation.cosine == n.rotation.cosine && m.rotation.sine == n.rotation.sine;
         });
}

}  // namespace fluidymation::bench
