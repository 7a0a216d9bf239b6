#include "fluidymation/guides/drawn_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "fluidymation/guides/guide_stream.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

const Size kSize{120, 60};
constexpr int kFrames = 24;

using Frame = std::function<Mask(int)>;

bool drawsLines(const Frame& frame, int frameCount = kFrames, const FlowReader& readFlow = {}) {
  GuideOptions options;
  options.mask.blurSigmaPx = 0.0F;
  const GuideStream guides(
      frameCount, [&](int i) { return InputMask(frame(i)); }, options, readFlow);
  return guides.drawsLines();
}

/// A line of `lengthPx` from the left, 8 px wide.
Mask line(float lengthPx) {
  return test::maskOf(kSize, [=](int x, int y) {
    return x >= 10 && static_cast<float>(x) < 10.0F + lengthPx && y >= 26 && y < 34;
  });
}

Mask growing(int i) { return line(8.0F + 3.0F * static_cast<float>(i)); }

Mask disc(Vec2 centre, float radius) { return test::disc(kSize, centre, radius); }

TEST(DrawnLines, AreFoundWhereALineGrows) { EXPECT_TRUE(drawsLines(growing)); }

TEST(DrawnLines, AreFoundWithHoldsAndAnEmptyBeginning) {
  EXPECT_TRUE(drawsLines([](int i) { return i < 12 ? growing(i) : growing(std::max(11, i - 6)); }));
  EXPECT_TRUE(drawsLines([](int i) { return i == 0 ? Mask(kSize) : growing(i); }));
}

TEST(DrawnLines, AreFoundByFlowThatIsGiven) {
  const auto brush = [](int i, const Mask&) {
    Image<Vec2> flow(kSize);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < 3; ++x) flow(std::min(15 + 3 * i + x, kSize.width - 1), y) = {3.0F, 0.0F};
    }
    return flow;
  };
  EXPECT_TRUE(drawsLines(growing, kFrames, brush));
  const auto everywhere = [](int, const Mask&) { return Image<Vec2>(kSize, Vec2{3.0F, 0.0F}); };
  EXPECT_FALSE(drawsLines(growing, kFrames, everywhere)) << "what has come does not lie still";
}

TEST(DrawnLines, AreNotFoundInOtherAnimations) {
  EXPECT_FALSE(drawsLines([](int i) {
    return disc({20.0F + 3.0F * static_cast<float>(i), 30.0F}, 12.0F);
  })) << "a disc that moves";
  EXPECT_FALSE(drawsLines([](int i) {
    return disc({60.0F, 30.0F}, 4.0F + static_cast<float>(i));
  })) << "a disc that grows";
  EXPECT_FALSE(drawsLines([](int i) {
    return disc({60.0F, 30.0F}, 4.0F + static_cast<float>(std::min(i, 8)));
  })) << "a disc that grows and then holds";
  EXPECT_FALSE(drawsLines([](int i) { return growing(kFrames - 1 - i); })) << "a line that shrinks";
  EXPECT_FALSE(drawsLines([](int i) {
    return i < kFrames / 2 ? growing(i) : growing(kFrames - 1 - i);
  })) << "a line that comes and goes";
  EXPECT_FALSE(drawsLines([](int i) { return line(80.0F + static_cast<float>(i)); }))
      << "a line most of which is given";
  EXPECT_FALSE(drawsLines([](int) { return growing(9); })) << "a picture that does not change";
  EXPECT_FALSE(drawsLines([](int i) { return i < 3 ? Mask(kSize) : growing(20); }))
      << "one that is suddenly there";
}

TEST(DrawnLines, AreNotFoundWhereThereIsTooLittleToTell) {
  EXPECT_FALSE(DrawnLines{}.found());
  EXPECT_FALSE(drawsLines(growing, 1));
  EXPECT_FALSE(drawsLines(growing, 5));
  EXPECT_FALSE(drawsLines([](int) { return Mask(kSize); }));
  EXPECT_FALSE(drawsLines([](int) { return Mask(kSize, 1); }));
}

}  // namespace
}  // namespace fluidymation
