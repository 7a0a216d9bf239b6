#include "pipeline/automatic_widths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "fluidymation/automatic.h"
#include "fluidymation/core/color.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/guides/rim_profile.h"
#include "fluidymation/option_ranges.h"

namespace fluidymation {
namespace {

constexpr int kFramesLookedAt = 24;

/// The mean-area rule's sigma for a sequence of masks. Looks at no more than kFramesLookedAt of
/// them, evenly spread: they are decoded once more for it.
float automaticSigma(const InputSequence& masks, MaskChannel channel,
                     const std::function<void()>& beforeFrame) {
  const int count = masks.files.count();
  const int looks = std::min(count, kFramesLookedAt);
  std::vector<double> areas;
  for (int i = 0; i < looks; ++i) {
    beforeFrame();
    const auto frame = static_cast<int>(static_cast<std::int64_t>(i) * count / looks);
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
  const int count = inputs.color.files.count();
  const int looks = std::min(count, kFramesLookedAt);
  for (int i = 0; i < looks; ++i) {
    beforeFrame();
    const auto frame = static_cast<int>(static_cast<std::int64_t>(i) * count / looks);
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
