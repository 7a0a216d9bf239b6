#include <gtest/gtest.h>

#include <cmath>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderWidthPx = 5.0F;

Rotation turnedBy(float degrees) {
  const float radians = degrees * 3.14159265F / 180.0F;
  return {std::cos(radians), std::sin(radians)};
}

TEST(Coherence, AMatchContinuesThePatchThatItsNeighbourWouldContinue) {
  const Match neighbor{20.0F, 30.0F, 4, turnedBy(35.0F)};
  const Match continuation = neighbor.moved({1.0F, 0.0F});
  EXPECT_TRUE(continues(continuation, continuation));
  Match turned = continuation;
  turned.rotation = turnedBy(45.0F);
  EXPECT_TRUE(continues(turned, continuation));
  turned.rotation = continuation.rotation.opposite();
  EXPECT_FALSE(continues(turned, continuation));
  Match later = continuation;
  later.frame = 5;
  EXPECT_FALSE(continues(later, continuation));
  EXPECT_FALSE(continues(neighbor, continuation));  // a pixel off
}

/// A disc painted in an exemplar of noise.
class CoherenceTest : public ::testing::Test {
 protected:
  CoherenceTest() {
    Random random({5, 0, 0, 0, 0, 0});
    for (FixedLab& color : target_.picture) {
      color = FixedLab::of({static_cast<float>(random.uniform(0, 100)), 0.0F, 0.0F});
    }
    options_.lambda = 0.0F;
  }

  [[nodiscard]] SearchProblem problem() const {
    return {exemplar_.level(0), expectedUse_, target_, options_, Place{}};
  }

  /// The field after so many sweeps from a random one.
  [[nodiscard]] NearestNeighborField searched(int sweeps) const {
    NearestNeighborField nnf(target_.size());
    repair(problem(), -1, nnf);
    findNearestNeighbors(problem(), weights_, sweeps, 0, nnf);
    return nnf;
  }

  /// Pairs of neighbours of which the first does not continue the second's patch.
  [[nodiscard]] int seams(const NearestNeighborField& nnf) const {
    int count = 0;
    const auto isSeam = [&](int x, int y, int dx, int dy) {
      if (!nnf.contains(x + dx, y + dy) || !nnf(x + dx, y + dy).exists()) return false;
      const Vec2 back{static_cast<float>(-dx), static_cast<float>(-dy)};
      return !continues(nnf(x, y), nnf(x + dx, y + dy).moved(back));
    };
    for (int y = 0; y < nnf.height(); ++y) {
      for (int x = 0; x < nnf.width(); ++x) {
        if (!nnf(x, y).exists()) continue;
        count += isSeam(x, y, 1, 0) ? 1 : 0;
        count += isSeam(x, y, 0, 1) ? 1 : 0;
      }
    }
    return count;
  }

  [[nodiscard]] double distances(const NearestNeighborField& nnf) const {
    const Image<float> errors = matchErrors(problem(), weights_, nnf);
    double sum = 0.0;
    for (const float error : errors) sum += std::isfinite(error) ? error : 0.0;
    return sum;
  }

  SynthesisOptions options_;
  test::GrowingDisc sourceDisc_{Size{60, 56}, {30.0F, 28.0F}, 18.0F, 1.0F, 6};
  test::GrowingDisc targetDisc_{Size{90, 80}, {45.0F, 40.0F}, 30.0F, 1.0F, 3};
  Exemplar exemplar_ = test::discExemplar(sourceDisc_, 0, kBorderWidthPx, 20);
  ExpectedUse expectedUse_{exemplar_.level(0), 10};
  TargetLevel target_{finestLevel(targetDisc_.guides(1)), kBorderWidthPx};
  DistanceWeights weights_{1.0F, 5.0F, 0.1F, 1.0F};
};

TEST_F(CoherenceTest, TheHeavierTheWeightTheFewerSeams) {
  options_.coherenceWeight = 0.0F;
  const int free = seams(searched(6));
  options_.coherenceWeight = 40.0F;
  const int some = seams(searched(6));
  options_.coherenceWeight = 400.0F;
  const int most = seams(searched(6));
  EXPECT_LT(some, 0.9 * free);
  EXPECT_LT(most, 0.8 * some);
}

TEST_F(CoherenceTest, EverySweepLowersTheDistancesWithTheWeightOfTheSeams) {
  options_.coherenceWeight = 60.0F;
  NearestNeighborField nnf = searched(0);
  const auto energy = [&] {
    // A pixel with four neighbours is charged a quarter of the weight for each seam
    return distances(nnf) + 0.25 * options_.coherenceWeight * seams(nnf);
  };
  double before = energy();
  for (int pass = 0; pass < 6; ++pass) {
    findNearestNeighbors(problem(), weights_, 1, pass, nnf);
    const double after = energy();
    EXPECT_LT(after, before) << "pass " << pass;
    before = after;
  }
}

}  // namespace
}  // namespace fluidymation
