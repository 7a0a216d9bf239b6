#include "fluidymation/option_ranges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fluidymation/core/error.h"
#include "fluidymation/pipeline.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::messageOf;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Options that the engine accepts as far as it has not looked at any file.
Options valid() {
  Options options;
  options.source.path = "none/src/%d.png";
  options.sourceMaskPath = "none/mask/%d.png";
  options.target.path = "none/target/%d.png";
  options.outPath = "none/out/%d.png";
  return options;
}

struct Fault {
  const char* message;
  std::function<void(Options&)> make;
};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = {
      {"--src-path: the path is empty", [](Options& o) { o.source.path = ""; }},
      {"--src-mask-path: a.png: ", [](Options& o) { o.sourceMaskPath = "a.png"; }},
      {"--target-path: %s: ", [](Options& o) { o.target.path = "%s"; }},
      {"--out-path: %d%d: ", [](Options& o) { o.outPath = "%d%d"; }},
      {"--out-path: none/%d.jpg: frames are written as PNG; wanted a name that ends in .png",
       [](Options& o) { o.outPath = "none/%d.jpg"; }},
      {"--dump-guides with an empty value", [](Options& o) { o.dumpGuidesDirectory = ""; }},
      {"--src-start 2000000000: wanted a whole number in [-1000000000, 1000000000]",
       [](Options& o) { o.source.start = 2'000'000'000; }},
      {"--src-frames 0: wanted a whole number in [1, 1000000]",
       [](Options& o) { o.source.frames = 0; }},
      {"--target-frames -1: ", [](Options& o) { o.target.frames = -1; }},
      {"--src-speed 0: ", [](Options& o) { o.source.speed = 0; }},
      {"--target-speed 0: ", [](Options& o) { o.target.speed = 0; }},
      {"--src-scale 0: wanted a number in (0, 16]", [](Options& o) { o.source.scale = 0.0; }},
      {"--target-scale nan: ", [](Options& o) { o.target.scale = std::nan(""); }},
      {"--blur-sigma -1: ", [](Options& o) { o.blurSigmaPx = -1.0F; }},
      {"--target-blur-sigma inf: ", [](Options& o) { o.targetBlurSigmaPx = kInfinity; }},
      {"--mask-threshold 0.6: wanted a number in (0, 0.5]",
       [](Options& o) { o.maskThreshold = 0.6F; }},
      {"--time-blur-sigma 51: wanted a number in [0, 50]",
       [](Options& o) { o.timeBlurSigmaFrames = 51.0F; }},
      {"--src-flow-path: f.flo: ", [](Options& o) { o.sourceFlowPath = "f.flo"; }},
      {"--target-flow-path: the path is empty", [](Options& o) { o.targetFlowPath = ""; }},
      {"--target-speed -2: wanted 1 or -1 with --target-flow-path, whose files lead from one frame "
       "to the next",
       [](Options& o) {
         o.targetFlowPath = "f/%d.flo";
         o.target.speed = -2;
       }},
      {"--src-speed 3: wanted 1 or -1 with --src-flow-path, ",
       [](Options& o) {
         o.sourceFlowPath = "f/%d.flo";
         o.source.speed = 3;
       }},
      {"--flow-convention forward: wanted with --src-flow-path or --target-flow-path only",
       [](Options& o) { o.flowConvention = FlowConvention::kForward; }},
      {"--motion-model rigid: not wanted with --target-flow-path, which tells how things move",
       [](Options& o) {
         o.targetFlowPath = "f/%d.flo";
         o.motionModel = MotionModel::kRigidParts;
       }},
      {"--flow-blur-sigma nan: ", [](Options& o) { o.flowBlurSigmaFrames = kNan; }},
      {"--dir-weight inf: ", [](Options& o) { o.synthesis.dirWeight = kInfinity; }},
      {"--prev-modulation-bounds 0.1,0.2: wanted m_u greater than m_l",
       [](Options& o) {
         o.synthesis.prevModulation = {0.1F, 0.2F, ModulationUnit::kTargetSides};
       }},
      {"--prev-modulation-bounds 80: wanted a number in [0, 10]",
       [](Options& o) {
         o.synthesis.prevModulation = {80.0F, 2.0F, ModulationUnit::kBorderWidths};
       }},
      {"--tex-weight nan: ", [](Options& o) { o.synthesis.texWeight = kNan; }},
      {"--dist-weight nan: ", [](Options& o) { o.synthesis.distWeight = kNan; }},
      {"edgeGain nan: wanted a number in [0, 1000000]",
       [](Options& o) { o.synthesis.edgeGain = kNan; }},
      {"edgeGain -1: ", [](Options& o) { o.synthesis.edgeGain = -1.0F; }},
      {"prevGain nan: wanted a number in [0, 1000000]",
       [](Options& o) { o.synthesis.prevGain = kNan; }},
      {"--flow-weight inf: ", [](Options& o) { o.synthesis.flowWeight = kInfinity; }},
      {"--prev-weight -1: ", [](Options& o) { o.synthesis.prevWeight = -1.0F; }},
      {"--prev-deepening 1001: ", [](Options& o) { o.synthesis.prevDeepening = 1001.0F; }},
      {"--prev-color-correction 1.5: wanted a number in [0, 1]",
       [](Options& o) { o.synthesis.prevColorCorrection = 1.5F; }},
      {"--opt-vote-sigma -1: ", [](Options& o) { o.synthesis.optVoteSigmaPx = -1.0F; }},
      {"--seam-blending 101: ", [](Options& o) { o.synthesis.paintedVote.seamWeight = 101.0F; }},
      {"--change-blending nan: wanted a number in [0, 1]",
       [](Options& o) { o.synthesis.changeBlending = kNan; }},
      {"--detail-restoration 1.5: wanted a number in [0, 1]",
       [](Options& o) { o.synthesis.detailRestoration = 1.5F; }},
      {"--prev-depth-reach -1: ", [](Options& o) { o.synthesis.prevDepthReachFrames = -1; }},
      {"--coherence-weight -1: ", [](Options& o) { o.synthesis.coherenceWeight = -1.0F; }},
      {"--lambda nan: ", [](Options& o) { o.synthesis.lambda = kNan; }},
      {"--border-width 0.05: wanted a number in [0.1, 10000]",
       [](Options& o) { o.borderWidthPx = 0.05F; }},
      {"--prev-modulation-bounds 2,2: wanted m_u greater than m_l",
       [](Options& o) {
         o.synthesis.prevModulation = {2.0F, 2.0F, ModulationUnit::kPixels};
       }},
      {"--prev-modulation-bounds nan: ",
       [](Options& o) {
         o.synthesis.prevModulation = {10.0F, kNan, ModulationUnit::kPixels};
       }},
      {"--occ-radius -1: ", [](Options& o) { o.synthesis.occRadiusFrames = -1; }},
      {"--patchmatch-alpha 1: wanted a number in (0, 0.99]",
       [](Options& o) { o.synthesis.patchmatchAlpha = 1.0F; }},
      {"--patchmatch-alpha 0: ", [](Options& o) { o.synthesis.patchmatchAlpha = 0.0F; }},
      {"--patchmatch-iterations: 0 numbers; wanted 1 to 32",
       [](Options& o) { o.synthesis.patchmatchIterations.clear(); }},
      {"--opt-iterations: 33 numbers; ", [](Options& o) { o.synthesis.optIterations.resize(33); }},
      {"--opt-iterations -1: ",
       [](Options& o) {
         o.synthesis.optIterations = {4, -1};
       }},
      {"--compression-level 10: wanted a whole number in [0, 9]",
       [](Options& o) { o.compressionLevel = 10; }},
      {"--threads 0: wanted a whole number in [1, 1024]", [](Options& o) { o.threads = 0; }},
  };
  return all;
}

TEST(Validate, AcceptsTheDefaultsAndTheEndsOfTheRanges) {
  EXPECT_EQ(messageOf<Error>([] { validate(valid()); }), "");
  Options ends = valid();
  ends.synthesis.patchmatchAlpha = 0.99F;
  ends.borderWidthPx = 0.1F;
  ends.timeBlurSigmaFrames = 50.0F;
  EXPECT_EQ(messageOf<Error>([&] { validate(ends); }), "");
}

TEST(Validate, NamesTheOptionItsValueAndWhatIsWanted) {
  for (const Fault& fault : faults()) {
    Options options = valid();
    fault.make(options);
    const std::string message = messageOf<UsageError>([&] { validate(options); });
    EXPECT_EQ(message.find(fault.message), 0U) << fault.message << " | " << message;
  }
}

TEST(Validate, ComesBeforeAnyOtherCheckOfTheEngine) {
  for (const Fault& fault : faults()) {
    Options options = valid();
    fault.make(options);
    const std::string message = messageOf<UsageError>([&] { stylize(options, {}); });
    EXPECT_EQ(message.find(fault.message), 0U) << fault.message << " | " << message;
  }
}

}  // namespace
}  // namespace fluidymation
