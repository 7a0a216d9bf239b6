#include "cli/command_line_arguments.h"

#include "cli/painter_syntax.h"
#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation::cli {

const Arguments kRequired = {"--src-path",    "s/%d.png", "--src-mask-path", "m/%d.png",
                             "--target-path", "t/%d.png", "--out-path",      "o/%d.png"};

CommandLine parse(const Arguments& arguments) {
  std::vector<const char*> argv = {"fluidymation"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return parseCommandLine(painterSyntax(), static_cast<int>(argv.size()), argv.data());
}

Arguments complete(const Arguments& more) {
  Arguments arguments = kRequired;
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string complaint(const Arguments& arguments) {
  return test::messageOf<UsageError>([&] { (void)parse(arguments); });
}

const std::vector<Reaching>& reachingOptions() {
  using C = const CommandLine&;
  static const std::vector<Reaching> options = {
      {"--src-range", "10-80x2",
       [](C c) {
         const SequenceOptions& s = c.options.source;
         return s.start == 10 && s.frames == 36 && s.speed == 2 && s.complete;
       }},
      {"--target-range", "-3--7",
       [](C c) {
         const SequenceOptions& s = c.options.target;
         return s.start == -3 && s.frames == 5 && s.speed == -1 && s.complete;
       }},
      {"--src-start", "-3", [](C c) { return c.options.source.start == -3; }},
      {"--src-frames", "7", [](C c) { return c.options.source.frames == 7; }},
      {"--src-speed", "-1", [](C c) { return c.options.source.speed == -1; }},
      {"--src-window", "12", [](C c) { return c.options.sourceWindowFrames == 12; }},
      {"--src-scale", "0.5", [](C c) { return c.options.source.scale == 0.5; }},
      {"--target-start", "0", [](C c) { return c.options.target.start == 0; }},
      {"--target-frames", "1000000", [](C c) { return c.options.target.frames == 1000000; }},
      {"--target-speed", "2", [](C c) { return c.options.target.speed == 2; }},
      {"--target-scale", "16", [](C c) { return c.options.target.scale == 16.0; }},
      {"--blur-sigma", "0", [](C c) { return c.options.blurSigmaPx == 0.0F; }},
      {"--target-blur-sigma", "1e1", [](C c) { return c.options.targetBlurSigmaPx == 10.0F; }},
      {"--mask-threshold", ".5", [](C c) { return c.options.maskThreshold == 0.5F; }},
      {"--time-blur-sigma", "1.25", [](C c) { return c.options.timeBlurSigmaFrames == 1.25F; }},
      {"--flow-blur-sigma", "1.5", [](C c) { return c.options.flowBlurSigmaFrames == 1.5F; }},
      {"--dir-weight", "1", [](C c) { return c.options.synthesis.dirWeight == 1.0F; }},
      {"--shape-guide", "blurred",
       [](C c) { return c.options.synthesis.shape.guide == ShapeGuide::kBlurredMask; }},
      {"--segments", "none", [](C c) { return !c.options.synthesis.shape.hardSegments; }},
      {"--tex-weight", "2", [](C c) { return c.options.synthesis.texWeight == 2.0F; }},
      {"--dist-weight", "4", [](C c) { return c.options.synthesis.distWeight == 4.0F; }},
      {"--flow-weight", "0.01", [](C c) { return c.options.synthesis.flowWeight == 0.01F; }},
      {"--prev-weight", "0", [](C c) { return c.options.synthesis.prevWeight == 0.0F; }},
      {"--prev-deepening", "0.5", [](C c) { return c.options.synthesis.prevDeepening == 0.5F; }},
      {"--prev-depth-reach", "3",
       [](C c) { return c.options.synthesis.prevDepthReachFrames == 3; }},
      {"--prev-color-correction", "0.75",
       [](C c) { return c.options.synthesis.prevColorCorrection == 0.75F; }},
      {"--temporal-coherence", "bidirectional",
       [](C c) {
         return c.options.synthesis.temporalCoherence == TemporalCoherence::kBidirectional;
       }},
      {"--coherence-weight", "2.5",
       [](C c) { return c.options.synthesis.coherenceWeight == 2.5F; }},
      {"--lambda", "1.5", [](C c) { return c.options.synthesis.lambda == 1.5F; }},
      {"--occ-radius", "5", [](C c) { return c.options.synthesis.occRadiusFrames == 5; }},
      {"--patchmatch-alpha", "0.5",
       [](C c) { return c.options.synthesis.patchmatchAlpha == 0.5F; }},
      {"--border-width", "30", [](C c) { return c.options.borderWidthPx == 30.0F; }},
      {"--border-width", "auto",
       [](C c) { return c.options.borderWidthRule == BorderWidthRule::kMeasured; }},
      {"--prev-modulation-bounds", "7.5,0",
       [](C c) {
         const ModulationBounds& bounds = c.options.synthesis.prevModulation;
         return bounds.upper == 7.5F && bounds.lower == 0.0F &&
                bounds.unit == ModulationUnit::kPixels;
       }},
      {"--patchmatch-iterations", "3",
       [](C c) { return c.options.synthesis.patchmatchIterations == List{3}; }},
      {"--opt-iterations", "5,0,1,2",
       [](C c) {
         return c.options.synthesis.optIterations == List{5, 0, 1, 2};
       }},
      {"--search", "everywhere",
       [](C c) { return c.options.synthesis.searchEffort == SearchEffort::kEverywhere; }},
      {"--motion-model", "rigid",
       [](C c) { return c.options.motionModel == MotionModel::kRigidParts; }},
      {"--new-material", "fresh", [](C c) { return c.options.newMaterial == NewMaterial::kFresh; }},
      {"--new-material", "plain", [](C c) { return c.options.newMaterial == NewMaterial::kPlain; }},
      {"--reverse", "on", [](C c) { return c.options.reverse == Reverse::kOn; }},
      {"--reverse", "auto", [](C c) { return c.options.reverse == Reverse::kAutomatic; }},
      {"--thin-parts", "fringe",
       [](C c) { return c.options.synthesis.thinParts == ThinParts::kFringe; }},
      {"--extent-unit", "px",
       [](C c) { return c.options.synthesis.extentUnit == ExtentUnit::kPixels; }},
      {"--carry-motion", "off", [](C c) { return !c.options.synthesis.carriesMotion; }},
      {"--finest-level", "searched",
       [](C c) { return c.options.synthesis.finestLevel == FinestLevel::kSearched; }},
      {"--opt-vote-sigma", "0.7", [](C c) { return c.options.synthesis.optVoteSigmaPx == 0.7F; }},
      {"--seam-blending", "2",
       [](C c) { return c.options.synthesis.paintedVote.seamWeight == 2.0F; }},
      {"--change-blending", "0.75",
       [](C c) { return c.options.synthesis.changeBlending == 0.75F; }},
      {"--detail-restoration", "0.25",
       [](C c) { return c.options.synthesis.detailRestoration == 0.25F; }},
      {"--vote-sigma", "1.5", [](C c) { return c.options.synthesis.paintedVote.sigmaPx == 1.5F; }},
      {"--vote-interpolation", "bilinear",
       [](C c) {
         return c.options.synthesis.paintedVote.interpolation == Interpolation::kBilinear;
       }},
      {"--seed", "18446744073709551615",
       [](C c) { return c.options.synthesis.seed == 18446744073709551615U; }},
      {"--recolor", "#c02",
       [](C c) { return c.options.recolor && colorText(*c.options.recolor) == "#cc0022"; }},
      {"--checkpoint-every", "5", [](C c) { return c.options.continuation.checkpointEvery == 5; }},
      {"--preview", "p.png", [](C c) { return c.preview.path == "p.png"; }},
      {"--preview-background", "white", [](C c) { return c.preview.background == "white"; }},
      {"--preview-every", "5", [](C c) { return c.preview.every == 5; }},
      {"--render-frames", "-3--1",
       [](C c) {
         const auto& render = c.options.continuation.render;
         return render && render->first == -3 && render->last == -1;
       }},
      {"--compression-level", "7", [](C c) { return c.options.compressionLevel == 7; }},
      {"--bit-depth", "16", [](C c) { return c.options.bitDepth == BitDepth::k16; }},
      {"--background", "#abc", [](C c) { return c.options.background == "#abc"; }},
      {"--background", "exemplar", [](C c) { return c.options.background == "exemplar"; }},
      {"--background", "paper.png", [](C c) { return c.options.background == "paper.png"; }},
      {"--threads", "3", [](C c) { return c.options.threads == 3; }},
      {"--max-memory", "1.5G", [](C c) { return c.options.maxMemoryBytes == 3 << 29; }},
      {"--progress", "json", [](C c) { return c.progress == ProgressFormat::kJson; }},
      {"--progress", "openjd",
       [](C c) { return c.progress == ProgressFormat::kOpenJobDescription; }},
      {"--src-flow-path", "f/%d.flo", [](C c) { return c.options.sourceFlowPath == "f/%d.flo"; }},
      {"--target-flow-path", "g/%d.png",
       [](C c) { return c.options.targetFlowPath == "g/%d.png"; }},
      {"--flow-convention", "forward",
       [](C c) { return c.options.flowConvention == FlowConvention::kForward; }},
      {"--dump-guides", "d", [](C c) { return c.options.dumpGuidesDirectory == "d"; }},
  };
  return options;
}

}  // namespace fluidymation::cli
