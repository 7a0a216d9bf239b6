// The numbers and rules that each preset stands for, and that other options change them.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/command_line_arguments.h"
#include "pipeline/option_texts.h"

namespace fluidymation::cli {
namespace {

TEST(CommandLine, NumbersAreThoseOfTheThesisInEitherPreset) {
  for (const char* preset : {"standard", "thesis"}) {
    SCOPED_TRACE(preset);
    const Options o = parse(complete({"--preset", preset})).options;
    for (const SequenceOptions& sequence : {o.source, o.target}) {
      EXPECT_EQ(sequence.start, 1);
      EXPECT_EQ(sequence.frames, 50);
      EXPECT_EQ(sequence.speed, 1);
      EXPECT_EQ(sequence.scale, 1.0);
    }
    EXPECT_FALSE(o.targetBlurSigmaPx);
    EXPECT_EQ(o.maskThreshold, 0.3F);
    EXPECT_EQ(o.timeBlurSigmaFrames, 2.0F);
    EXPECT_EQ(o.flowBlurSigmaFrames, 0.0F);
    EXPECT_EQ(o.synthesis.shape.guide, ShapeGuide::kEdgeDistance);
    EXPECT_TRUE(o.synthesis.shape.hardSegments);
    EXPECT_EQ(o.synthesis.shape.modulation, ModulationDistance::kClamped);
    EXPECT_EQ(o.synthesis.dirWeight, 0.0F);
    EXPECT_EQ(o.synthesis.texWeight, 1.0F);
    EXPECT_EQ(o.synthesis.distWeight, 5.0F);
    EXPECT_EQ(o.synthesis.flowWeight, 0.1F);
    EXPECT_EQ(o.synthesis.prevWeight, 1.0F);
    EXPECT_EQ(o.synthesis.lambda, 2.0F);
    EXPECT_EQ(o.synthesis.occRadiusFrames, 10);
    EXPECT_EQ(o.synthesis.patchmatchAlpha, 0.75F);
    EXPECT_EQ(o.synthesis.patchmatchIterations, (List{6, 4}));
    EXPECT_EQ(o.synthesis.optIterations, (List{4, 3, 2}));
    EXPECT_EQ(o.synthesis.seed, 0U);
    EXPECT_FALSE(o.dumpGuidesDirectory);
  }
}

TEST(CommandLine, TheThesisPresetHasItsRulesAndGivesWayToOtherOptions) {
  const Options all = parse(complete({"--preset", "thesis"})).options;
  EXPECT_EQ(all.blurSigmaPx, 8.0F);
  EXPECT_EQ(all.borderWidthPx, 10.0F);
  EXPECT_EQ(all.motionModel, MotionModel::kNormals);
  EXPECT_EQ(all.newMaterial, NewMaterial::kPlain);
  EXPECT_EQ(all.synthesis.thinParts, ThinParts::kFringe);
  EXPECT_EQ(all.synthesis.extentUnit, ExtentUnit::kPixels);
  EXPECT_FALSE(all.synthesis.carriesMotion);
  EXPECT_EQ(all.synthesis.edgeGain, 1.0F);
  EXPECT_EQ(all.synthesis.prevGain, 1.0F);
  EXPECT_EQ(all.synthesis.coherenceWeight, 0.0F);
  EXPECT_EQ(all.synthesis.prevDeepening, 0.0F);
  EXPECT_EQ(all.synthesis.prevDepthReachFrames, 0);
  EXPECT_EQ(all.synthesis.prevColorCorrection, 0.0F);
  EXPECT_EQ(all.synthesis.optVoteSigmaPx, 0.0F);
  EXPECT_EQ(all.synthesis.searchEffort, SearchEffort::kEverywhere);
  EXPECT_EQ(all.synthesis.prevModulation.upper, 10.0F);
  EXPECT_EQ(all.synthesis.prevModulation.lower, 2.0F);
  EXPECT_EQ(all.synthesis.prevModulation.unit, ModulationUnit::kPixels);
  const VoteOptions& thesis = all.synthesis.paintedVote;
  EXPECT_EQ(thesis.sigmaPx, 0.0F);
  EXPECT_EQ(thesis.depthSigmaPx, 0.0F);
  EXPECT_EQ(thesis.seamWeight, 0.0F);
  EXPECT_EQ(all.synthesis.changeBlending, 0.0F);
  EXPECT_EQ(all.synthesis.detailRestoration, 0.0F);
  EXPECT_EQ(thesis.interpolation, Interpolation::kBilinear);
  const VoteOptions standard = parse(kRequired).options.synthesis.paintedVote;
  EXPECT_NE(standard.sigmaPx, 0.0F);
  EXPECT_NE(standard.seamWeight, 0.0F);
  EXPECT_EQ(standard.interpolation, Interpolation::kLanczos);
  EXPECT_EQ(parse(kRequired).options.synthesis.searchEffort, SearchEffort::kWhereItChanges);
  const SynthesisOptions focused =
      parse(complete({"--preset", "thesis", "--search", "focused"})).options.synthesis;
  EXPECT_EQ(focused.searchEffort, SearchEffort::kWhereItChanges);
  // Before or after it on the command line
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--vote-sigma", "2", "--lambda", "7", "--preset", "thesis"},
        std::vector<std::string>{"--preset", "thesis", "--lambda", "7", "--vote-sigma", "2"}}) {
    const SynthesisOptions given = parse(complete(arguments)).options.synthesis;
    EXPECT_EQ(given.paintedVote.sigmaPx, 2.0F);
    EXPECT_EQ(given.paintedVote.interpolation, Interpolation::kBilinear);
    EXPECT_EQ(given.lambda, 7.0F);
  }
}

TEST(CommandLine, ThePaperPresetHasTheNumbersOfItsTableAndItsRules) {
  const Options o = parse(complete({"--preset", "paper"})).options;
  const SynthesisOptions& s = o.synthesis;
  EXPECT_EQ(o.borderWidthPx, 30.0F);
  EXPECT_EQ(s.occRadiusFrames, 5);
  EXPECT_EQ(s.distWeight, 4.0F);
  EXPECT_EQ(s.flowWeight, 0.25F);
  EXPECT_EQ(s.dirWeight, 1.0F);
  EXPECT_EQ(s.prevWeight, 4.0F);
  EXPECT_EQ(s.coherenceWeight, 0.0F);
  EXPECT_EQ(s.prevDeepening, 0.0F);
  EXPECT_EQ(s.prevDepthReachFrames, 0);
  EXPECT_EQ(s.prevColorCorrection, 0.0F);
  EXPECT_EQ(s.optVoteSigmaPx, 0.0F);
  EXPECT_EQ(s.paintedVote.seamWeight, 0.0F);
  EXPECT_EQ(s.changeBlending, 0.0F);
  EXPECT_EQ(s.detailRestoration, 0.0F);
  EXPECT_EQ(s.lambda, 1.0F);
  EXPECT_EQ(s.prevModulation.upper, 0.1F);
  EXPECT_EQ(s.prevModulation.lower, 0.01F);
  EXPECT_EQ(s.prevModulation.unit, ModulationUnit::kTargetSides);
  EXPECT_EQ(s.shape.guide, ShapeGuide::kBlurredMask);
  EXPECT_FALSE(s.shape.hardSegments);
  EXPECT_EQ(s.shape.modulation, ModulationDistance::kUnclamped);
  EXPECT_EQ(o.timeBlurSigmaFrames, 0.0F);
  EXPECT_EQ(o.flowBlurSigmaFrames, 1.5F);
  EXPECT_EQ(s.extentUnit, ExtentUnit::kPixels);
  // What the paper leaves open is as in the thesis
  EXPECT_EQ(o.blurSigmaPx, 8.0F);
  EXPECT_EQ(s.edgeGain, 1.0F);
  EXPECT_EQ(s.prevGain, 1.0F);
  EXPECT_EQ(s.thinParts, ThinParts::kFringe);
  EXPECT_FALSE(s.carriesMotion);
  EXPECT_EQ(o.motionModel, MotionModel::kNormals);
  EXPECT_EQ(o.newMaterial, NewMaterial::kPlain);
  EXPECT_EQ(s.paintedVote.sigmaPx, 0.0F);
  EXPECT_EQ(s.paintedVote.interpolation, Interpolation::kBilinear);
  EXPECT_EQ(s.optIterations, (List{4, 3, 2}));
}

TEST(CommandLine, LooksChangeTheStandardOneAndNothingElse) {
  const Options standard = parse(kRequired).options;
  Options crisp = parse(complete({"--preset", "crisp"})).options;
  EXPECT_LT(crisp.synthesis.paintedVote.sigmaPx, standard.synthesis.paintedVote.sigmaPx);
  EXPECT_GT(crisp.synthesis.coherenceWeight, standard.synthesis.coherenceWeight);
  EXPECT_LT(crisp.synthesis.paintedVote.seamWeight, standard.synthesis.paintedVote.seamWeight);
  crisp.synthesis.paintedVote.sigmaPx = standard.synthesis.paintedVote.sigmaPx;
  crisp.synthesis.paintedVote.seamWeight = standard.synthesis.paintedVote.seamWeight;
  crisp.synthesis.coherenceWeight = standard.synthesis.coherenceWeight;
  EXPECT_EQ(shapingOptions(crisp), shapingOptions(standard));
  Options calm = parse(complete({"--preset", "calm", "--vote-sigma", "0.35"})).options;
  EXPECT_EQ(calm.synthesis.temporalCoherence, TemporalCoherence::kBidirectional);
  calm.synthesis.temporalCoherence = TemporalCoherence::kForward;
  EXPECT_EQ(calm.synthesis.detailRestoration, 0.0F);
  calm.synthesis.detailRestoration = standard.synthesis.detailRestoration;
  EXPECT_EQ(shapingOptions(calm), shapingOptions(standard));
}

TEST(CommandLine, OtherOptionsChangeThePaperPreset) {
  const SynthesisOptions s =
      parse(complete({"--prev-modulation-bounds", "7,3", "--preset", "paper", "--shape-guide",
                      "distance", "--segments", "hard", "--dir-weight", "0"}))
          .options.synthesis;
  EXPECT_EQ(s.prevModulation.upper, 7.0F);
  EXPECT_EQ(s.prevModulation.unit, ModulationUnit::kPixels);
  EXPECT_EQ(s.shape.guide, ShapeGuide::kEdgeDistance);
  EXPECT_TRUE(s.shape.hardSegments);
  EXPECT_EQ(s.dirWeight, 0.0F);
  EXPECT_EQ(s.prevWeight, 4.0F);
}

}  // namespace
}  // namespace fluidymation::cli
