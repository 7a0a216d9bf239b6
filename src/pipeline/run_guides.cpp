#include "pipeline/run_guides.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "pipeline/film.h"
#include "pipeline/memory_limit.h"
#include "pipeline/sequence_guides.h"

namespace fluidymation {
namespace {

/// A sequence whose guides are made.
struct GuidedSequence {
  const InputSequence& masks;
  MaskChannel channel;
  const std::optional<FlowSequence>& flow;
  GuideOptions options;
  ReadingStage masksStage;
  ReadingStage flowStage;
};

void emplaceGuides(std::optional<GuideStream>& stream, const GuidedSequence& sequence,
                   GuideStreamSetting setting, const Stopping& stopping, const Observer& observer) {
  const int frameCount = sequence.masks.files.count();
  const auto counts = [&](ReadingStage stage) {
    return countsReading(stopping, observer, stage, frameCount);
  };
  setting.beforeFlow = counts(sequence.flowStage);
  const auto readInput = [&, beforeMask = counts(sequence.masksStage)](int frame) {
    beforeMask();
    return readMask(sequence.masks, sequence.channel, frame);
  };
  stream.emplace(frameCount, readInput, sequence.options,
                 flowReader(sequence.flow, setting.beforeFlow), setting);
}

}  // namespace

RunGuides::RunGuides(const Options& options, const Inputs& inputs, const MaskChannels& channels,
                     const FilmWindow& window, const std::string& folder, const Stopping& stopping,
                     const Observer& observer)
    : size_(sizeOfRun(options, inputs)) {
  const auto settingFor = [&](std::int64_t& maskPixels) {
    GuideStreamSetting setting;
    setting.storage = {kWaitingBytes, folder};
    setting.masksRead = [&](std::size_t mostPixels) {
      maskPixels = static_cast<std::int64_t>(mostPixels);
      requireMemory(options, size_);
    };
    return setting;
  };
  GuideStreamSetting ofFilm = settingFor(size_.exemplarMaskPixels);
  ofFilm.keeps = !window.isWhole();
  emplaceGuides(film_,
                {inputs.sourceMask, channels.source, inputs.sourceFlow,
                 guideOptions(options, *options.blurSigmaPx, MotionModel::kNormals),
                 ReadingStage::kFilmMasks, ReadingStage::kFilmMovement},
                std::move(ofFilm), stopping, observer);
  requireMaterial(options, window, *film_);
  emplaceGuides(target_,
                {inputs.target, channels.target, inputs.targetFlow,
                 guideOptions(options, *options.targetBlurSigmaPx, options.motionModel),
                 ReadingStage::kTargetMasks, ReadingStage::kTargetMovement},
                settingFor(size_.targetMaskPixels), stopping, observer);
}

}  // namespace fluidymation
