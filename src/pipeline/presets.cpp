#include "fluidymation/presets.h"

#include <algorithm>
#include <cstdint>

namespace fluidymation {

void applyStandardPreset(Options& options) {
  const Options standard;
  options.blurSigmaPx = standard.blurSigmaPx;
  options.targetBlurSigmaPx = standard.targetBlurSigmaPx;
  options.maskThreshold = standard.maskThreshold;
  options.borderWidthPx = standard.borderWidthPx;
  options.borderWidthRule = standard.borderWidthRule;
  options.timeBlurSigmaFrames = standard.timeBlurSigmaFrames;
  options.flowBlurSigmaFrames = standard.flowBlurSigmaFrames;
  options.motionModel = standard.motionModel;
  options.newMaterial = standard.newMaterial;
  const std::uint64_t seed = options.synthesis.seed;
  options.synthesis = standard.synthesis;
  options.synthesis.seed = seed;
}

void applyThesisPreset(Options& options) {
  options.blurSigmaPx = 8.0F;
  options.targetBlurSigmaPx.reset();
  options.maskThreshold = 0.3F;
  options.borderWidthPx = 10.0F;
  options.timeBlurSigmaFrames = 2.0F;
  options.flowBlurSigmaFrames = 0.0F;
  SynthesisOptions& synthesis = options.synthesis;
  synthesis.texWeight = 1.0F;
  synthesis.distWeight = 5.0F;
  synthesis.flowWeight = 0.1F;
  synthesis.dirWeight = 0.0F;
  synthesis.prevWeight = 1.0F;
  synthesis.prevDeepening = 0.0F;
  synthesis.prevDepthReachFrames = 0;
  synthesis.prevColorCorrection = 0.0F;
  synthesis.coherenceWeight = 0.0F;
  synthesis.temporalCoherence = TemporalCoherence::kForward;
  synthesis.lambda = 2.0F;
  synthesis.occRadiusFrames = 10;
  synthesis.patchmatchAlpha = 0.75F;
  synthesis.shape = {ShapeGuide::kEdgeDistance, true, ModulationDistance::kClamped};
  synthesis.prevModulation = {10.0F, 2.0F, ModulationUnit::kPixels};
  synthesis.edgeGain = 1.0F;
  synthesis.prevGain = 1.0F;
  synthesis.patchmatchIterations = {6, 4};
  synthesis.optIterations = {4, 3, 2};
  synthesis.searchEffort = SearchEffort::kEverywhere;
  options.motionModel = MotionModel::kNormals;
  options.newMaterial = NewMaterial::kPlain;
  synthesis.thinParts = ThinParts::kFringe;
  synthesis.carriesMotion = false;
  synthesis.extentUnit = ExtentUnit::kPixels;
  synthesis.finestLevel = FinestLevel::kUpscaled;
  synthesis.optVoteSigmaPx = 0.0F;
  synthesis.paintedVote = {0.0F, Interpolation::kBilinear, 0.0F, 0.0F};
  synthesis.changeBlending = 0.0F;
  synthesis.detailRestoration = 0.0F;
}

void applyPaperPreset(Options& options) {
  applyThesisPreset(options);
  options.borderWidthPx = 30.0F;  // d_bound and b
  options.timeBlurSigmaFrames = 0.0F;
  options.flowBlurSigmaFrames = 1.5F;  // over 3 frames on either side; P App. A
  SynthesisOptions& synthesis = options.synthesis;
  synthesis.distWeight = 4.0F;
  synthesis.flowWeight = 0.25F;
  synthesis.dirWeight = 1.0F;
  synthesis.prevWeight = 4.0F;
  synthesis.lambda = 1.0F;
  synthesis.occRadiusFrames = 5;
  synthesis.shape = {ShapeGuide::kBlurredMask, false, ModulationDistance::kUnclamped};
  synthesis.prevModulation = {0.1F, 0.01F, ModulationUnit::kTargetSides};
}

void applyCrispPreset(Options& options) {
  applyStandardPreset(options);
  // A window's own pixel alone: narrower changes nothing any more.
  options.synthesis.paintedVote.sigmaPx = 0.25F;
  options.synthesis.paintedVote.seamWeight = 0.0F;
  options.synthesis.coherenceWeight = 32.0F;
}

void applyCalmPreset(Options& options) {
  applyStandardPreset(options);
  options.synthesis.paintedVote.sigmaPx = 0.5F;
  options.synthesis.detailRestoration = 0.0F;  // would sharpen what is to be soft
  options.synthesis.temporalCoherence = TemporalCoherence::kBidirectional;
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = {{"standard", applyStandardPreset},
                                          {"crisp", applyCrispPreset},
                                          {"calm", applyCalmPreset},
                                          {"thesis", applyThesisPreset},
                                          {"paper", applyPaperPreset}};
  return all;
}

std::optional<Preset> findPreset(const std::string& name) {
  for (const Preset& preset : presets()) {
    if (name == preset.name) return preset;
  }
  return std::nullopt;
}

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) names.emplace_back(preset.name);
  return names;
}

}  // namespace fluidymation
