#pragma once

#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/patchmatch.h"

namespace fluidymation {

/// The uniformity term of the patch distance, lambda Omega(window) / omega_best (thesis §2.5), per
/// unit of a window sum, for each segment of the target.
class UniformityScale {
 public:
  explicit UniformityScale(const SearchProblem& problem)
      : border_(scale(problem, Segment::kBorder)), interior_(scale(problem, Segment::kInterior)) {}

  [[nodiscard]] float operator()(Segment segment) const {
    return segment == Segment::kInterior ? interior_ : border_;
  }

 private:
  static float scale(const SearchProblem& problem, Segment segment) {
    const float best = problem.expectedUse.best(problem.target, segment);
    return best > 0.0F ? problem.options.lambda / (best * static_cast<float>(kPatchArea)) : 0.0F;
  }

  float border_;
  float interior_;
};

}  // namespace fluidymation
