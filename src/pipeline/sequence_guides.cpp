#include "pipeline/sequence_guides.h"

#include <memory>

#include "pipeline/given_flow.h"

namespace fluidymation {

GuideOptions guideOptions(const Options& options, float blurSigmaPx, MotionModel motionModel) {
  GuideOptions guides;
  guides.mask = {blurSigmaPx, options.maskThreshold};
  guides.timeBlurSigmaFrames = options.timeBlurSigmaFrames;
  guides.flowBlurSigmaFrames = options.flowBlurSigmaFrames;
  guides.motionModel = motionModel;
  if (options.synthesis.shape.guide == ShapeGuide::kBlurredMask) {
    guides.shapeBlurRadiusPx = *options.borderWidthPx;
  }
  return guides;
}

FlowReader flowReader(const std::optional<FlowSequence>& flow,
                      const std::function<void()>& beforeEach) {
  if (!flow) return {};
  return [beforeEach, given = std::make_shared<GivenFlow>(*flow)](int frame, const Mask& previous) {
    beforeEach();
    return given->flow(frame, previous);
  };
}

}  // namespace fluidymation
