#pragma once

#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/color.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/occurrence.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/stages.h"
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
  ///   `coarsestLevel` of its size and the target's.
  /// @param observer  is told of the stages if given; must outlive the synthesizer.
  Synthesizer(const Exemplar& exemplar, const SynthesisOptions& options,
              StageObserver* observer = nullptr);

  /// Paints the target's next frame; all frames have one size. An empty mask gives an empty
  /// picture, and the frame after it starts afresh. A frame whose guides are those of the frame
  /// before, and in which nothing moves, gets that frame's picture: a hold stays still.
  /// @return  the picture in CIELAB, meaningful inside the mask and where the shape covers part
  ///   of a pixel outside it.
  [[nodiscard]] Image<Lab> paint(const GuideFrame& frame);

  /// Full-resolution matches of the frame painted last; the size of its frame.
  [[nodiscard]] NearestNeighborField nnf() const { return recropped(nnf_, box_, whole(size_)); }

  /// Whether the frame painted last is the one before once more.
  [[nodiscard]] bool held() const { return held_; }

 private:
  [[nodiscard]] static Box whole(Size size) { return {0, 0, size.width, size.height}; }

  /// Paints what of the frame lies in `box_`; @return  the picture of that part.
  [[nodiscard]] Image<Lab> paintBox(const GuideFrame& frame);

  /// The frame on all levels, finest first.
  [[nodiscard]] std::vector<TargetLevel> levelsOf(const GuideFrame& frame) const;
  [[nodiscard]] NearestNeighborField upscaled(const NearestNeighborField& coarser, int level,
                                              const TargetLevel& target) const;

  /// One level of one frame: initial field, then search and vote in turn, as often as `iterations`
  /// says.
  [[nodiscard]] NearestNeighborField optimizedField(int level, const NearestNeighborField& coarser,
                                                    const NearestNeighborField& shifted, bool fresh,
                                                    TargetLevel& target) const;

  /// Levels from this one on get a field of their own; a finer one is only upscaled and voted
  /// (§4.4.3).
  [[nodiscard]] int finestOptimized() const {
    return options_.finestLevel == FinestLevel::kUpscaled && exemplar_.levelCount() > 1 ? 1 : 0;
  }
  [[nodiscard]] LevelIterations iterations(int level) const;

  /// Runs `body`, a stage on a level, and tells the observer of it.
  template <typename Body>
  auto timed(Stage stage, int level, const Body& body) const;

  const Exemplar& exemplar_;
  SynthesisOptions options_;
  StageObserver* observer_;
  std::vector<ExpectedUse> expectedUse_;      ///< from `finestOptimized` on
  mutable std::vector<SearchMemory> memory_;  ///< likewise; scratch

  // Of the frame painted last, as far as it lies in `box_`, a box round its mask: all other pixels
  // are left out of all work.
  Size size_;  ///< of the whole frame
  Box box_;
  GuideFrame guides_;
  NearestNeighborField nnf_;
  Image<float> owed_;  ///< movement kept for later, see `shift`; px
  Image<Lab> picture_;
  bool held_ = false;
  int frame_ = 0;
};

}  // namespace fluidymation
