#include "fluidymation/inspect.h"

#include <filesystem>
#include <numeric>
#include <string>
#include <utility>

#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/option_ranges.h"
#include "inspect/guide_pictures.h"
#include "inspect/input_check.h"
#include "inspect/report.h"
#include "pipeline/automatic_widths.h"
#include "pipeline/memory.h"
#include "pipeline/memory_limit.h"
#include "pipeline/protected_files.h"
#include "pipeline/sequence_guides.h"
#include "pipeline/thread_count.h"

namespace fluidymation {
namespace {

/// What is made of a sequence while its guides pass by.
struct SequenceStudy {
  SequenceFigures figures;
  GuidePictures pictures;
  std::int64_t mostPixels = 0;  ///< inside in any frame
  bool drawsLines = false;
};

/// How a sequence is studied.
struct SequenceSetup {
  const InputSequence& masks;
  const std::optional<FlowSequence>& flow;
  MaskChannel channel;
  GuideOptions guides;
  bool withPictures = false;
  /// Told of the most mask pixels of a frame before any flow is derived; may throw to end there.
  std::function<void(std::int64_t mostPixels)> masksRead;
};

/// Where the frames of a sequence wait: nothing of a run's own folder is there yet.
/// @throws Error naming TMPDIR.
std::string temporaryFolder() {
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(failure);
  if (!failure) return folder.string();
  throw Error("TMPDIR: no folder for temporary files (" + failure.message() +
              "); wanted one that exists");
}

SequenceStudy study(const SequenceSetup& setup, float borderWidthPx,
                    const std::function<void()>& stopIfWanted) {
  const int count = setup.masks.files.count();
  SequenceStudy result{{}, GuidePictures(count), 0, false};
  std::vector<double> areas(at(count));
  const MaskReader readAndNote = [&](int frame) {
    stopIfWanted();
    InputMask mask = readMask(setup.masks, setup.channel, frame);
    areas[at(frame)] = std::accumulate(mask.coverage.begin(), mask.coverage.end(), 0.0);
    result.figures.soft = result.figures.soft || mask.soft;
    return mask;
  };
  GuideStreamSetting setting;
  setting.storage.memoryBytes = kWaitingBytes;
  setting.storage.folder = temporaryFolder();
  setting.masksRead = [&](std::size_t mostPixels) {
    result.mostPixels = static_cast<std::int64_t>(mostPixels);
    setup.masksRead(result.mostPixels);
  };
  setting.beforeFlow = stopIfWanted;
  GuideStream stream(count, readAndNote, setup.guides, flowReader(setup.flow, stopIfWanted),
                     setting);
  result.drawsLines = stream.drawsLines();
  Mask previous;
  for (int i = 0; i < count; ++i) {
    stopIfWanted();
    GuideFrame frame = stream.next();
    ShapeFigures figures = measureShape(frame, i > 0 ? &previous : nullptr, borderWidthPx);
    figures.number = setup.masks.files.numbers[at(i)];
    figures.storedAreaPx = areas[at(i)];
    result.figures.frames.push_back(figures);
    if (setup.withPictures && result.pictures.shows(i)) {
      result.pictures.keep(figures.number, frame);
    }
    previous = std::move(frame.mask);
  }
  return result;
}

/// @throws UsageError where a picture would replace an input.
void writePictures(const Options& options, const std::string& folder, const std::string& name,
                   const GuidePictures& pictures, Inspection& found) {
  const std::string place = (std::filesystem::path(folder) / name).string();
  const ProtectedFiles inputs(options);
  for (const std::string& path : pictures.paths(place)) {
    if (!inputs.contains(path)) continue;
    std::string message = "--guides ";
    message += folder;
    message += ": " + path;
    throw UsageError(message + " is an input and would be overwritten; choose another folder");
  }
  createFolder(place);
  const std::string scale = pictures.write(place, *options.borderWidthPx);
  found.report.push_back("pictures in " + place + ": " + scale);
}

}  // namespace

Inspection inspect(const Options& given, const std::optional<std::string>& guidesFolder,
                   const Observer& observer) {
  Options options = given;
  if (options.outPath.empty()) options.outPath = "%d.png";  // none is written, any name will do
  validate(options);
  options.outPath = given.outPath;
  const ThreadCount threads(options.threads);
  const auto stopIfWanted = [&] {
    if (observer.cancelled && observer.cancelled()) throw Interrupted("interrupted");
  };

  CheckedInputs checked = checkInputs(options, stopIfWanted);
  Inspection found{std::move(checked.faults), std::move(checked.notes), {}};
  if (!checked.inputs) return found;
  const Inputs& inputs = *checked.inputs;
  const MaskChannel sourceChannel = maskChannel(inputs.sourceMask, stopIfWanted);
  const MaskChannel targetChannel = maskChannel(inputs.target, stopIfWanted);
  fillAutomaticWidths(inputs, sourceChannel, targetChannel, stopIfWanted, options);

  const float rimWidthPx = measuredBorderWidthPx(
      inputs, sourceChannel, {*options.blurSigmaPx, options.maskThreshold}, stopIfWanted);
  const bool withPictures = guidesFolder.has_value();
  RunSize size = sizeOfRun(options, inputs);
  const auto countedAs = [&](std::int64_t& maskPixels) {
    return [&](std::int64_t mostPixels) {
      maskPixels = mostPixels;
      requireMemory(options, size);
    };
  };
  SequenceStudy exemplar =
      study({inputs.sourceMask, inputs.sourceFlow, sourceChannel,
             guideOptions(options, *options.blurSigmaPx, MotionModel::kNormals), withPictures,
             countedAs(size.exemplarMaskPixels)},
            *options.borderWidthPx, stopIfWanted);
  SequenceStudy target =
      study({inputs.target, inputs.targetFlow, targetChannel,
             guideOptions(options, *options.targetBlurSigmaPx, options.motionModel), withPictures,
             countedAs(size.targetMaskPixels)},
            *options.borderWidthPx, stopIfWanted);

  ReportFacts facts;
  facts.filesRead = checked.filesRead;
  facts.chosenWidths = chosenWidths(given, options);
  facts.mostBytes = bytesOfRun(size);
  facts.limitBytes = memoryLimitBytes(options);
  facts.time = estimateTime(target.figures.insidePx(), inputs.color.files.count(),
                            options.synthesis, options.threads);
  facts.threads = options.threads;
  facts.drawsLines = target.drawsLines && options.newMaterial == NewMaterial::kAutomatic;
  const KnownRun run{
      std::move(exemplar.figures), std::move(target.figures),  *options.borderWidthPx, rimWidthPx,
      *options.blurSigmaPx,        *options.targetBlurSigmaPx, options.source.speed};
  found.report = reportLines(inputs, run, facts);
  if (withPictures) {
    writePictures(options, *guidesFolder, "exemplar", exemplar.pictures, found);
    writePictures(options, *guidesFolder, "animation", target.pictures, found);
  }
  return found;
}

}  // namespace fluidymation
