#include "pipeline/automatic_widths.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "fluidymation/automatic.h"
#include "fluidymation/core/color.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/guides/rim_profile.h"
#include "fluidymation/option_ranges.h"
#include "pipeline/sampled_frames.h"

namespace fluidymation {
namespace {

/// The mean-area rule's sigma for a sequence of masks, by `sampledFrames`.
float automaticSigma(const InputSequence& masks, MaskChannel channel,
                     const std::function<void()>& beforeFrame) {
  std::vector<double> areas;
  for (const int frame : sampledFrames(masks.files.count())) {
    beforeFrame();
    const Image<float> coverage = readMask(masks, channel, frame).coverage;
    areas.push_back(std::accumulate(coverage.begin(), coverage.end(), 0.0));
  }
  return automaticBlurSigmaPx(areas);
}

}  // namespace

float measuredBorderWidthPx(const Inputs& inputs, MaskChannel sourceChannel,
                            const MaskOptions& smoothing,
                            const std::function<void()>& beforeFrame) {
  const float bySize = automaticBorderWidthPx(inputs.color.scaled);
  // Half the width: the profile has settled where it stays so over a part of a border.
  const int stepPx = std::max(1, static_cast<int>(std::lround(kLeastMeasuredShare * bySize)));
  RimProfile profile(static_cast<int>(std::ceil(kMostMeasuredShare * bySize)) + stepPx);
  for (const int frame : sampledFrames(inputs.color.files.count())) {
    beforeFrame();
    const Mask mask =
        smoothMask(readMask(inputs.sourceMask, sourceChannel, frame).cut(), smoothing);
    profile.add(toLab(readPicture(inputs.color, frame)), mask);
  }
  return boundedBorderWidthPx(profile.widthPx(stepPx), inputs.color.scaled);
}

void fillAutomaticWidths(const Inputs& inputs, MaskChannel sourceChannel, MaskChannel targetChannel,
                         const std::function<void()>& beforeFrame, Options& options) {
  if (!options.targetBlurSigmaPx) {
    options.targetBlurSigmaPx = options.blurSigmaPx
                                    ? *options.blurSigmaPx
                                    : automaticSigma(inputs.target, targetChannel, beforeFrame);
  }
  if (!options.blurSigmaPx) {
    options.blurSigmaPx = automaticSigma(inputs.sourceMask, sourceChannel, beforeFrame);
  }
  if (options.borderWidthPx) return;
  options.borderWidthPx =
      options.borderWidthRule == BorderWidthRule::kBySize
          ? automaticBorderWidthPx(inputs.color.scaled)
          : measuredBorderWidthPx(inputs, sourceChannel,
                                  {*options.blurSigmaPx, options.maskThreshold}, beforeFrame);
}

std::string chosenWidths(const Options& given, const Options& found) {
  std::string text;
  if (!given.blurSigmaPx) text += " --blur-sigma " + numberText(*found.blurSigmaPx);
  if (!given.targetBlurSigmaPx && !given.blurSigmaPx) {
    text += " --target-blur-sigma " + numberText(*found.targetBlurSigmaPx);
  }
  if (!given.borderWidthPx) text += " --border-width " + numberText(*found.borderWidthPx);
  if (text.empty()) return text;
  const bool isMeasured = !given.borderWidthPx && given.borderWidthRule != BorderWidthRule::kBySize;
  return std::string("chosen by size") + (isMeasured ? " and by the film's colours:" : ":") + text;
}

}  // namespace fluidymation
