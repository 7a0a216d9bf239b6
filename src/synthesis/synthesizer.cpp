#include "fluidymation/synthesis/synthesizer.h"

#include <algorithm>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/local_thickness.h"
#include "fluidymation/synthesis/merge.h"
#include "fluidymation/synthesis/nnf_scaling.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/temporal.h"
#include "fluidymation/synthesis/vote.h"

namespace fluidymation {
namespace {

// Numbers of the random passes besides the sweeps of the search, which count up from 0.
constexpr int kRandomFieldPass = -1;
constexpr int kRepairPass = -2;

/// Value of an iteration list on a level: coarsest first, the last one repeats (§4.5).
int valueAt(const std::vector<int>& list, int level, int coarsest) {
  const auto fromCoarsest = static_cast<std::size_t>(coarsest - level);
  return list[std::min(fromCoarsest, list.size() - 1)];
}

bool hasAnyMatch(const NearestNeighborField& nnf) {
  return std::any_of(nnf.begin(), nnf.end(), [](const Match& match) { return match.exists(); });
}

/// The mask, and what else the outline of a soft shape cuts.
Mask paintedPixels(const GuideFrame& frame) {
  Mask painted(frame.mask.size());
  forEachRow(painted.height(), [&](int y) {
    for (int x = 0; x < painted.width(); ++x) {
      painted(x, y) = frame.mask(x, y) != 0 || frame.coverageAt(x, y) > 0.0F ? 1 : 0;
    }
  });
  return painted;
}

}  // namespace

Synthesizer::Synthesizer(const Exemplar& exemplar, const SynthesisOptions& options)
    : exemplar_(exemplar), options_(options) {
  for (int l = finestOptimized(); l < exemplar.levelCount(); ++l) {
    expectedUse_.emplace_back(exemplar.level(l), options.occRadiusFrames);
  }
}

Image<Lab> Synthesizer::paint(const GuideFrame& frame) {
  const int coarsest = exemplar_.levelCount() - 1;
  NearestNeighborField shifted =
      nnf_.empty() ? NearestNeighborField(frame.mask.size())
                   : shift(exemplar_, frame, nnf_, options_.carriesMotion ? &owed_ : nullptr);
  const bool fresh = !hasAnyMatch(shifted);

  std::vector<GuideLevel> guides;
  guides.push_back(finestLevel(frame));
  if (options_.thinParts == ThinParts::kBody) {
    guides.back().distance = stretchedDistance(frame.distance, exemplar_.level(0).borderWidthPx());
  }
  for (int l = 1; l <= coarsest; ++l) guides.push_back(halve(guides.back()));

  NearestNeighborField nnf(frame.mask.size());
  Image<Lab> picture(frame.mask.size());
  if (countInside(frame.mask) > 0) {
    for (int l = coarsest; l >= 0; --l) {
      TargetLevel target(guides[static_cast<std::size_t>(l)], exemplar_.level(0).borderWidthPx(),
                         exemplar_.extentScale(), options_.shape);
      nnf = l < finestOptimized() ? upscale(nnf, target.segment)
                                  : optimizedField(l, nnf, shifted, fresh, target);
      if (l == 0) {
        picture =
            paintedVote(exemplar_.level(l), paintedPixels(frame), nnf, options_.paintedVote).color;
      }
    }
  }
  nnf_ = std::move(nnf);
  ++frame_;
  return picture;
}

LevelIterations Synthesizer::iterations(int level) const {
  const int coarsest = exemplar_.levelCount() - 1;
  if (level == 0 && coarsest > 0) {
    // One sweep, or none: the field is almost settled by then, and the finest level has three times
    // as many pixels as all others together. Every other frame goes the other way, so that no
    // direction is preferred.
    const bool searched = options_.finestLevel == FinestLevel::kSearched;
    const int sweeps = std::min(valueAt(options_.optIterations, level, coarsest), 1);
    return {sweeps, 1, searched ? Candidates::kAll : Candidates::kNeighbors, frame_ % 2};
  }
  return {valueAt(options_.optIterations, level, coarsest),
          valueAt(options_.patchmatchIterations, level, coarsest)};
}

NearestNeighborField Synthesizer::optimizedField(int level, const NearestNeighborField& coarser,
                                                 const NearestNeighborField& shifted, bool fresh,
                                                 TargetLevel& target) const {
  const ExemplarLevel& exemplar = exemplar_.level(level);
  const SearchProblem problem{exemplar,
                              expectedUse_[static_cast<std::size_t>(level - finestOptimized())],
                              target, options_, Place{frame_, level}};
  const int coarsest = exemplar_.levelCount() - 1;
  const LevelIterations count = iterations(level);
  const DistanceWeights weights{options_.texWeight, options_.edgeGain * options_.distWeight,
                                options_.flowWeight, options_.prevWeight, options_.dirWeight};
  int pass = count.firstPass;
  const auto search = [&](const DistanceWeights& w, NearestNeighborField& nnf) {
    findNearestNeighbors(problem, w, count.patchmatch, pass, nnf, count.candidates);
    pass += count.patchmatch;
  };

  // Start from the previous frame, from the coarser level, or where both exist from the better one.
  NearestNeighborField nnf(target.size());
  if (fresh) {
    if (level == coarsest) {
      repair(problem, kRandomFieldPass, nnf);
      // Guides alone place it (§4.2)
      search({0.0F, weights.dist, weights.flow, 0.0F, weights.dir}, nnf);
    } else {
      nnf = upscale(coarser, target.segment);
    }
  } else {
    NearestNeighborField downscaled = downscale(shifted, level);
    const float borderWidthPx = exemplar.borderWidthPx();
    setPrevious(exemplar, borderWidthPx,
                inPixels(options_.prevModulation, borderWidthPx, shifted.size()), downscaled,
                target);
    nnf = level == coarsest
              ? std::move(downscaled)
              : merge(problem, weights, upscale(coarser, target.segment), downscaled, target);
  }
  repair(problem, kRepairPass, nnf);

  // Alternate search and vote; the picture and the field improve each other (§3.2).
  target.picture = vote(exemplar, target.segment, nnf).color;
  for (int i = 0; i < count.optimization; ++i) {
    search(weights, nnf);
    target.picture = vote(exemplar, target.segment, nnf).color;
  }
  return nnf;
}

}  // namespace fluidymation
