#include "pipeline/given_flow.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "fluidymation/io/flow_file.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

constexpr Size kSize{6, 4};

/// Files f1.flo to f4.flo; that of frame n moves everything by (n, 10 n).
class GivenFlowTest : public ::testing::Test {
 protected:
  GivenFlowTest() {
    for (int number = 1; number <= 4; ++number) {
      const auto n = static_cast<float>(number);
      writeFlow(file(number), Image<Vec2>(kSize, Vec2{n, 10.0F * n}));
    }
  }

  [[nodiscard]] std::string file(int number) const {
    return folder_.file("f" + std::to_string(number) + ".flo");
  }

  void remove(int number) const { std::remove(file(number).c_str()); }

  /// A sequence of frames first, first + speed, ...; its masks are not looked at.
  [[nodiscard]] FlowSequence open(FlowConvention convention, int first, int speed, int count,
                                  double scale = 1.0) const {
    SequenceOptions sequence;
    sequence.start = first;
    sequence.speed = speed;
    sequence.frames = count;
    sequence.scale = scale;
    InputSequence masks;
    masks.stored = kSize;
    masks.scaled = {static_cast<int>(kSize.width * scale), static_cast<int>(kSize.height * scale)};
    for (int i = 0; i < count; ++i) {
      masks.files.numbers.push_back(first + i * speed);
      masks.files.paths.push_back("mask" + std::to_string(first + i * speed));
    }
    return openFlowSequence(folder_.file("f%d.flo"), "--src-flow-path", convention, sequence,
                            masks);
  }

  /// x of the flow of every frame at a pixel that always was inside, and at one that never was.
  struct Flows {
    std::vector<float> kept;
    std::vector<float> fresh;
  };
  [[nodiscard]] static Flows flowsOf(const FlowSequence& sequence) {
    GivenFlow given(sequence);
    Flows flows;
    for (int i = 0; i < sequence.files.count(); ++i) {
      Mask previous(sequence.scaled);
      previous(0, 0) = i > 0 ? 1 : 0;
      const Image<Vec2> flow = given.flow(i, previous);
      EXPECT_EQ(flow.size(), sequence.scaled);
      EXPECT_FLOAT_EQ(flow(0, 0).y, 10.0F * flow(0, 0).x);
      flows.kept.push_back(flow(0, 0).x);
      flows.fresh.push_back(flow(1, 1).x);
    }
    return flows;
  }

  test::TemporaryFolder folder_;
};

using Values = std::vector<float>;
constexpr FlowConvention kBackward = FlowConvention::kBackward;
constexpr FlowConvention kForward = FlowConvention::kForward;

TEST_F(GivenFlowTest, BackwardFilesPlayedForwardsAreTheFramesOwn) {
  const Flows flows = flowsOf(open(kBackward, 1, 1, 4));
  EXPECT_EQ(flows.kept, (Values{1, 2, 3, 4}));
  EXPECT_EQ(flows.fresh, flows.kept);
  remove(1);  // nothing leads to the first frame
  EXPECT_EQ(flowsOf(open(kBackward, 1, 1, 4)).kept, (Values{2, 2, 3, 4}));
}

TEST_F(GivenFlowTest, ForwardFilesPlayedBackwardsAreTheFramesOwnNegated) {
  EXPECT_EQ(flowsOf(open(kForward, 4, -1, 4)).kept, (Values{-4, -3, -2, -1}));
  remove(4);  // nothing comes after the last frame
  EXPECT_EQ(flowsOf(open(kForward, 4, -1, 4)).kept, (Values{-3, -3, -2, -1}));
}

TEST_F(GivenFlowTest, ForwardFilesPlayedForwardsAreThoseOfTheFrameBefore) {
  Flows flows = flowsOf(open(kForward, 1, 1, 4));
  EXPECT_EQ(flows.kept, (Values{1, 1, 2, 3}));
  EXPECT_EQ(flows.fresh, (Values{1, 2, 3, 4}));  // not there before: the next step stands in
  remove(4);
  flows = flowsOf(open(kForward, 1, 1, 4));
  EXPECT_EQ(flows.kept, (Values{1, 1, 2, 3}));
  EXPECT_EQ(flows.fresh, (Values{1, 2, 3, 3}));
}

TEST_F(GivenFlowTest, BackwardFilesPlayedBackwardsAreThoseOfTheFrameBeforeNegated) {
  EXPECT_EQ(flowsOf(open(kBackward, 4, -1, 4)).kept, (Values{-4, -4, -3, -2}));
  remove(1);
  EXPECT_EQ(flowsOf(open(kBackward, 4, -1, 4)).kept, (Values{-4, -4, -3, -2}));
}

TEST_F(GivenFlowTest, AFileThatChangedSinceItWasFoundIsNotUsed) {
  const FlowSequence sequence = open(kBackward, 1, 1, 4);
  writeFlow(file(3), Image<Vec2>(kSize, Vec2{7.0F, 7.0F}));
  EXPECT_EQ(test::messageOf<Error>([&] {
              (void)flowsOf(sequence);
            }).find(file(3) + ": changed while the run was at work"),
            0U);
}

TEST_F(GivenFlowTest, ScalesVectorsWithTheFrames) {
  EXPECT_EQ(flowsOf(open(kBackward, 1, 1, 4, 0.5)).kept, (Values{0.5F, 1, 1.5F, 2}));
  EXPECT_EQ(flowsOf(open(kBackward, 4, -1, 4, 2.0)).kept, (Values{-8, -8, -6, -4}));
}

TEST_F(GivenFlowTest, AllOtherFilesAreWanted) {
  const auto complaint = [&](FlowConvention convention, int first, int speed, int count) {
    return test::messageOf<Error>([&] { (void)open(convention, first, speed, count); });
  };
  const std::string option = "--src-flow-path " + folder_.file("f%d.flo") + ": ";
  const std::string wanted = "; wanted one file for every frame of --src-path";
  remove(1);
  EXPECT_EQ(complaint(kForward, 1, 1, 4),
            option + "1 frame is missing: 1" + wanted + " but the last");
  EXPECT_EQ(complaint(kForward, 4, -1, 4),
            option + "1 frame is missing: 1" + wanted + " but the first");
  EXPECT_EQ(complaint(kBackward, 1, 1, 1), option + "1 frame is missing: 1" + wanted);
  remove(3);
  EXPECT_EQ(complaint(kBackward, 1, 1, 6),
            option + "3 frames are missing: 3, 5-6" + wanted + " but the first");
}

TEST_F(GivenFlowTest, SizesHaveToBeThoseOfTheMasks) {
  writeFlow(file(3), Image<Vec2>(Size{6, 5}));
  EXPECT_EQ(test::messageOf<Error>([&] { (void)open(kBackward, 1, 1, 4); }),
            file(3) + ": size 6x5, but mask3 is 6x4; a flow and its masks must agree");
}

}  // namespace
}  // namespace fluidymation
