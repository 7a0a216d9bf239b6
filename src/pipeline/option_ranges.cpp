#include "fluidymation/option_ranges.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "fluidymation/core/error.h"
#include "fluidymation/io/frame_pattern.h"

namespace fluidymation {
namespace {

template <typename T>
[[nodiscard]] bool lies(T value, const Range& range) {
  const auto low = static_cast<T>(range.low);
  const auto high = static_cast<T>(range.high);
  return (range.lowOpen ? value > low : value >= low) &&
         (range.highOpen ? value < high : value <= high);
}

template <typename T>
[[nodiscard]] std::string shortestText(T value) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

/// 1000000 rather than 1e+06.
[[nodiscard]] std::string boundText(double value) {
  constexpr double kLargestPlain = 1e15;
  const auto whole = static_cast<std::int64_t>(std::clamp(value, -kLargestPlain, kLargestPlain));
  return static_cast<double>(whole) == value ? std::to_string(whole) : shortestText(value);
}

void check(const std::string& option, int value, const Range& range) {
  if (range.contains(value)) return;
  throw UsageError(option + " " + std::to_string(value) + ": wanted a whole number in " +
                   range.text());
}

template <typename T>
void check(const std::string& option, T value, const Range& range) {
  if (range.contains(value)) return;
  throw UsageError(option + " " + numberText(value) + ": wanted a number in " + range.text());
}

void check(const std::string& option, const std::vector<int>& values, const Range& range) {
  if (values.empty() || values.size() > static_cast<std::size_t>(ranges::kLongestList)) {
    throw UsageError(option + ": " + std::to_string(values.size()) + " numbers; wanted 1 to " +
                     std::to_string(ranges::kLongestList));
  }
  for (const int value : values) check(option, value, range);
}

void check(const std::string& prefix, const SequenceOptions& sequence) {
  checkPattern(prefix + "-path", sequence.path);
  check(prefix + "-start", sequence.start, ranges::kFrameNumbers);
  check(prefix + "-frames", sequence.frames, ranges::kFrameCounts);
  check(prefix + "-speed", sequence.speed, ranges::kSpeeds);
  if (sequence.speed == 0) throw UsageError(prefix + "-speed 0: wanted a number other than 0");
  check(prefix + "-scale", sequence.scale, ranges::kScales);
}

void checkFlow(const std::string& prefix, const std::optional<std::string>& path,
               const SequenceOptions& sequence) {
  if (!path) return;
  checkPattern(prefix + "-flow-path", *path);
  if (sequence.speed == 1 || sequence.speed == -1) return;
  throw UsageError(prefix + "-speed " + std::to_string(sequence.speed) + ": wanted 1 or -1 with " +
                   prefix + "-flow-path, whose files lead from one frame to the next");
}

void check(const ModulationBounds& bounds) {
  const std::string option = "--prev-modulation-bounds";
  const bool inPixels = bounds.unit == ModulationUnit::kPixels;
  const Range& range = inPixels ? ranges::kModulationBoundsPx : ranges::kModulationShares;
  check(option, bounds.upper, range);
  check(option, bounds.lower, range);
  if (bounds.upper > bounds.lower) return;
  throw UsageError(option + " " + numberText(bounds.upper) + "," + numberText(bounds.lower) +
                   ": wanted m_u greater than m_l");
}

void check(const SynthesisOptions& synthesis) {
  check("--tex-weight", synthesis.texWeight, ranges::kWeights);
  check("--dist-weight", synthesis.distWeight, ranges::kWeights);
  check("depthSigmaPx", synthesis.paintedVote.depthSigmaPx, ranges::kVoteSigmasPx);  // no option
  check("edgeGain", synthesis.edgeGain, ranges::kWeights);  // has no option
  check("prevGain", synthesis.prevGain, ranges::kWeights);  // nor has this
  check("--flow-weight", synthesis.flowWeight, ranges::kWeights);
  check("--dir-weight", synthesis.dirWeight, ranges::kWeights);
  check("--prev-weight", synthesis.prevWeight, ranges::kWeights);
  check("--prev-deepening", synthesis.prevDeepening, ranges::kDeepenings);
  check("--prev-depth-reach", synthesis.prevDepthReachFrames, ranges::kDepthReaches);
  check("--prev-color-correction", synthesis.prevColorCorrection, ranges::kColorCorrections);
  check(synthesis.prevModulation);
  check("--opt-vote-sigma", synthesis.optVoteSigmaPx, ranges::kVoteSigmasPx);
  check("--vote-sigma", synthesis.paintedVote.sigmaPx, ranges::kVoteSigmasPx);
  check("--seam-blending", synthesis.paintedVote.seamWeight, ranges::kSeamWeights);
  check("--change-blending", synthesis.changeBlending, ranges::kChangeShares);
  check("--detail-restoration", synthesis.detailRestoration, ranges::kDetailShares);
  check("--coherence-weight", synthesis.coherenceWeight, ranges::kWeights);
  check("--lambda", synthesis.lambda, ranges::kWeights);
  check("--occ-radius", synthesis.occRadiusFrames, ranges::kOccurrenceRadii);
  check("--patchmatch-alpha", synthesis.patchmatchAlpha, ranges::kAlphas);
  check("--patchmatch-iterations", synthesis.patchmatchIterations, ranges::kPatchmatchIterations);
  check("--opt-iterations", synthesis.optIterations, ranges::kOptIterations);
}

}  // namespace

bool Range::contains(double value) const { return lies(value, *this); }
bool Range::contains(float value) const { return lies(value, *this); }
bool Range::contains(int value) const { return lies(static_cast<double>(value), *this); }

std::string Range::text() const {
  return (lowOpen ? "(" : "[") + boundText(low) + ", " + boundText(high) + (highOpen ? ")" : "]");
}

std::string numberText(double value) { return shortestText(value); }
std::string numberText(float value) { return shortestText(value); }

void checkPattern(const std::string& option, const std::string& pattern) {
  try {
    const FramePattern parsed(pattern);
  } catch (const UsageError& error) {
    throw UsageError(option + ": " + error.what());
  }
}

void checkOutputPattern(const std::string& option, const std::string& pattern) {
  checkPattern(option, pattern);
  std::string ending = pattern.substr(pattern.size() - std::min<std::size_t>(pattern.size(), 4));
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (ending == ".png") return;
  throw UsageError(option + ": " + pattern +
                   ": frames are written as PNG; wanted a name that ends in .png");
}

void validate(const Options& options) {
  check("--src", options.source);
  checkPattern("--src-mask-path", options.sourceMaskPath);
  check("--src-window", options.sourceWindowFrames, ranges::kWindowFrameCounts);
  if (options.sourceWindowFrames != 0 && options.sourceWindowFrames < ranges::kLeastWindowFrames) {
    throw UsageError("--src-window " + std::to_string(options.sourceWindowFrames) +
                     ": nothing can move in it; wanted 0 for all frames, or at least " +
                     std::to_string(ranges::kLeastWindowFrames));
  }
  check("--target", options.target);
  checkOutputPattern("--out-path", options.outPath);
  checkFlow("--src", options.sourceFlowPath, options.source);
  checkFlow("--target", options.targetFlowPath, options.target);
  if (options.flowConvention != FlowConvention::kBackward && !options.sourceFlowPath &&
      !options.targetFlowPath) {
    throw UsageError(
        "--flow-convention forward: wanted with --src-flow-path or --target-flow-path only");
  }
  if (options.motionModel != MotionModel::kNormals && options.targetFlowPath) {
    throw UsageError(
        "--motion-model rigid: not wanted with --target-flow-path, which tells how things move");
  }
  if (options.reverse == Reverse::kOn && options.newMaterial == NewMaterial::kFresh) {
    throw UsageError(
        "--reverse on: not wanted with --new-material fresh, which paints lines being drawn in "
        "their own order");
  }
  if (options.dumpGuidesDirectory && options.dumpGuidesDirectory->empty()) {
    throw UsageError("--dump-guides with an empty value: wanted a folder's name");
  }
  if (options.blurSigmaPx) check("--blur-sigma", *options.blurSigmaPx, ranges::kSigmasPx);
  if (options.targetBlurSigmaPx) {
    check("--target-blur-sigma", *options.targetBlurSigmaPx, ranges::kSigmasPx);
  }
  check("--mask-threshold", options.maskThreshold, ranges::kThresholds);
  if (options.borderWidthPx) check("--border-width", *options.borderWidthPx, ranges::kWidthsPx);
  check("--time-blur-sigma", options.timeBlurSigmaFrames, ranges::kTimeSigmasFrames);
  check("--flow-blur-sigma", options.flowBlurSigmaFrames, ranges::kTimeSigmasFrames);
  check(options.synthesis);
  if (options.continuation.resume && options.continuation.restart) {
    throw UsageError("--resume, --restart: wanted one of them at most");
  }
  if (const std::optional<FrameNumbers>& part = options.continuation.render) {
    // Of an animation that is played backwards either end may be named first.
    if (part->first > part->last && options.target.speed > 0) {
      throw UsageError("--render-frames " + std::to_string(part->first) + "-" +
                       std::to_string(part->last) + ": wanted the first frame before the last, " +
                       std::to_string(part->last) + "-" + std::to_string(part->first));
    }
  }
  if (options.continuation.existing == ExistingFrames::kKeep &&
      (options.continuation.resume || options.continuation.restart)) {
    throw UsageError(
        "--skip-existing: not wanted with --resume or --restart, which know what is painted");
  }
  if (options.continuation.checkpointEvery) {
    check("--checkpoint-every", *options.continuation.checkpointEvery, ranges::kCheckpointFrames);
  }
  check("--compression-level", options.compressionLevel, ranges::kCompressionLevels);
  check("--threads", options.threads, ranges::kThreads);
  if (options.maxMemoryBytes && *options.maxMemoryBytes < ranges::kLeastMemoryBytes) {
    throw UsageError("--max-memory " + std::to_string(*options.maxMemoryBytes) +
                     ": wanted at least " + std::to_string(ranges::kLeastMemoryBytes) +
                     " bytes (16M)");
  }
}

}  // namespace fluidymation
