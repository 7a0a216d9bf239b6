#include "fluidymation/synthesis/synthesizer.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/local_thickness.h"
#include "fluidymation/synthesis/change_blend.h"
#include "fluidymation/synthesis/depth_fit.h"
#include "fluidymation/synthesis/merge.h"
#include "fluidymation/synthesis/nnf_scaling.h"
#include "fluidymation/synthesis/painted_vote.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/shift.h"
#include "fluidymation/synthesis/vote.h"
#include "synthesis/random_passes.h"
#include "synthesis/timed_stage.h"

namespace fluidymation {
namespace {

/// Value of an iteration list on a level: coarsest first, the last one repeats (§4.5).
int valueAt(const std::vector<int>& list, int level, int coarsest) {
  const auto fromCoarsest = static_cast<std::size_t>(coarsest - level);
  return list[std::min(fromCoarsest, list.size() - 1)];
}

/// Every guide of a frame within a box.
/// @param from  what `frame` shows.
GuideFrame croppedGuides(const GuideFrame& frame, const Box& from, const Box& box) {
  const auto inBox = [&](const auto& image) { return recropped(image, from, box); };
  const auto optional = [&](const Image<float>& image) {
    return image.empty() ? Image<float>() : inBox(image);
  };
  GuideFrame part;
  part.mask = inBox(frame.mask);
  part.distance = inBox(frame.distance);
  part.flow = inBox(frame.flow);
  part.direction = inBox(frame.direction);
  part.accForward = inBox(frame.accForward);
  part.accBackward = inBox(frame.accBackward);
  part.diffusion = frame.diffusion;
  part.shape = optional(frame.shape);
  part.coverage = optional(frame.coverage);
  part.age = optional(frame.age);
  part.ageGrows = frame.ageGrows;
  return part;
}

template <typename T, typename Equal>
bool areEqual(const Image<T>& a, const Image<T>& b, const Equal& equal) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), equal);
}

/// Whether a frame shows what the one before it shows, and nothing has moved or aged on the way.
bool isHeld(const GuideFrame& frame, const GuideFrame& before) {
  const auto number = [](auto a, auto b) { return a == b; };
  const auto vector = [](Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; };
  return !frame.ageGrows && areEqual(frame.mask, before.mask, number) &&
         std::all_of(frame.flow.begin(), frame.flow.end(),
                     [](Vec2 v) { return v.x == 0.0F && v.y == 0.0F; }) &&
         areEqual(frame.distance, before.distance, number) &&
         areEqual(frame.direction, before.direction, vector) &&
         areEqual(frame.accForward, before.accForward, vector) &&
         areEqual(frame.accBackward, before.accBackward, vector) &&
         areEqual(frame.shape, before.shape, number) &&
         areEqual(frame.coverage, before.coverage, number) &&
         areEqual(frame.age, before.age, number);
}

/// Where ages are compared the votes of the search are as wide as the thesis': narrow ones keep to
/// the colours of old paint beside the brush (docs/decisions.md).
SynthesisOptions withRulesFor(const Exemplar& exemplar, SynthesisOptions options) {
  if (exemplar.comparesAges()) options.optVoteSigmaPx = 0.0F;
  return options;
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

Synthesizer::Synthesizer(const Exemplar& exemplar, SynthesisOptions options,
                         StageObserver* observer)
    : exemplar_(exemplar),
      options_(withRulesFor(exemplar, std::move(options))),
      observer_(observer),
      filmBegin_(exemplar.firstFrame()) {
  studyExemplar();
}

Image<Lab> Synthesizer::paint(const GuideFrame& frame) {
  paintPart(workOf(FramePart::whole(frame.mask.size()), frame));
  return wholeFrame(picture_, part());
}

void Synthesizer::paint(GuidePart&& frame) {
  GuidePart work = workOf(frame.part, frame.guides);
  frame = {};
  paintPart(std::move(work));
}

GuidePart Synthesizer::workOf(const FramePart& part, const GuideFrame& frame) const {
  // As far as a window of the coarsest level reaches, whose pixels are blocks of this size
  const int block = coarsestBlock();
  const Box painted = moved(boundingBox(paintedPixels(frame)), part.box.begin());
  const Box box = alignedTo(grown(painted, kPatchRadius * block, part.frame), block, part.frame);
  assert(joined(part.box, box) == part.box);
  return {{part.frame, box}, croppedGuides(frame, part.box, box)};
}

void Synthesizer::paintPart(GuidePart work) {
  const auto& [part, guides] = work;
  const auto& [size, box] = part;
  held_ = size == size_ && box == box_ && isHeld(guides, guides_);
  if (!held_) {
    nnf_ = recropped(nnf_, box_, box);
    owed_ = recropped(owed_, box_, box);
    size_ = size;
    box_ = box;
    picture_ = countInside(guides.mask) > 0 ? paintBox(guides) : Image<Lab>(box.size());
    if (countInside(guides.mask) == 0) nnf_ = NearestNeighborField(box.size());
    guides_ = std::move(work.guides);
  }
  ++frame_;
}

void Synthesizer::followFilm() {
  if (exemplar_.firstFrame() == filmBegin_) return;
  toFilmFrames(nnf_, filmBegin_);
  filmBegin_ = exemplar_.firstFrame();
  toHeldFrames(nnf_, filmBegin_, exemplar_.frameCount());
  studyExemplar();
}

void Synthesizer::studyExemplar() {
  expectedUse_.clear();
  filmColors_.clear();
  const bool looksAtDepths =
      (options_.prevDeepening > 0.0F || options_.prevColorCorrection > 0.0F) &&
      !exemplar_.comparesAges();
  for (int l = finestOptimized(); l < exemplar_.levelCount(); ++l) {
    expectedUse_.emplace_back(exemplar_.level(l), options_.occRadiusFrames);
    if (looksAtDepths) filmColors_.emplace_back(exemplar_.level(l));
  }
  memory_.clear();  // as large as what the count of uses takes
  memory_.resize(expectedUse_.size());
}

PreviousRules Synthesizer::previousRules(int level, Size frame) const {
  PreviousRules rules;
  rules.bounds = inPixels(options_.prevModulation, exemplar_.level(level).borderWidthPx(), frame);
  if (!filmColors_.empty()) {
    rules.filmColors = &filmColors_[static_cast<std::size_t>(level - finestOptimized())];
  }
  rules.deepening = options_.prevDeepening;
  rules.colorCorrection = options_.prevColorCorrection;
  rules.voteSigmaPx = options_.optVoteSigmaPx;
  return rules;
}

NearestNeighborField Synthesizer::nnf() const {
  NearestNeighborField nnf = wholeFrame(nnf_, part());
  toFilmFrames(nnf, filmBegin_);
  return nnf;
}

Image<Lab> Synthesizer::paintBox(const GuideFrame& frame) {
  followFilm();
  const int coarsest = exemplar_.levelCount() - 1;
  std::vector<TargetLevel> levels = timed(Stage::kLevels, 0, [&] { return levelsOf(frame); });
  const NearestNeighborField shifted = timed(Stage::kShift, 0, [&] {
    NearestNeighborField field =
        shift(exemplar_, frame, nnf_, options_.carriesMotion ? &owed_ : nullptr);
    fitDepths(exemplar_.level(0), levels.front(), frame.flow, options_.prevDepthReachFrames, field);
    return field;
  });
  const bool fresh = !hasAnyMatch(shifted);

  NearestNeighborField nnf;
  for (int l = coarsest; l >= 0; --l) {
    TargetLevel& target = levels[static_cast<std::size_t>(l)];
    nnf = l < finestOptimized() ? upscaled(nnf, l, target)
                                : optimizedField(l, nnf, shifted, fresh, target);
  }
  nnf_ = std::move(nnf);
  return timed(Stage::kPaint, 0,
               [&] { return paintedPicture(frame, levels.front(), shifted, nnf_); });
}

Image<Lab> Synthesizer::paintedPicture(const GuideFrame& guides, const TargetLevel& finest,
                                       const NearestNeighborField& previous,
                                       const NearestNeighborField& nnf) {
  Image<Lab> picture = paintedVote(exemplar_.level(0), paintedPixels(guides), nnf,
                                   options_.paintedVote, &finest.guides);
  blendChanges(exemplar_.level(0), finest, previous, nnf, options_.changeBlending,
               options_.paintedVote, picture);
  restoreDetail(exemplar_, filmDetail_, nnf, guides.mask, guides.distance,
                options_.detailRestoration, picture);
  return picture;
}

Painting Synthesizer::painting() const {
  Painting last;
  last.state = state();
  last.guides = croppedGuides(guides_, box_, box_);
  last.held = held_;
  return last;
}

SearchProblem Synthesizer::problemOf(const Work& work, int level, const TargetLevel& target) {
  const auto own = static_cast<std::size_t>(level - finestOptimized());
  return {exemplar_.level(level),
          expectedUse_[own],
          target,
          options_,
          Place{work.frame, level, {work.box.beginX >> level, work.box.beginY >> level}},
          &memory_[own]};
}

DistanceWeights Synthesizer::weights() const {
  return {options_.texWeight, options_.edgeGain * options_.distWeight, options_.flowWeight,
          options_.prevGain * options_.prevWeight, options_.dirWeight};
}

SynthesisState Synthesizer::state() const {
  SynthesisState state{frame_,           size_,     box_, nnf_.clone(), owed_.clone(),
                       picture_.clone(), filmBegin_};
  toFilmFrames(state.nnf, filmBegin_);
  for (std::size_t i = 0; i < state.owed.pixelCount(); ++i) {
    // Left over from before an empty frame; `shift` does not look at it
    if (!state.nnf.data()[i].exists()) state.owed.data()[i] = 0.0F;
  }
  return state;
}

void Synthesizer::restore(SynthesisState state, const GuideFrame& last) {
  restore(std::move(state), FramePart::whole(last.mask.size()), last);
}

void Synthesizer::restore(SynthesisState state, const GuidePart& last) {
  restore(std::move(state), last.part, last.guides);
}

void Synthesizer::restore(SynthesisState state, const FramePart& part, const GuideFrame& last) {
  assert(exemplar_.firstFrame() == state.filmBegin);
  followFilm();
  frame_ = state.frame;
  size_ = state.size;
  box_ = state.box;
  assert(state.nnf.size() == box_.size() && state.owed.size() == box_.size() &&
         state.picture.size() == box_.size());
  nnf_ = std::move(state.nnf);
  toHeldFrames(nnf_, filmBegin_, exemplar_.frameCount());
  owed_ = std::move(state.owed);
  guides_ = croppedGuides(last, part.box, box_);
  picture_ = std::move(state.picture);
}

std::vector<TargetLevel> Synthesizer::levelsOf(const GuideFrame& frame) const {
  const float borderWidthPx = exemplar_.level(0).borderWidthPx();
  GuideLevel guides = finestLevel(frame);
  if (options_.thinParts == ThinParts::kBody) {
    guides.distance = stretchedDistance(frame.distance, borderWidthPx);
  }
  std::vector<TargetLevel> levels;
  for (int l = 0; l < exemplar_.levelCount(); ++l) {
    if (l > 0) guides = halve(guides);
    levels.emplace_back(guides, borderWidthPx, exemplar_.extentScale(), options_.shape);
  }
  return levels;
}

NearestNeighborField Synthesizer::upscaled(const NearestNeighborField& coarser, int level,
                                           const TargetLevel& target) const {
  return timed(Stage::kUpscale, level, [&] { return upscale(coarser, target.segment); });
}

LevelIterations Synthesizer::iterations(int level, int frame) const {
  const int coarsest = exemplar_.levelCount() - 1;
  if (level == 0 && coarsest > 0) {
    // One sweep, or none: the field is almost settled by then, and the finest level has three times
    // as many pixels as all others together. Every other frame goes the other way, so that no
    // direction is preferred.
    const bool searched = options_.finestLevel == FinestLevel::kSearched;
    const int sweeps = std::min(valueAt(options_.optIterations, level, coarsest), 1);
    return {sweeps, 1, searched ? Candidates::kAll : Candidates::kNeighbors, frame % 2};
  }
  return {valueAt(options_.optIterations, level, coarsest),
          valueAt(options_.patchmatchIterations, level, coarsest)};
}

NearestNeighborField Synthesizer::optimizedField(int level, const NearestNeighborField& coarser,
                                                 const NearestNeighborField& shifted, bool fresh,
                                                 TargetLevel& target) {
  const ExemplarLevel& exemplar = exemplar_.level(level);
  const SearchProblem problem = problemOf({frame_, size_, box_}, level, target);
  const int coarsest = exemplar_.levelCount() - 1;
  const LevelIterations count = iterations(level, frame_);
  const DistanceWeights weights = this->weights();
  int pass = count.firstPass;
  Mask changing;
  const auto search = [&](const DistanceWeights& w, NearestNeighborField& nnf) {
    const SearchStatistics done = timed(Stage::kSearch, level, [&] {
      return findNearestNeighbors(problem, w, count.patchmatch, pass, nnf, count.candidates,
                                  &changing);
    });
    if (observer_ != nullptr) observer_->searched(level, done);
    pass += count.patchmatch;
  };

  // Start from the previous frame, from the coarser level, or where both exist from the better one.
  NearestNeighborField nnf(target.size());
  if (fresh) {
    if (level == coarsest) {
      repair(problem, kRandomFieldPass, nnf);
      // Guides alone place it (§4.2)
      search({0.0F, weights.dist, weights.flow, 0.0F, weights.dir}, nnf);
      changing = {};  // with colours all costs are different ones
    } else {
      nnf = upscaled(coarser, level, target);
    }
  } else {
    NearestNeighborField downscaled = timed(Stage::kPrevious, level, [&] {
      NearestNeighborField field = downscale(shifted, level);
      setPrevious(exemplar, exemplar.borderWidthPx(), previousRules(level, size_), field, target);
      return field;
    });
    if (level == coarsest) {
      nnf = std::move(downscaled);
    } else {
      NearestNeighborField enlarged = upscaled(coarser, level, target);
      nnf = timed(Stage::kMerge, level,
                  [&] { return merge(problem, weights, std::move(enlarged), downscaled, target); });
    }
  }
  timed(Stage::kRepair, level, [&] { repair(problem, kRepairPass, nnf); });

  // Alternate vote and search; the picture and the field improve each other (§3.2).
  for (int i = 0; i < count.optimization; ++i) {
    target.picture = timed(Stage::kVote, level, [&] {
      return vote(exemplar, target.segment, nnf, options_.optVoteSigmaPx);
    });
    search(weights, nnf);
  }
  return nnf;
}

}  // namespace fluidymation
