#pragma once

#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/occurrence.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// Paints a target frame by frame: Algorithm 2 of the thesis (§3.9, §4.2).
class Synthesizer {
 public:
  /// @param exemplar  finished; must outlive the synthesizer; with at least as many levels as
  ///   `coarsestLevel` of its size and the target's.
  Synthesizer(const Exemplar& exemplar, const SynthesisOptions& options);

  /// Paints the target's next frame; all frames have one size. An empty mask gives an empty
  /// picture, and the frame after it starts afresh.
  /// @return  the picture in CIELAB, meaningful inside the mask and where the shape covers part of
  /// a
  ///   pixel outside it.
  [[nodiscard]] Image<Lab> paint(const GuideFrame& frame);

  /// Full-resolution matches of the frame painted last.
  [[nodiscard]] const NearestNeighborField& nnf() const { return nnf_; }

 private:
  /// One level of one frame: initial field, then search and vote in turn; `target.picture` holds
  /// the last vote.
  [[nodiscard]] NearestNeighborField optimizedField(int level, const NearestNeighborField& coarser,
                                                    const NearestNeighborField& shifted, bool fresh,
                                                    TargetLevel& target) const;

  /// The finest level is only upscaled and voted (§4.4.3), unless it is the only one.
  [[nodiscard]] int finestSearched() const { return exemplar_.levelCount() > 1 ? 1 : 0; }

  const Exemplar& exemplar_;
  SynthesisOptions options_;
  std::vector<ExpectedUse> expectedUse_;  ///< from `finestSearched` on
  NearestNeighborField nnf_;
  Image<float> owed_;  ///< movement kept for later, see `shift`; px, size of the target
  int frame_ = 0;
};

}  // namespace fluidymation
