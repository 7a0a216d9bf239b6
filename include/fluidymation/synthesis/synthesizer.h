#pragma once

#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/occurrence.h"
#include "fluidymation/synthesis/patchmatch.h"
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
  Synthesizer(const Exemplar& exemplar, const SynthesisOptions& options);

  /// Paints the target's next frame; all frames have one size. An empty mask gives an empty
  /// picture, and the frame after it starts afresh.
  /// @return  the picture in CIELAB, meaningful inside the mask and where the shape covers part
  ///   of a pixel outside it.
  [[nodiscard]] Image<Lab> paint(const GuideFrame& frame);

  /// Full-resolution matches of the frame painted last.
  [[nodiscard]] const NearestNeighborField& nnf() const { return nnf_; }

 private:
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

  const Exemplar& exemplar_;
  SynthesisOptions options_;
  std::vector<ExpectedUse> expectedUse_;  ///< from `finestOptimized` on
  NearestNeighborField nnf_;
  Image<float> owed_;  ///< movement kept for later, see `shift`; px, size of the target
  int frame_ = 0;
};

}  // namespace fluidymation
