#include "pipeline/painting_order.h"

#include <string>

#include "fluidymation/guides/drawn_lines.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/io/frame_sequence.h"
#include "pipeline/automatic_widths.h"
#include "pipeline/inputs.h"
#include "pipeline/memory_limit.h"
#include "pipeline/sequence_guides.h"
#include "pipeline/stopping.h"
#include "pipeline/thread_count.h"

namespace fluidymation {
namespace {

/// Whether the target turns out to be lines being drawn. Masks that lose material, those of nearly
/// all animations, tell without being smoothed and without any flow.
[[nodiscard]] bool drawsLines(const Options& given, const Observer& observer) {
  const ThreadCount threads(given.threads);
  const Inputs inputs = openInputs(given, Observer{});
  const int frameCount = inputs.target.files.count();
  const Stopping stopping(observer, frameCount);
  const auto stopIfWanted = [&] { stopping.check(); };
  const MaskChannel channel = maskChannel(inputs.target, stopIfWanted);
  const auto counts = [&](ReadingStage stage) {
    return countsReading(stopping, observer, stage, frameCount);
  };
  const auto readTarget = [&, beforeMask = counts(ReadingStage::kTargetMasks)](int frame) {
    beforeMask();
    return readMask(inputs.target, channel, frame);
  };
  Growth growth;
  for (int j = 0; j < frameCount; ++j) growth.add(PackedMask(readTarget(j).cut()));
  if (!growth.isDrawing()) return false;

  Options options = given;
  fillAutomaticWidths(inputs, maskChannel(inputs.sourceMask, stopIfWanted), channel, stopIfWanted,
                      options);
  RunSize size = sizeOfRun(options, inputs);
  GuideStreamSetting setting;
  setting.storage = {kWaitingBytes, FramePattern(options.outPath).folder()};
  setting.masksRead = [&](std::size_t mostPixels) {
    size.targetMaskPixels = static_cast<std::int64_t>(mostPixels);
    requireMemory(options, size);
  };
  setting.beforeFlow = counts(ReadingStage::kTargetMovement);
  return GuideStream(frameCount, readTarget,
                     guideOptions(options, *options.targetBlurSigmaPx, options.motionModel),
                     flowReader(inputs.targetFlow, stopIfWanted), setting)
      .drawsLines();
}

}  // namespace

SequenceOptions backwards(SequenceOptions sequence) {
  sequence.start += (sequence.frames - 1) * sequence.speed;
  sequence.speed = -sequence.speed;
  return sequence;
}

Options inPaintingOrder(const Options& given, const Observer& observer) {
  Options options = given;
  if (given.reverse == Reverse::kOff) return options;
  const auto tell = [&](const std::string& note) {
    if (observer.note) observer.note(note);
  };
  if (given.reverse == Reverse::kAutomatic) {
    std::string reason;
    if (given.newMaterial != NewMaterial::kPlain) {
      reason = "--new-material makes lines fresh as they are drawn";  // and that looks better
    } else if (!drawsLines(given, observer)) {
      reason = "no lines being drawn";
    }
    if (!reason.empty()) {
      options.reverse = Reverse::kOff;
      tell("--reverse auto: " + reason + ", so frames are painted from the first to the last");
      return options;
    }
  }
  options.target.frames =
      findFrames(FramePattern(given.target.path), given.target, "--target-path").count();
  options.target = backwards(options.target);
  options.target.complete = true;
  options.reverse = Reverse::kOn;
  tell(given.reverse == Reverse::kOn
           ? "painting from the last frame to the first"
           : "--reverse auto: lines being drawn, so frames are painted from the last to the first");
  return options;
}

}  // namespace fluidymation
