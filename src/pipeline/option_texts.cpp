#include "pipeline/option_texts.h"

#include "fluidymation/core/text.h"
#include "fluidymation/option_ranges.h"
#include "fluidymation/presets.h"
#include "pipeline/backdrop.h"

namespace fluidymation {
namespace {

[[nodiscard]] std::string pairText(const ModulationBounds& bounds) {
  return numberText(bounds.upper) + "," + numberText(bounds.lower);
}

/// Whether the values that have no option are those of the preset. Bounds in pixels have one.
[[nodiscard]] bool hasRulesOf(const Options& preset, const SynthesisOptions& synthesis) {
  const ModulationBounds& bounds = synthesis.prevModulation;
  const ModulationBounds& wanted = preset.synthesis.prevModulation;
  const bool haveBounds =
      bounds.unit == ModulationUnit::kPixels ||
      (bounds.unit == wanted.unit && bounds.upper == wanted.upper && bounds.lower == wanted.lower);
  return haveBounds && synthesis.edgeGain == preset.synthesis.edgeGain &&
         synthesis.prevGain == preset.synthesis.prevGain &&
         synthesis.paintedVote.depthSigmaPx == preset.synthesis.paintedVote.depthSigmaPx &&
         synthesis.shape.modulation == preset.synthesis.shape.modulation;
}

/// The values that have no option but --preset.
[[nodiscard]] std::string presetText(const SynthesisOptions& synthesis) {
  const Options standard;
  Options thesis;
  applyThesisPreset(thesis);
  Options paper;
  applyPaperPreset(paper);
  if (hasRulesOf(standard, synthesis)) return "standard";
  if (hasRulesOf(thesis, synthesis)) return "thesis";
  if (hasRulesOf(paper, synthesis)) return "paper";
  const ModulationBounds& bounds = synthesis.prevModulation;
  const bool clamped = synthesis.shape.modulation == ModulationDistance::kClamped;
  std::string text = "edge gain " + numberText(synthesis.edgeGain);
  text += ", gain of the previous frame " + numberText(synthesis.prevGain);
  text += ", vote depth sigma " + numberText(synthesis.paintedVote.depthSigmaPx);
  if (!clamped) text += ", modulation unclamped";
  if (bounds.unit == ModulationUnit::kBorderWidths) {
    text += ", bounds " + pairText(bounds) + " border widths";
  }
  if (bounds.unit == ModulationUnit::kTargetSides) {
    text += ", bounds " + pairText(bounds) + " target sides";
  }
  return text;
}

[[nodiscard]] const char* word(MotionModel model) {
  return model == MotionModel::kNormals ? "normals" : "rigid";
}
[[nodiscard]] const char* word(ShapeGuide guide) {
  return guide == ShapeGuide::kEdgeDistance ? "distance" : "blurred";
}
[[nodiscard]] const char* word(ThinParts parts) {
  return parts == ThinParts::kFringe ? "fringe" : "body";
}
[[nodiscard]] const char* word(ExtentUnit unit) {
  return unit == ExtentUnit::kPixels ? "px" : "film";
}
[[nodiscard]] const char* word(SearchEffort effort) {
  return effort == SearchEffort::kEverywhere ? "everywhere" : "focused";
}
[[nodiscard]] const char* word(FlowConvention convention) {
  return convention == FlowConvention::kBackward ? "backward" : "forward";
}
[[nodiscard]] const char* word(NewMaterial material) {
  switch (material) {
    case NewMaterial::kAutomatic:
      return "auto";
    case NewMaterial::kFresh:
      return "fresh";
    case NewMaterial::kPlain:
      break;
  }
  return "plain";
}
[[nodiscard]] const char* word(Reverse reverse) {
  switch (reverse) {
    case Reverse::kAutomatic:
      return "auto";
    case Reverse::kOn:
      return "on";
    case Reverse::kOff:
      break;
  }
  return "off";
}
[[nodiscard]] const char* word(FinestLevel level) {
  switch (level) {
    case FinestLevel::kUpscaled:
      return "upscaled";
    case FinestLevel::kRefined:
      return "refined";
    case FinestLevel::kSearched:
      break;
  }
  return "searched";
}
[[nodiscard]] const char* word(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::kBilinear:
      return "bilinear";
    case Interpolation::kCubic:
      return "cubic";
    case Interpolation::kLanczos:
      break;
  }
  return "lanczos";
}

void addSequence(const std::string& prefix, const SequenceOptions& sequence, OptionTexts& texts) {
  texts.emplace_back(prefix + "-start", std::to_string(sequence.start));
  texts.emplace_back(prefix + "-frames", std::to_string(sequence.frames));
  texts.emplace_back(prefix + "-speed", std::to_string(sequence.speed));
  texts.emplace_back(prefix + "-scale", numberText(sequence.scale));
}

void addSynthesis(const SynthesisOptions& synthesis, OptionTexts& texts) {
  texts.emplace_back("--dist-weight", numberText(synthesis.distWeight));
  texts.emplace_back("--flow-weight", numberText(synthesis.flowWeight));
  texts.emplace_back("--dir-weight", numberText(synthesis.dirWeight));
  texts.emplace_back("--prev-weight", numberText(synthesis.prevWeight));
  texts.emplace_back("--prev-deepening", numberText(synthesis.prevDeepening));
  texts.emplace_back("--prev-depth-reach", std::to_string(synthesis.prevDepthReachFrames));
  texts.emplace_back("--prev-color-correction", numberText(synthesis.prevColorCorrection));
  texts.emplace_back("--shape-guide", word(synthesis.shape.guide));
  texts.emplace_back("--segments", synthesis.shape.hardSegments ? "hard" : "none");
  texts.emplace_back("--thin-parts", word(synthesis.thinParts));
  texts.emplace_back("--extent-unit", word(synthesis.extentUnit));
  if (synthesis.prevModulation.unit == ModulationUnit::kPixels) {
    texts.emplace_back("--prev-modulation-bounds", pairText(synthesis.prevModulation));
  }
  texts.emplace_back("--tex-weight", numberText(synthesis.texWeight));
  texts.emplace_back("--carry-motion", synthesis.carriesMotion ? "on" : "off");
  texts.emplace_back(
      "--temporal-coherence",
      synthesis.temporalCoherence == TemporalCoherence::kForward ? "forward" : "bidirectional");
  texts.emplace_back("--coherence-weight", numberText(synthesis.coherenceWeight));
  texts.emplace_back("--lambda", numberText(synthesis.lambda));
  texts.emplace_back("--occ-radius", std::to_string(synthesis.occRadiusFrames));
  texts.emplace_back("--patchmatch-alpha", numberText(synthesis.patchmatchAlpha));
  texts.emplace_back("--patchmatch-iterations", listText(synthesis.patchmatchIterations));
  texts.emplace_back("--opt-iterations", listText(synthesis.optIterations));
  texts.emplace_back("--search", word(synthesis.searchEffort));
  texts.emplace_back("--finest-level", word(synthesis.finestLevel));
  texts.emplace_back("--opt-vote-sigma", numberText(synthesis.optVoteSigmaPx));
  texts.emplace_back("--vote-sigma", numberText(synthesis.paintedVote.sigmaPx));
  texts.emplace_back("--vote-interpolation", word(synthesis.paintedVote.interpolation));
  texts.emplace_back("--seam-blending", numberText(synthesis.paintedVote.seamWeight));
  texts.emplace_back("--change-blending", numberText(synthesis.changeBlending));
  texts.emplace_back("--detail-restoration", numberText(synthesis.detailRestoration));
  texts.emplace_back("--seed", std::to_string(synthesis.seed));
}

}  // namespace

OptionTexts shapingOptions(const Options& options) {
  OptionTexts texts = {{"--preset", presetText(options.synthesis)},
                       {"--compression-level", std::to_string(options.compressionLevel)},
                       {"--bit-depth", options.bitDepth == BitDepth::k8 ? "8" : "16"}};
  if (options.background && !isBackgroundFile(*options.background)) {
    texts.emplace_back("--background", backgroundText(*options.background));
  }
  addSequence("--src", options.source, texts);
  texts.emplace_back("--src-window", std::to_string(options.sourceWindowFrames));
  addSequence("--target", options.target, texts);
  if (options.sourceFlowPath || options.targetFlowPath) {
    texts.emplace_back("--flow-convention", word(options.flowConvention));
  }
  if (options.blurSigmaPx) texts.emplace_back("--blur-sigma", numberText(*options.blurSigmaPx));
  if (options.targetBlurSigmaPx) {
    texts.emplace_back("--target-blur-sigma", numberText(*options.targetBlurSigmaPx));
  }
  texts.emplace_back("--mask-threshold", numberText(options.maskThreshold));
  texts.emplace_back("--time-blur-sigma", numberText(options.timeBlurSigmaFrames));
  texts.emplace_back("--flow-blur-sigma", numberText(options.flowBlurSigmaFrames));
  texts.emplace_back("--motion-model", word(options.motionModel));
  if (options.borderWidthPx) {
    texts.emplace_back("--border-width", numberText(*options.borderWidthPx));
  }
  texts.emplace_back("--new-material", word(options.newMaterial));
  texts.emplace_back("--reverse", word(options.reverse));
  addSynthesis(options.synthesis, texts);
  if (options.recolor) texts.emplace_back("--recolor", colorText(*options.recolor));
  return texts;
}

OptionTexts pathOptions(const Options& options) {
  OptionTexts texts = {{"--src-path", options.source.path},
                       {"--src-mask-path", options.sourceMaskPath},
                       {"--target-path", options.target.path},
                       {"--out-path", options.outPath}};
  if (options.sourceFlowPath) texts.emplace_back("--src-flow-path", *options.sourceFlowPath);
  if (options.targetFlowPath) texts.emplace_back("--target-flow-path", *options.targetFlowPath);
  if (options.background && isBackgroundFile(*options.background)) {
    texts.emplace_back("--background", *options.background);
  }
  return texts;
}

}  // namespace fluidymation
