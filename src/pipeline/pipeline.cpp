#include "fluidymation/pipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/guides/material_age.h"
#include "fluidymation/option_ranges.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/stages.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "pipeline/automatic_widths.h"
#include "pipeline/flow_note.h"
#include "pipeline/frame_line.h"
#include "pipeline/frame_writer.h"
#include "pipeline/given_flow.h"
#include "pipeline/guide_dump.h"
#include "pipeline/inputs.h"
#include "pipeline/memory.h"
#include "pipeline/nnf_dump.h"
#include "pipeline/option_texts.h"
#include "pipeline/outputs.h"
#include "pipeline/run_fingerprint.h"
#include "pipeline/run_journal.h"
#include "pipeline/run_lock.h"
#include "pipeline/starting_point.h"
#include "pipeline/thread_count.h"

namespace fluidymation {
namespace {

/// @throws Interrupted when the caller wants no more.
void stopIfCancelled(const Observer& observer, int written, int count) {
  if (!observer.cancelled || !observer.cancelled()) return;
  throw Interrupted("interrupted; " + std::to_string(written) + " of " + std::to_string(count) +
                    " frames written");
}

void tell(const Observer& observer, const std::string& note) {
  if (!note.empty() && observer.note) observer.note(note);
}

/// Lets a frame be dropped at the beginning of any of its stages.
class StopAtStages : public StageObserver {
 public:
  /// @param stopIfWanted  throws to stop.
  explicit StopAtStages(std::function<void()> stopIfWanted) : stop_(std::move(stopIfWanted)) {}

  void begins(Stage /*stage*/, int /*level*/) override { stop_(); }
  void ends(Stage /*stage*/, int /*level*/) override {}
  void searched(int /*level*/, const SearchStatistics& /*done*/) override {}

 private:
  std::function<void()> stop_;
};

void tellOfFlow(const Observer& observer, const std::string& option, int frameNumber,
                const GuideFrame& frame) {
  const std::optional<std::string> note = flowNote(option, frameNumber, frame.diffusion);
  if (note && observer.note) observer.note(*note);
}

/// @throws Error when no mask of the exemplar holds any material.
void requireMaterial(const Options& options, const GuideStream& guides) {
  if (guides.anyInside()) return;
  throw Error("--src-mask-path " + options.sourceMaskPath + ": all " +
              std::to_string(guides.frameCount()) +
              " masks are empty after smoothing with --blur-sigma; wanted some material, so "
              "check the masks or lower --blur-sigma");
}

/// Says so when nothing of the target is going to be painted.
void tellOfEmptyTarget(const Observer& observer, const Options& options,
                       const GuideStream& guides) {
  if (guides.anyInside() || !observer.note) return;
  observer.note("--target-path " + options.target.path + ": all " +
                std::to_string(guides.frameCount()) +
                " masks are empty after smoothing, so nothing is painted; check the masks, "
                "--target-blur-sigma (now " +
                numberText(*options.targetBlurSigmaPx) + ") and --mask-threshold (now " +
                numberText(options.maskThreshold) + "; one half where nothing is smoothed)");
}

/// How the guides of a sequence are made whose masks are smoothed by this sigma and which moves by
/// this model.
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

/// Reads the given flow; empty where there is none.
/// @param flow        must outlive the reader.
/// @param beforeEach  called before each frame.
FlowReader flowReader(const std::optional<FlowSequence>& flow,
                      const std::function<void()>& beforeEach) {
  if (!flow) return {};
  return [beforeEach, given = std::make_shared<GivenFlow>(*flow)](int frame, const Mask& previous) {
    beforeEach();
    return given->flow(frame, previous);
  };
}

/// Whether ages take the place of motion extents. Tells the user when that was found.
bool comparesAges(const Options& options, const GuideStream& target, const Observer& observer) {
  if (options.newMaterial != NewMaterial::kAutomatic) {
    return options.newMaterial == NewMaterial::kFresh;
  }
  if (!target.drawsLines()) return false;
  if (observer.note) {
    observer.note(
        "lines being drawn: new material looks fresh, what lies longer older "
        "(--new-material plain turns it off)");
  }
  return true;
}

/// The exemplar with its colours, which are all that is read of it after masks and flow.
/// @throws Interrupted, Error.
Exemplar readPictures(const Options& options, const Inputs& inputs, const Observer& observer) {
  const Size size = inputs.color.scaled;
  Exemplar exemplar(size, inputs.color.files.count(), coarsestLevel(size, inputs.target.scaled),
                    *options.borderWidthPx, options.synthesis.shape);
  for (int k = 0; k < exemplar.frameCount(); ++k) {
    stopIfCancelled(observer, 0, inputs.target.files.count());
    exemplar.setColor(k, toLab(readPicture(inputs.color, k)));
  }
  return exemplar;
}

/// Completes the exemplar by its guides, and dumps them where that is wanted.
/// @param withAges  whether they hold ages.
/// @throws Interrupted, Error.
void addGuides(const Options& options, const Inputs& inputs, bool withAges, GuideStream& guides,
               const Observer& observer, Exemplar& exemplar) {
  FilmAges ages;
  for (int k = 0; k < exemplar.frameCount(); ++k) {
    stopIfCancelled(observer, 0, inputs.target.files.count());
    GuideFrame frame = guides.next();
    if (withAges) frame.age = ages.next(frame.mask);
    const int number = inputs.color.files.numbers[static_cast<std::size_t>(k)];
    tellOfFlow(observer, "--src-mask-path " + options.sourceMaskPath, number, frame);
    exemplar.setGuides(k, frame);
    if (options.dumpGuidesDirectory) {
      dumpGuides(dumpFolder(options, "source"), number, frame);
    }
  }
  exemplar.finish(options.synthesis.extentUnit);
}

/// Makes the guides of the target's frames, with their ages where they are compared.
std::function<GuideFrame(int)> guideStage(GuideStream& guides, bool withAges) {
  return [&guides, withAges, ages = std::make_shared<TargetAges>()](int /*frame*/) {
    GuideFrame frame = guides.next();
    if (withAges) {
      frame.age = ages->next(frame.mask);
      frame.ageGrows = ages->haveGrown();
    }
    return frame;
  };
}

RunIdentity identityOf(const Options& options, const Inputs& inputs,
                       const std::vector<std::string>& outPaths,
                       const std::function<void()>& beforeEach) {
  const CheckpointLimits limits{inputs.color.scaled, inputs.color.files.count(),
                                inputs.target.scaled, inputs.target.files.count()};
  return {RunFiles(FramePattern(options.outPath)), inputs.target.files.numbers, outPaths,
          fingerprintOf(options, inputs, beforeEach), limits};
}

/// Brings guides and search to where painting begins: the guides of each frame depend on those
/// before it.
void goOn(const std::function<GuideFrame(int)>& guide, StartingPoint& start,
          const std::function<void()>& stopIfWanted, Synthesizer& synthesizer) {
  GuideFrame last;
  for (int j = 0; j < start.span.begin; ++j) {
    stopIfWanted();
    last = guide(j);
  }
  if (start.state) {
    synthesizer.restore(std::move(*start.state), last);
  } else {
    synthesizer.startAfresh(start.span.begin);
  }
}

/// Paints, and saves the state when that is stopped or fails.
/// @throws what `paint` throws; where that is Interrupted, with the way to go on.
void runSavingState(RunJournal& journal, const std::function<void()>& paint) {
  try {
    paint();
  } catch (const Interrupted& stop) {
    std::string text = stop.what();
    bool canResume = false;
    try {
      canResume = journal.save();
      if (canResume) text += "; --resume goes on from there";
    } catch (const Error& error) {
      text += std::string("; the state cannot be saved: ") + error.what();
    }
    throw Interrupted(text, canResume);
  } catch (...) {
    try {
      journal.save();
    } catch (const Error&) {  // the first fault is the one to tell of
    }
    throw;
  }
  journal.finish();
}

/// What is written of a frame that is not dumped.
GuideFrame outlineOnly(GuideFrame guides) {
  GuideFrame outline;
  outline.mask = std::move(guides.mask);
  outline.coverage = std::move(guides.coverage);
  return outline;
}

}  // namespace

void stylize(const Options& given, const Observer& observer) {
  validate(given);
  const ThreadShares shares = shareThreads(given.threads);
  const ThreadCount threads(given.threads, shares.beside());

  const Inputs inputs = openInputs(given, observer);
  Options options = given;
  const std::vector<std::string> outPaths = checkOutput(options, inputs);
  const int frameCount = inputs.target.files.count();
  const auto stopBeforeTheFirst = [&] { stopIfCancelled(observer, 0, frameCount); };

  // All files are read before anything is written, and only masks, flows and colours are kept: a
  // damaged one must leave neither half a dump nor an empty folder.
  const MaskChannel sourceChannel = maskChannel(inputs.sourceMask, stopBeforeTheFirst);
  const MaskChannel targetChannel = maskChannel(inputs.target, stopBeforeTheFirst);
  fillAutomaticWidths(inputs, sourceChannel, targetChannel, stopBeforeTheFirst, options);
  const std::string chosen = chosenWidths(given, options);
  if (!chosen.empty() && observer.note) observer.note("chosen by size:" + chosen);

  RunIdentity run = identityOf(options, inputs, outPaths, stopBeforeTheFirst);
  RunLock lock(run.files);
  lock.takeIfUsed();
  const FrameSpan wanted = wantedFrames(options, run.numbers);
  StartingPoint start = findStart(options.continuation, wanted, run, stopBeforeTheFirst);
  tell(observer, start.note);
  if (start.span.begin == start.span.end) return;

  GuideStream sourceGuides(
      inputs.sourceMask.files.count(),
      [&](int frame) {
        stopBeforeTheFirst();
        return readMask(inputs.sourceMask, sourceChannel, frame);
      },
      guideOptions(options, *options.blurSigmaPx, MotionModel::kNormals),
      flowReader(inputs.sourceFlow, stopBeforeTheFirst), {}, stopBeforeTheFirst);
  requireMaterial(options, sourceGuides);
  const std::int64_t otherBytes = bytesOfRun(sizeOfRun(options, inputs));
  GuideStream guides(
      frameCount,
      [&](int frame) {
        stopBeforeTheFirst();
        return readMask(inputs.target, targetChannel, frame);
      },
      guideOptions(options, *options.targetBlurSigmaPx, options.motionModel),
      flowReader(inputs.targetFlow, stopBeforeTheFirst),
      memoryWatch(options.target.path, frameCount, otherBytes), stopBeforeTheFirst);
  tellOfEmptyTarget(observer, options, guides);
  const bool withAges = comparesAges(options, guides, observer);
  Exemplar exemplar = readPictures(options, inputs, observer);
  createOutputFolders(options, outPaths);
  tell(observer, lock.take());
  addGuides(options, inputs, withAges, sourceGuides, observer, exemplar);
  int frameAtWork = start.span.begin;
  const auto stopIfWanted = [&] { stopIfCancelled(observer, frameAtWork, frameCount); };
  StopAtStages stops(stopIfWanted);
  Synthesizer synthesizer(exemplar, options.synthesis, &stops);
  FrameWriter writer(options.compressionLevel);
  RunJournal journal(run, wanted, start, pathOptions(options), options.continuation);
  journal.discardOldStates();

  const bool dumps = options.dumpGuidesDirectory.has_value();
  const std::vector<int>& numbers = run.numbers;
  FrameStages stages;
  stages.guide = guideStage(guides, withAges);
  goOn(stages.guide, start, stopIfWanted, synthesizer);
  std::optional<std::string> note;  // on the frame painted last
  stages.paint = [&](int j, GuideFrame frame) {
    note = flowNote("--target-path " + options.target.path, numbers[at(j)], frame.diffusion);
    PaintedFrame painted;
    painted.picture = synthesizer.paint(frame);
    painted.guides = dumps ? std::move(frame) : outlineOnly(std::move(frame));
    if (dumps) painted.nnf = synthesizer.nnf();
    painted.state = std::make_shared<const SynthesisState>(synthesizer.state());
    return painted;
  };
  stages.write = [&](int j, const PaintedFrame& painted) {
    const Digest digest = writer.write(outPaths[at(j)], painted.picture, painted.guides);
    if (dumps) {
      const std::string folder = dumpFolder(options, "target");
      dumpGuides(folder, numbers[at(j)], painted.guides);
      dumpNearestNeighborField(folder, numbers[at(j)], *painted.nnf, inputs.color.files.numbers,
                               exemplar.level(0).size());
    }
    journal.frameWritten(j, digest, painted.state);
  };

  FrameEvents events;
  events.begins = [&](int j) {
    frameAtWork = j;
    stopIfWanted();
  };
  events.painted = [&](int /*frame*/) {
    if (note && observer.note) observer.note(*note);
  };
  events.written = [&](int j, double seconds) {
    if (!observer.frameDone) return;
    observer.frameDone({j, start.span.end, numbers[at(j)], seconds, outPaths[at(j)]});
  };
  if (observer.paintingBegins) observer.paintingBegins(start.span.begin, start.span.end);
  runSavingState(journal, [&] { runFrames(start.span, stages, shares, events); });
}

}  // namespace fluidymation
