#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/guides/material_age.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

const Size kSize{131, 97};

struct PartCase {
  const char* name;
  bool soft;
  float shapeBlurRadiusPx;  ///< 0: none
  int marginPx;
};

/// A small disc that appears, rests, moves out over the frame's corner, fills the frame and is
/// gone.
std::vector<Image<float>> journey(bool soft) {
  std::vector<Image<float>> frames;
  const auto add = [&](Image<float> coverage) {
    frames.push_back(soft ? test::eightBit(coverage)
                          : InputMask(InputMask(std::move(coverage), true).cut()).coverage);
  };
  add(Image<float>(kSize));
  for (const float x : {61.0F, 61.0F, 61.0F, 64.3F, 68.7F})
    add(test::softDisc(kSize, {x, 47.4F}, 9.6F));
  for (const float step : {0.0F, 9.0F, 17.0F, 23.0F}) {
    add(test::softDisc(kSize, {110.0F + step, 80.0F + step}, 14.3F));
  }
  add(Image<float>(kSize, 1.0F));
  add(Image<float>(kSize));
  return frames;
}

class GuideParts : public ::testing::TestWithParam<PartCase> {};

/// The part of a frame is what there is of it, bit for bit, in the whole frame.
TEST_P(GuideParts, AreWhatTheWholeFrameShowsThere) {
  const PartCase& tested = GetParam();
  const std::vector<Image<float>> frames = journey(tested.soft);
  const auto count = static_cast<int>(frames.size());
  GuideOptions options;
  options.mask = {1.0F, 0.4F};
  options.timeBlurSigmaFrames = 0.5F;
  if (tested.shapeBlurRadiusPx > 0.0F) options.shapeBlurRadiusPx = tested.shapeBlurRadiusPx;
  const auto input = [&](int i) {
    return InputMask(frames[static_cast<std::size_t>(i)].clone(), tested.soft);
  };
  GuideStream whole(count, input, options);
  GuideStream parts(count, input, options);
  TargetAges wholeAges;
  TargetAges partAges;
  int small = 0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const GuideFrame expected = whole.next();
    const GuidePart part = parts.nextPart(tested.marginPx);
    const Box& box = part.part.box;
    ASSERT_EQ(part.part.frame, kSize);
    const Box inside = boundingBox(expected.mask);
    EXPECT_EQ(joined(box, grown(inside, tested.marginPx, kSize)), box);
    EXPECT_EQ(inside.empty(), box.empty());
    if (box.size().width < kSize.width / 2) ++small;
    EXPECT_TRUE(test::equalEverywhere(cropped(expected.mask, box), part.guides.mask));
    EXPECT_EQ(countInside(expected.mask), countInside(part.guides.mask));
    const auto same = [&](const auto& all, const auto& shown) {
      return test::nearEverywhere(cropped(all, box), shown, 0.0F);
    };
    EXPECT_TRUE(same(expected.distance, part.guides.distance));
    EXPECT_TRUE(same(expected.flow, part.guides.flow));
    EXPECT_TRUE(same(expected.direction, part.guides.direction));
    EXPECT_TRUE(same(expected.accForward, part.guides.accForward));
    EXPECT_TRUE(same(expected.accBackward, part.guides.accBackward));
    EXPECT_EQ(expected.diffusion.cycles, part.guides.diffusion.cycles);
    EXPECT_EQ(part.guides.shape.pixelCount(),
              options.shapeBlurRadiusPx ? part.guides.mask.pixelCount() : 0U);
    if (options.shapeBlurRadiusPx) {
      EXPECT_TRUE(same(expected.shape, part.guides.shape));
    }
    ASSERT_EQ(expected.coverage.empty(), !tested.soft);
    if (tested.soft) {
      EXPECT_TRUE(same(expected.coverage, part.guides.coverage));
      const Box covered = boundingBox(expected.coverage, [](float c) { return c > 0.0F; });
      EXPECT_EQ(joined(box, covered), box) << "all that is covered is shown";
    }
    const Image<float> ages = wholeAges.next(expected.mask);
    EXPECT_TRUE(same(ages, partAges.next(part.guides.mask, box)));
    EXPECT_EQ(wholeAges.haveGrown(), partAges.haveGrown());
  }
  EXPECT_GE(small, 7) << "nothing was left out";
}

/// Far out a place is a large number, and what is computed from it is rounded.
TEST(GuidePartsFarOut, HaveTheDistancesOfTheWholeFrame) {
  constexpr Size kWide{3000, 60};
  GuideOptions options;
  options.mask = {1.0F, 0.4F};
  const auto input = [&](int i) {
    const float step = 0.37F * static_cast<float>(i);
    return InputMask(
        test::eightBit(test::softDisc(kWide, {2871.3F + step, 31.7F - step}, 15.6F + step)), true);
  };
  constexpr int kFrames = 6;
  GuideStream whole(kFrames, input, options);
  GuideStream parts(kFrames, input, options);
  for (int i = 0; i < kFrames; ++i) {
    const GuideFrame expected = whole.next();
    const GuidePart part = parts.nextPart(4);
    EXPECT_LT(part.part.box.size().width, 100);
    EXPECT_TRUE(test::nearEverywhere(cropped(expected.distance, part.part.box),
                                     part.guides.distance, 0.0F));
    EXPECT_TRUE(test::nearEverywhere(cropped(expected.coverage, part.part.box),
                                     part.guides.coverage, 0.0F));
  }
}

INSTANTIATE_TEST_SUITE_P(Margins, GuideParts,
                         ::testing::Values(PartCase{"hard", false, 0.0F, 0},
                                           PartCase{"hardWide", false, 0.0F, 17},
                                           PartCase{"hardBlurred", false, 21.0F, 5},
                                           PartCase{"soft", true, 0.0F, 0},
                                           PartCase{"softBlurred", true, 9.0F, 6}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace fluidymation
