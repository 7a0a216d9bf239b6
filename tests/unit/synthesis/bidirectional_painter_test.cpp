#include "fluidymation/synthesis/bidirectional_painter.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/synthetic_scene.h"
#include "synthesizer_fixture.h"

namespace fluidymation {
namespace {

/// A disc that shrinks in every frame, painted in an exemplar that grows.
class BidirectionalPainterTest : public ::testing::Test {
 protected:
  /// Frame numbers of the disc, one for each frame of the target: what stays the same is a hold.
  [[nodiscard]] std::vector<Painting> paint(const std::vector<int>& discFrames) const {
    Synthesizer synthesizer(exemplar_, options_);
    BidirectionalPainter painter(synthesizer);
    return paint(painter, discFrames, 0);
  }

  [[nodiscard]] std::vector<Painting> paint(BidirectionalPainter& painter,
                                            const std::vector<int>& discFrames,
                                            std::size_t first) const {
    std::vector<Painting> all;
    for (std::size_t i = first; i < discFrames.size(); ++i) {
      const GuidePart whole{FramePart::whole(disc_.size), guides(discFrames, i)};
      for (Painting& done : painter.paint(whole, i + 1 == discFrames.size())) {
        all.push_back(std::move(done));
      }
    }
    return all;
  }

  [[nodiscard]] std::vector<Painting> paintForward(const std::vector<int>& discFrames) const {
    Synthesizer synthesizer(exemplar_, options_);
    std::vector<Painting> all;
    for (std::size_t i = 0; i < discFrames.size(); ++i) {
      (void)synthesizer.paint(guides(discFrames, i));
      all.push_back(synthesizer.painting());
    }
    return all;
  }

  [[nodiscard]] GuideFrame guides(const std::vector<int>& discFrames, std::size_t i) const {
    GuideFrame frame = disc_.guides(discFrames[i]);
    if (i > 0 && discFrames[i] == discFrames[i - 1]) {
      frame.flow = Image<Vec2>(disc_.size);
    }
    return frame;
  }

  static bool looksAlike(const Painting& a, const Painting& b) {
    return sameBytes(a.state.picture, b.state.picture);
  }

  /// Frames 0 to `count` - 1 of the disc.
  static std::vector<int> moving(int count) {
    std::vector<int> frames;
    for (int i = 0; i < count; ++i) frames.push_back(i);
    return frames;
  }

  test::GrowingDisc film_{Size{60, 56}, {30.0F, 28.0F}, 10.0F, 1.5F, 8};
  test::GrowingDisc disc_{Size{64, 60}, {32.0F, 30.0F}, 27.0F, -0.8F, 20};
  Exemplar exemplar_ = test::discExemplar(film_, 2, kBorderWidthPx, 20);
  SynthesisOptions options_ = [] {
    SynthesisOptions options;
    options.optIterations = {2};
    options.patchmatchIterations = {2};
    return options;
  }();
};

TEST_F(BidirectionalPainterTest, FinishesEveryFrameOnceAndInOrder) {
  for (const int count : {1, 2, kWindowFrames - 1, kWindowFrames, kWindowFrames + 1,
                          2 * kWindowFrames, 2 * kWindowFrames + 3}) {
    const std::vector<Painting> painted = paint(moving(count));
    ASSERT_EQ(static_cast<int>(painted.size()), count);
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(painted[static_cast<std::size_t>(i)].state.frame, i + 1);
    }
  }
}

TEST_F(BidirectionalPainterTest, TheLastFrameOfAWindowStaysAndTheOthersChange) {
  const std::vector<int> frames = moving(kWindowFrames + 3);
  const std::vector<Painting> forward = paintForward(frames);
  const std::vector<Painting> both = paint(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool isLast = i + 1 == kWindowFrames || i + 1 == frames.size();
    EXPECT_EQ(looksAlike(forward[i], both[i]), isLast) << i;
  }
}

TEST_F(BidirectionalPainterTest, WhatIsRememberedOfBothNeighborsFitsItsDepths) {
  // The disc shrinks by more than its flow says
  const std::vector<int> frames{0, 4, 8};
  options_.prevDepthReachFrames = 0;
  const auto revised = [&](int reach) {
    std::vector<Painting> painted = paintForward(frames);
    SynthesisOptions options = options_;
    options.prevDepthReachFrames = reach;
    Synthesizer(exemplar_, options).revise(painted[0], painted[2], painted[1]);
    return std::move(painted[1]);
  };
  EXPECT_TRUE(looksAlike(revised(0), revised(0)));
  EXPECT_FALSE(looksAlike(revised(0), revised(20)));
}

TEST_F(BidirectionalPainterTest, WhatIsRevisedDissolvesToo) {
  const std::vector<int> frames{0, 1, 2};
  const auto revised = [&](float share) {
    options_.changeBlending = 0.0F;  // of what is painted first
    std::vector<Painting> painted = paintForward(frames);
    SynthesisOptions options = options_;
    options.changeBlending = share;
    Synthesizer(exemplar_, options).revise(painted[0], painted[2], painted[1]);
    return std::move(painted[1]);
  };
  const Painting atOnce = revised(0.0F);
  const Painting dissolved = revised(0.4F);
  EXPECT_TRUE(sameBytes(atOnce.state.nnf, dissolved.state.nnf));
  EXPECT_FALSE(looksAlike(atOnce, dissolved));
}

TEST_F(BidirectionalPainterTest, AHoldStaysOnePicture) {
  std::vector<int> frames = moving(20);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // Within a window; over its end; from its begin
    if (i == 3 || i == 4 || i == 7 || i == 8 || i == 9 || i == 17) frames[i] = frames[i - 1];
  }
  const std::vector<Painting> painted = paint(frames);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_EQ(looksAlike(painted[i], painted[i - 1]), frames[i] == frames[i - 1]) << i;
  }
}

TEST_F(BidirectionalPainterTest, GoesOnAfterAnyFrameAsIfNothingHadHappened) {
  std::vector<int> frames = moving(2 * kWindowFrames);
  frames[4] = frames[3];
  const std::vector<Painting> whole = paint(frames);
  EXPECT_EQ(whole[3].forward, nullptr);  // amid a hold
  for (const std::size_t done : {1U, 3U, 5U, 8U, 11U}) {
    SCOPED_TRACE(done);
    Synthesizer synthesizer(exemplar_, options_);
    ASSERT_NE(whole[done - 1].forward, nullptr);
    synthesizer.restore(whole[done - 1].forward->clone(), guides(frames, done - 1));
    BidirectionalPainter painter(synthesizer);
    const std::vector<Painting> rest = paint(painter, frames, done);
    ASSERT_EQ(rest.size(), frames.size() - done);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      EXPECT_TRUE(looksAlike(rest[i], whole[done + i])) << i;
    }
  }
}

TEST_F(BidirectionalPainterTest, EmptyFramesAreFine) {
  Synthesizer synthesizer(exemplar_, options_);
  BidirectionalPainter painter(synthesizer);
  std::vector<Painting> all;
  for (int i = 0; i < 6; ++i) {
    GuidePart whole{FramePart::whole(disc_.size), disc_.guides(i)};
    GuideFrame& frame = whole.guides;
    if (i == 0 || i == 3) {
      frame.mask = Mask(disc_.size);
      frame.flow = Image<Vec2>(disc_.size);
    }
    for (Painting& done : painter.paint(whole, i == 5)) all.push_back(std::move(done));
  }
  ASSERT_EQ(all.size(), 6U);
  for (const std::size_t empty : {0U, 3U}) EXPECT_FALSE(hasAnyMatch(all[empty].state.nnf));
  for (const std::size_t full : {1U, 2U, 4U, 5U}) EXPECT_TRUE(hasAnyMatch(all[full].state.nnf));
}

}  // namespace
}  // namespace fluidymation
