#include "fluidymation/synthesis/synthesizer.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "support/shapes.h"
#include "support/synthetic_scene.h"
#include "synthesizer_fixture.h"

namespace fluidymation {
namespace {

/// A disc at rest, painted by an exemplar with few iterations.
class HeldFrames : public SynthesizerTest {
 protected:
  HeldFrames() {
    options_.optIterations = {1};
    options_.patchmatchIterations = {1};
  }

  /// A frame with every guide that there may be; nothing moves.
  [[nodiscard]] GuideFrame still() const {
    GuideFrame guides = disc_.guides(0);
    for (Vec2& v : guides.flow) v = {};
    guides.shape = Image<float>(disc_.size, 0.5F);
    guides.coverage = Image<float>(disc_.size);
    for (std::size_t i = 0; i < guides.mask.pixelCount(); ++i) {
      guides.coverage.data()[i] = guides.mask.data()[i] != 0 ? 1.0F : 0.0F;
    }
    guides.age = Image<float>(disc_.size, 3.0F);
    return guides;
  }

  Exemplar exemplar_ = test::discExemplar(disc_, 3, kBorderWidthPx, 31);
  SynthesisOptions options_ = smallOptions();
};

TEST_F(HeldFrames, ShowTheSamePictureOfTheSameMatches) {
  options_.lambda = 8.0F;  // many matches would change in every frame
  Synthesizer synthesizer(exemplar_, options_);
  const Image<Lab> first = synthesizer.paint(still());
  const NearestNeighborField matches = synthesizer.nnf();
  EXPECT_FALSE(synthesizer.held()) << "there is none before";
  for (int frame = 1; frame < 4; ++frame) {
    const Image<Lab> again = synthesizer.paint(still());
    EXPECT_TRUE(synthesizer.held());
    EXPECT_TRUE(sameBytes(again, first));
    EXPECT_TRUE(sameBytes(synthesizer.nnf(), matches));
  }
}

TEST_F(HeldFrames, EndWithAnyDifferenceInAGuideAndBeginAnewAfterIt) {
  const Pixel inside{36, 32};
  const Pixel atTheRim{36, 32 - 14};
  ASSERT_EQ(still().mask(atTheRim.x, atTheRim.y), 0);
  const auto ends = [&](const char* what, const auto& change) {
    SCOPED_TRACE(what);
    Synthesizer synthesizer(exemplar_, options_);
    (void)synthesizer.paint(still());
    (void)synthesizer.paint(still());
    ASSERT_TRUE(synthesizer.held());
    GuideFrame guides = still();
    change(guides);
    (void)synthesizer.paint(guides);
    EXPECT_FALSE(synthesizer.held());
    (void)synthesizer.paint(still());
    EXPECT_FALSE(synthesizer.held()) << "what was before counts, not what was held";
    (void)synthesizer.paint(still());
    EXPECT_TRUE(synthesizer.held());
  };
  ends("mask", [&](GuideFrame& g) { g.mask(atTheRim.x, atTheRim.y) = 1; });
  ends("distance", [&](GuideFrame& g) { g.distance(inside.x, inside.y) += 0.01F; });
  ends("distance outside", [&](GuideFrame& g) { g.distance(atTheRim.x, atTheRim.y) -= 0.01F; });
  ends("direction", [&](GuideFrame& g) { g.direction(inside.x, inside.y) = {0.0F, 1.0F}; });
  ends("motion since the start",
       [&](GuideFrame& g) { g.accForward(inside.x, inside.y).x += 0.01F; });
  ends("motion to come", [&](GuideFrame& g) { g.accBackward(inside.x, inside.y).y += 0.01F; });
  ends("shape", [&](GuideFrame& g) { g.shape(inside.x, inside.y) = 0.6F; });
  ends("no shape", [](GuideFrame& g) { g.shape = Image<float>(); });
  ends("coverage", [&](GuideFrame& g) { g.coverage(atTheRim.x, atTheRim.y) = 0.25F; });
  ends("age", [&](GuideFrame& g) { g.age(inside.x, inside.y) = 4.0F; });
}

TEST_F(HeldFrames, EndWhereAnythingMovesOrAges) {
  GuideFrame moving = still();
  moving.flow(36, 32) = {0.0F, 1e-6F};
  GuideFrame ageing = still();
  ageing.ageGrows = true;
  for (const GuideFrame* guides : {&moving, &ageing}) {
    Synthesizer synthesizer(exemplar_, options_);
    (void)synthesizer.paint(still());
    for (int frame = 0; frame < 2; ++frame) {  // the second time all guides are those before
      (void)synthesizer.paint(*guides);
      EXPECT_FALSE(synthesizer.held());
    }
  }
}

TEST_F(HeldFrames, MayBeEmpty) {
  GuideFrame empty = still();
  std::fill(empty.mask.begin(), empty.mask.end(), std::uint8_t{0});
  std::fill(empty.coverage.begin(), empty.coverage.end(), 0.0F);
  Synthesizer synthesizer(exemplar_, options_);
  (void)synthesizer.paint(still());
  for (int frame = 0; frame < 2; ++frame) {
    EXPECT_EQ(synthesizer.paint(empty).size(), disc_.size);
    ASSERT_EQ(synthesizer.nnf().size(), disc_.size);
    EXPECT_FALSE(synthesizer.nnf()(36, 32).exists());
  }
  (void)synthesizer.paint(still());
  EXPECT_FALSE(synthesizer.held());
  EXPECT_TRUE(synthesizer.nnf()(36, 32).exists());
}

}  // namespace
}  // namespace fluidymation
