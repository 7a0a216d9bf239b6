#pragma once

#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/color.h"
#include "fluidymation/core/frame_part.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/depth_colors.h"
#include "fluidymation/synthesis/detail_restoration.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/occurrence.h"
#include "fluidymation/synthesis/painting.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/previous_picture.h"
#include "fluidymation/synthesis/stages.h"
#include "fluidymation/synthesis/synthesis_state.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// How often a level is worked over.
struct LevelIterations {
  int optimization = 0;  ///< search and vote, in turn
  int patchmatch = 0;    ///< sweeps of one search
  Candidates candidates = Candidates::kAll;
  int firstPass = 0;  ///< number of the first sweep: even ones go in row order, odd ones backwards
};

/// Paints a target frame by frame: Algorithm 2 of the thesis (§3.9, §4.2).
class Synthesizer {
 public:
  /// @param exemplar  finished; must outlive the synthesizer; with at least as many levels as
  ///   `coarsestLevel` of its size and the target's. It may advance in its film between frames:
  ///   matches in frames that it has let go of then move to the nearest one that it holds.
  /// @param observer  is told of the stages if given; must outlive the synthesizer.
  Synthesizer(const Exemplar& exemplar, SynthesisOptions options,
              StageObserver* observer = nullptr);

  /// Paints the target's next frame; all frames have one size. An empty mask gives an empty
  /// picture, and the frame after it starts afresh. A frame whose guides are those of the frame
  /// before, and in which nothing moves, gets that frame's picture: a hold stays still.
  /// @return  the picture in CIELAB, meaningful inside the mask and where the shape covers part
  ///   of a pixel outside it.
  [[nodiscard]] Image<Lab> paint(const GuideFrame& frame);
  /// The same of a frame's part that holds the shape and `marginPx` round it, as far as the frame
  /// reaches. The guides are freed before the search, which needs only those nearer to the mask.
  /// `part`, `picture` and `guides` tell what came of it.
  void paint(const GuidePart& frame) { paintPart(workOf(frame.part, frame.guides)); }
  void paint(GuidePart&& frame);

  /// How far beyond a frame's shape its guides are looked at, px.
  [[nodiscard]] int marginPx() const {
    return 1 + kPatchRadius * coarsestBlock() + coarsestBlock();
  }

  /// What was worked on of the frame painted last; its picture and guides there.
  [[nodiscard]] FramePart part() const { return {size_, box_}; }
  [[nodiscard]] const Image<Lab>& picture() const { return picture_; }
  [[nodiscard]] const GuideFrame& guides() const { return guides_; }

  /// Full-resolution matches of the frame painted last, in frames of the whole film; the size of
  /// its frame.
  [[nodiscard]] NearestNeighborField nnf() const;

  /// All of the frame painted last.
  [[nodiscard]] Painting painting() const;

  /// Paints a frame once more, now that the one after it is known too: what the next frame's
  /// matches say of this one counts as much as what the previous one's do (P§5, in the spirit of
  /// Benard et al., Stylizing Animation by Example, 2013). Does nothing where the frames have no
  /// pixel in common. Frames that are painted later do not notice.
  /// @param before   the frame before; one without matches where there is none.
  /// @param current  painted before; gets new matches and a new picture.
  void revise(const Painting& before, const Painting& after, Painting& current);

  /// Whether the frame painted last is the one before once more.
  [[nodiscard]] bool held() const { return held_; }

  /// What another synthesizer, of an equal exemplar and with equal options, needs to go on after
  /// the frame painted last.
  [[nodiscard]] SynthesisState state() const;

  /// Goes on after the frame that `state` was taken of: all that follows is painted as there.
  /// @param last  guides of that frame. The exemplar has to hold what it did then,
  ///   `SynthesisState::filmBegin`.
  void restore(SynthesisState state, const GuidePart& last);
  void restore(SynthesisState state, const GuideFrame& last);

  /// Paints the next frame afresh, as frame number `frame` (from 0) of the target.
  void startAfresh(int frame) { frame_ = frame; }

 private:
  /// Side of the square of pixels that a pixel of the coarsest level stands for.
  [[nodiscard]] int coarsestBlock() const { return 1 << (exemplar_.levelCount() - 1); }

  /// Which part of which frame is worked on.
  struct Work {
    int frame = 0;  ///< of the target, from 0
    Size size;      ///< of the whole frame
    Box box;
  };

  /// The picture that matches give the part `guides` of a frame.
  /// @param previous  the matches of the frame before, shifted to this one.
  [[nodiscard]] Image<Lab> paintedPicture(const GuideFrame& guides, const TargetLevel& finest,
                                          const NearestNeighborField& previous,
                                          const NearestNeighborField& nnf);

  /// Goes by what the exemplar holds now, where it has advanced.
  void followFilm();

  /// Paints what of the frame lies in `box_`; @return  the picture of that part.
  [[nodiscard]] Image<Lab> paintBox(const GuideFrame& frame);

  /// What is worked on of a frame.
  /// @param part  what `frame` shows of it.
  [[nodiscard]] GuidePart workOf(const FramePart& part, const GuideFrame& frame) const;
  void paintPart(GuidePart work);
  /// @param part  what `last` shows.
  void restore(SynthesisState state, const FramePart& part, const GuideFrame& last);

  /// The frame on all levels, finest first.
  [[nodiscard]] std::vector<TargetLevel> levelsOf(const GuideFrame& frame) const;
  [[nodiscard]] NearestNeighborField upscaled(const NearestNeighborField& coarser, int level,
                                              const TargetLevel& target) const;

  /// One level of one frame: initial field, then search and vote in turn, as often as `iterations`
  /// says.
  [[nodiscard]] NearestNeighborField optimizedField(int level, const NearestNeighborField& coarser,
                                                    const NearestNeighborField& shifted, bool fresh,
                                                    TargetLevel& target);

  /// Levels from this one on get a field of their own; a finer one is only upscaled and voted
  /// (§4.4.3).
  [[nodiscard]] int finestOptimized() const {
    return options_.finestLevel == FinestLevel::kUpscaled && exemplar_.levelCount() > 1 ? 1 : 0;
  }
  [[nodiscard]] LevelIterations iterations(int level, int frame) const;

  /// One level of a frame that is painted once more, see `revise`.
  /// @param own  the frame's matches as they were, full resolution; `before` and `after`: those of
  ///   its neighbours, shifted to it.
  [[nodiscard]] NearestNeighborField revisedField(const Work& work, int level,
                                                  const NearestNeighborField& coarser,
                                                  const NearestNeighborField& own,
                                                  const NearestNeighborField& before,
                                                  const NearestNeighborField& after,
                                                  TargetLevel& target);
  [[nodiscard]] SearchProblem problemOf(const Work& work, int level, const TargetLevel& target);

  [[nodiscard]] DistanceWeights weights() const;
  /// Of a level from `finestOptimized` on.
  /// @param frame  full-resolution size of the target's frames.
  [[nodiscard]] PreviousRules previousRules(int level, Size frame) const;
  /// Makes what depends on the exemplar's frames.
  void studyExemplar();

  /// Runs `body`, a stage on a level, and tells the observer of it.
  template <typename Body>
  auto timed(Stage stage, int level, const Body& body) const;

  const Exemplar& exemplar_;
  SynthesisOptions options_;
  StageObserver* observer_;
  std::vector<ExpectedUse> expectedUse_;  ///< from `finestOptimized` on
  std::vector<DepthColors> filmColors_;   ///< likewise; empty where they are not wanted
  std::vector<SearchMemory> memory_;      ///< likewise; scratch
  FilmDetail filmDetail_;

  // Of the frame painted last, as far as it lies in `box_`, a box round its mask: all other pixels
  // are left out of all work.
  Size size_;  ///< of the whole frame
  Box box_;
  GuideFrame guides_;
  NearestNeighborField nnf_;
  Image<float> owed_;  ///< movement kept for later, see `shift`; px
  Image<Lab> picture_;
  int filmBegin_ = 0;  ///< of the frames that the exemplar held for `nnf_`; see SynthesisState
  bool held_ = false;
  int frame_ = 0;
};

}  // namespace fluidymation
