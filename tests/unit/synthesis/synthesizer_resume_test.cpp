// Going on after a frame, with the state that it left or afresh.

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <vector>

#include "fluidymation/synthesis/synthesizer.h"
#include "support/shapes.h"
#include "support/synthetic_scene.h"
#include "synthesizer_fixture.h"

namespace fluidymation {
namespace {

/// The guides of a target that grows, holds, grows, vanishes for a frame and grows again.
std::vector<GuideFrame> eventfulTarget() {
  const Size size{60, 56};
  std::vector<Mask> masks;
  for (const float radius : {12.0F, 13.0F, 13.0F, 13.0F, 13.0F, 15.0F, 0.0F, 16.0F, 17.0F}) {
    masks.push_back(test::disc(size, {30.0F, 28.0F}, radius));
  }
  return test::guidesOf(masks, 0.0F);
}

TEST_F(SynthesizerTest, GoesOnAfterAnyFrameAsIfNeverStopped) {
  const Exemplar exemplar = test::discExemplar(disc_, 2, kBorderWidthPx, 3);
  for (const SynthesisOptions& options : {smallOptions(), SynthesisOptions{}}) {
    std::vector<Image<Lab>> expected;
    std::vector<SynthesisState> states;
    const std::vector<GuideFrame> target = eventfulTarget();
    int held = 0;
    Synthesizer whole(exemplar, options);
    for (const GuideFrame& frame : target) {
      expected.push_back(whole.paint(frame));
      states.push_back(whole.state());
      held += whole.held() ? 1 : 0;
    }
    EXPECT_GT(held, 0);
    for (std::size_t stop = 0; stop + 1 < target.size(); ++stop) {
      SCOPED_TRACE(stop);
      Synthesizer resumed(exemplar, options);
      resumed.restore(states[stop].clone(), target[stop]);
      for (std::size_t j = stop + 1; j < target.size(); ++j) {
        const Image<Lab> picture = resumed.paint(target[j]);
        ASSERT_EQ(
            std::memcmp(picture.data(), expected[j].data(), picture.pixelCount() * sizeof(Lab)), 0)
            << j;
      }
      EXPECT_EQ(resumed.state().frame, states.back().frame);
    }
  }
}

TEST_F(SynthesizerTest, AFrameThatStartsAfreshIsTheSameWhateverCameBefore) {
  const Exemplar exemplar = test::discExemplar(disc_, 2, kBorderWidthPx, 3);
  const std::vector<GuideFrame> target = eventfulTarget();
  Synthesizer whole(exemplar, smallOptions());
  for (int j = 0; j < 7; ++j) (void)whole.paint(target[static_cast<std::size_t>(j)]);
  const Image<Lab> expected = whole.paint(target[7]);  // after the empty frame
  Synthesizer afresh(exemplar, smallOptions());
  afresh.startAfresh(7);
  const Image<Lab> picture = afresh.paint(target[7]);
  EXPECT_EQ(std::memcmp(picture.data(), expected.data(), picture.pixelCount() * sizeof(Lab)), 0);
}

}  // namespace
}  // namespace fluidymation
