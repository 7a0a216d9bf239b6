#include "fluidymation/presets.h"

namespace fluidymation {

void applyThesisPreset(Options& options) {
  options.blurSigmaPx = 8.0F;
  options.targetBlurSigmaPx.reset();
  options.maskThreshold = 0.3F;
  options.borderWidthPx = 10.0F;
  options.timeBlurSigmaFrames = 2.0F;
  SynthesisOptions& synthesis = options.synthesis;
  synthesis.distWeight = 5.0F;
  synthesis.flowWeight = 0.1F;
  synthesis.prevWeight = 1.0F;
  synthesis.lambda = 2.0F;
  synthesis.occRadiusFrames = 10;
  synthesis.patchmatchAlpha = 0.75F;
  synthesis.prevModulation = ModulationBounds{10.0F, 2.0F};
  synthesis.edgeGain = 1.0F;
  synthesis.patchmatchIterations = {6, 4};
  synthesis.optIterations = {4, 3, 2};
  options.motionModel = MotionModel::kNormals;
  synthesis.thinParts = ThinParts::kFringe;
  synthesis.carriesMotion = false;
  synthesis.extentUnit = ExtentUnit::kPixels;
  synthesis.paintedVote = {0.0F, Interpolation::kBilinear};
}

}  // namespace fluidymation
