#include "pipeline/inputs.h"

#include <algorithm>
#include <cstdint>

#include "fluidymation/core/error.h"
#include "fluidymation/core/resize.h"
#include "fluidymation/core/text.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/io/png.h"
#include "pipeline/backdrop.h"
#include "pipeline/fault_list.h"
#include "pipeline/film_window.h"
#include "pipeline/given_flow.h"
#include "pipeline/memory_limit.h"

namespace fluidymation {
namespace {

InputSequence openSequence(const std::string& path, const SequenceOptions& sequence,
                           const std::string& optionName, const Observer& observer) {
  InputSequence input;
  input.files = findFrames(FramePattern(path), sequence, optionName);
  if (!input.files.note.empty() && observer.note) observer.note(input.files.note);
  input.identities = identitiesOf(input.files);  // before anything is read of them
  input.stored = commonSize(input.files);
  input.scaled = scaledSize(input.stored, sequence.scale);
  if (input.scaled.width > kMaxImageSidePx || input.scaled.height > kMaxImageSidePx ||
      static_cast<std::int64_t>(input.scaled.width) * input.scaled.height > kMaxImagePixels) {
    throw UsageError(optionName + ": frames scaled to " + sizeText(input.scaled) +
                     "; wanted at most " + std::to_string(kMaxImageSidePx) + " px a side and " +
                     std::to_string(kMaxImagePixels) + " px in all");
  }
  return input;
}

void requireMasksFit(const Options& options, const Inputs& inputs) {
  const FrameFiles& color = inputs.color.files;
  const FrameFiles& mask = inputs.sourceMask.files;
  if (color.count() != mask.count()) {
    throw Error("--src-mask-path " + options.sourceMaskPath + ": " + std::to_string(mask.count()) +
                " frames, but --src-path " + options.source.path + " has " +
                std::to_string(color.count()) + "; an exemplar and its masks must agree");
  }
  requireMasksOfSameSize(color, mask);
}

/// The masks of the exemplar have the size of its pictures.
Size largestStored(const Inputs& inputs) {
  const auto area = [](Size size) { return std::int64_t{size.width} * size.height; };
  const Size exemplar = inputs.color.stored;
  const Size target = inputs.target.stored;
  const Size background = inputs.background ? inputs.background->stored : Size{};
  return std::max({exemplar, target, background},
                  [&](Size a, Size b) { return area(a) < area(b); });
}

}  // namespace

Inputs openInputs(const Options& options, const Observer& observer) {
  Inputs inputs;
  FaultList faults;
  const bool film = faults.gatherUnlessMisused([&] {
    inputs.color = openSequence(options.source.path, options.source, "--src-path", observer);
  });
  const bool filmMasks = faults.gatherUnlessMisused([&] {
    inputs.sourceMask =
        openSequence(options.sourceMaskPath, options.source, "--src-mask-path", Observer{});
  });
  const bool target = faults.gatherUnlessMisused([&] {
    inputs.target = openSequence(options.target.path, options.target, "--target-path", observer);
  });
  if (film && filmMasks) faults.gatherUnlessMisused([&] { requireMasksFit(options, inputs); });
  if (options.sourceFlowPath && filmMasks) {
    faults.gatherUnlessMisused([&] {
      inputs.sourceFlow =
          openFlowSequence(*options.sourceFlowPath, "--src-flow-path", options.flowConvention,
                           options.source, inputs.sourceMask);
    });
  }
  if (options.targetFlowPath && target) {
    faults.gatherUnlessMisused([&] {
      inputs.targetFlow = openFlowSequence(*options.targetFlowPath, "--target-flow-path",
                                           options.flowConvention, options.target, inputs.target);
    });
  }
  if (options.background) {
    faults.gatherUnlessMisused(
        [&] { inputs.background = openBackground("--background", *options.background); });
  }
  faults.throwIfAny();
  requireMemory(options, sizeOfRun(options, inputs));  // in any case, whatever the masks hold
  return inputs;
}

std::optional<BackgroundFile> openBackground(const std::string& option, const std::string& text) {
  if (!isBackgroundFile(text)) return std::nullopt;
  requireBackground(option, text);
  const FileIdentity identity = fileIdentityOf(text);
  return BackgroundFile{identity, readPngSize(text)};
}

std::vector<FileIdentity> identitiesOf(const FrameFiles& files) {
  std::vector<FileIdentity> identities;
  for (const std::string& path : files.paths) {
    identities.push_back(path.empty() ? FileIdentity{} : fileIdentityOf(path));
  }
  return identities;
}

RunSize sizeOfRun(const Options& options, const Inputs& inputs) {
  RunSize run;
  run.exemplar = inputs.color.scaled;
  run.exemplarFrames = inputs.color.files.count();
  run.heldFrames =
      FilmWindow(options, inputs.color.files.count(), inputs.target.files.count()).heldFrames();
  run.target = inputs.target.scaled;
  run.targetFrames = inputs.target.files.count();
  run.threads = options.threads;
  run.timeBlurSigmaFrames = options.timeBlurSigmaFrames;
  run.largestStored = largestStored(inputs);
  run.flowBlurSigmaFrames = options.flowBlurSigmaFrames;
  run.shape = options.synthesis.shape;
  run.occRadiusFrames = options.synthesis.occRadiusFrames;
  run.finestLevel = options.synthesis.finestLevel;
  run.mayCompareAges = options.newMaterial != NewMaterial::kPlain;
  run.temporalCoherence = options.synthesis.temporalCoherence;
  run.bitDepth = options.bitDepth;
  run.hasBackground = options.background.has_value();
  run.hasBareSurface = options.background == kExemplarSurface;
  run.dumps = options.dumpGuidesDirectory.has_value();
  if (inputs.sourceFlow) run.exemplarFlow = inputs.sourceFlow->stored;
  if (inputs.targetFlow) run.targetFlow = inputs.targetFlow->stored;
  return run;
}

MaskChannel maskChannel(const InputSequence& masks, const std::function<void()>& beforeFrame) {
  for (std::size_t i = 0; i < masks.files.paths.size(); ++i) {
    beforeFrame();
    const bool transparent = hasTransparency(masks.files.paths[i], masks.stored);
    requireUnchanged(masks.files.paths[i], masks.identities[i]);
    if (transparent) return MaskChannel::kAlpha;
  }
  return MaskChannel::kBrightness;
}

InputMask readMask(const InputSequence& masks, MaskChannel channel, int frame) {
  const std::string& path = masks.files.paths[static_cast<std::size_t>(frame)];
  Image<float> stored = readCoverage(path, channel, masks.stored);
  requireUnchanged(path, masks.identities[static_cast<std::size_t>(frame)]);
  const bool soft =
      std::any_of(stored.begin(), stored.end(), [](float c) { return c > 0.0F && c < 1.0F; });
  if (masks.scaled == masks.stored) return {std::move(stored), soft};
  return {resize(stored, masks.scaled), soft};
}

Image<Rgb> readPicture(const InputSequence& pictures, int frame) {
  const std::string& path = pictures.files.paths[static_cast<std::size_t>(frame)];
  const Image<Rgb> stored = readColor(path, pictures.stored);
  requireUnchanged(path, pictures.identities[static_cast<std::size_t>(frame)]);
  return resize(stored, pictures.scaled);
}

}  // namespace fluidymation
