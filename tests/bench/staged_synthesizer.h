#pragma once

#include <vector>

#include "bench/stage_clock.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/occurrence.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation::bench {

/// Paints as `Synthesizer` does with the standard look, and times every step: the same calls of the
/// engine's public functions in the same order, so that each is measured on the inputs it really
/// gets. Whether it still is the same is seen from the matches, which have to agree to the bit.
class StagedSynthesizer {
 public:
  /// @param exemplar  finished; must outlive this.
  /// @param options   of the standard look.
  StagedSynthesizer(const Exemplar& exemplar, const SynthesisOptions& options);

  /// Paints the target's next frame and adds what it cost to `clock`.
  void paint(const GuideFrame& frame, StageClock& clock);

  /// Full-resolution matches of the frame painted last.
  [[nodiscard]] const NearestNeighborField& nnf() const { return nnf_; }

 private:
  [[nodiscard]] NearestNeighborField optimizedField(int level, const NearestNeighborField& coarser,
                                                    const NearestNeighborField& shifted, bool fresh,
                                                    TargetLevel& target, StageClock& clock) const;

  const Exemplar& exemplar_;
  SynthesisOptions options_;
  std::vector<ExpectedUse> expectedUse_;
  NearestNeighborField nnf_;
  Image<float> owed_;  ///< see `shift`
  int frame_ = 0;
};

/// Whether two fields are the same, rotations included.
[[nodiscard]] bool agree(const NearestNeighborField& a, const NearestNeighborField& b);

}  // namespace fluidymation::bench
