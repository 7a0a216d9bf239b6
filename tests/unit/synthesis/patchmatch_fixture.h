#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "fluidymation/synthesis/patchmatch.h"
#include "support/synthetic_scene.h"

namespace fluidymation {

inline constexpr float kBorderWidthPx = 5.0F;

/// A small search: the target is one frame of another disc with a texture of its own.
class PatchMatchTest : public ::testing::Test {
 protected:
  PatchMatchTest() { target_.picture = pictureFor(target_, 21); }

  [[nodiscard]] static Image<FixedLab> pictureFor(const TargetLevel& target, std::uint64_t seed) {
    return test::fixedPicture(test::randomTexture(target.size(), seed), target.segment);
  }

  [[nodiscard]] SearchProblem problem() const {
    return {exemplar_.level(0), expectedUse_, target_, options_, Place{3, 1, {}}};
  }

  [[nodiscard]] NearestNeighborField randomField() const {
    NearestNeighborField nnf(target_.size());
    repair(problem(), -1, nnf);
    return nnf;
  }

  [[nodiscard]] double energy(const NearestNeighborField& nnf) const {
    const Image<float> errors = matchErrors(problem(), weights_, nnf);
    double sum = 0.0;
    for (int y = 0; y < errors.height(); ++y) {
      for (int x = 0; x < errors.width(); ++x) {
        if (target_.inside(x, y)) sum += errors(x, y);
      }
    }
    return sum;
  }

  test::GrowingDisc sourceDisc_{Size{40, 36}, {20.0F, 18.0F}, 9.0F, 1.0F, 6};
  test::GrowingDisc targetDisc_{Size{90, 80}, {45.0F, 40.0F}, 30.0F, 1.0F, 3};
  Exemplar exemplar_ = test::discExemplar(sourceDisc_, 0, kBorderWidthPx, 20);
  ExpectedUse expectedUse_{exemplar_.level(0), 10};
  TargetLevel target_{finestLevel(targetDisc_.guides(1)), kBorderWidthPx};
  SynthesisOptions options_;
  DistanceWeights weights_{1.0F, 5.0F, 0.1F, 1.0F};
};

}  // namespace fluidymation
