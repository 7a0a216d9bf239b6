#include "pipeline/automatic_widths.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "fluidymation/automatic.h"
#include "fluidymation/option_ranges.h"

namespace fluidymation {
namespace {

/// The mean-area rule's sigma for a sequence of masks. Looks at no more than kFramesLookedAt of
/// them, evenly spread: they are decoded once more for it.
float automaticSigma(const InputSequence& masks, MaskChannel channel,
                     const std::function<void()>& beforeFrame) {
  constexpr int kFramesLookedAt = 24;
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
  if (!options.borderWidthPx) options.borderWidthPx = automaticBorderWidthPx(inputs.color.scaled);
}

std::string chosenWidths(const Options& given, const Options& found) {
  std::string text;
  if (!given.blurSigmaPx) text += " --blur-sigma " + numberText(*found.blurSigmaPx);
  if (!given.targetBlurSigmaPx && !given.blurSigmaPx) {
    text += " --target-blur-sigma " + numberText(*found.targetBlurSigmaPx);
  }
  if (!given.borderWidthPx) text += " --border-width " + numberText(*found.borderWidthPx);
  return text;
}

}  // namespace fluidymation
