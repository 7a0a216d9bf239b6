#include "fluidymation/pipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
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
#include "fluidymation/option_ranges.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "pipeline/automatic_widths.h"
#include "pipeline/existing_frames.h"
#include "pipeline/film.h"
#include "pipeline/film_window.h"
#include "pipeline/flow_note.h"
#include "pipeline/frame_form.h"
#include "pipeline/frame_line.h"
#include "pipeline/frame_painter.h"
#include "pipeline/frame_replacement.h"
#include "pipeline/frame_writer.h"
#include "pipeline/given_flow.h"
#include "pipeline/guide_dump.h"
#include "pipeline/inputs.h"
#include "pipeline/medium_colors.h"
#include "pipeline/memory.h"
#include "pipeline/memory_limit.h"
#include "pipeline/nnf_dump.h"
#include "pipeline/option_texts.h"
#include "pipeline/outputs.h"
#include "pipeline/painting_order.h"
#include "pipeline/run_journal.h"
#include "pipeline/run_lock.h"
#include "pipeline/sequence_guides.h"
#include "pipeline/starting_point.h"
#include "pipeline/stopping.h"
#include "pipeline/target_guides.h"
#include "pipeline/thread_count.h"

namespace fluidymation {
namespace {

void tell(const Observer& observer, const std::string& note) {
  if (!note.empty() && observer.note) observer.note(note);
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

/// Whether ages take the place of motion extents. Tells the user when that was found.
bool comparesAges(const Options& options, const GuideStream& target, const Observer& observer) {
  if (options.newMaterial != NewMaterial::kAutomatic) {
    return options.newMaterial == NewMaterial::kFresh;
  }
  // Where lines are erased, they are drawn in the order of painting only
  if (options.reverse == Reverse::kOn) return false;
  if (!target.drawsLines()) return false;
  if (observer.note) {
    observer.note(
        "lines being drawn: new material looks fresh, what lies longer older "
        "(--new-material plain turns it off)");
  }
  return true;
}

/// Brings guides and search to where painting begins.
void goOn(const GuideSource& guides, StartingPoint& start, const Stopping& stopping,
          Synthesizer& synthesizer) {
  const GuideFrame last = passOver(start.span.begin, start.state.has_value(), guides,
                                   [&stopping] { stopping.check(); });
  if (start.state) {
    synthesizer.restore(std::move(*start.state), last);
  } else {
    synthesizer.startAfresh(start.span.begin);
  }
}

/// Paints the frames of the target in the order that the options give.
void paintInOrder(const Options& given, const Observer& observer) {
  const ThreadShares shares = shareThreads(given.threads);
  const ThreadCount threads(given.threads, shares.beside());

  const Inputs inputs = openInputs(given, observer);
  Options options = given;
  const std::vector<std::string> outPaths = checkOutput(options, inputs);
  const int frameCount = inputs.target.files.count();
  Stopping stopping(observer, frameCount);
  const auto stopIfWanted = [&] { stopping.check(); };

  // All files are read before anything is written, and only masks, flows and colours are kept: a
  // damaged one must leave neither half a dump nor an empty folder.
  const MaskChannel sourceChannel = maskChannel(inputs.sourceMask, stopIfWanted);
  const MaskChannel targetChannel = maskChannel(inputs.target, stopIfWanted);
  fillAutomaticWidths(inputs, sourceChannel, targetChannel, stopIfWanted, options);
  const std::string chosen = chosenWidths(given, options);
  if (!chosen.empty() && observer.note) observer.note(chosen);

  const std::optional<Recoloring> recoloring =
      recoloringFor(options, inputs, sourceChannel, stopIfWanted);
  const RunIdentity run = identityOf(options, inputs, outPaths, stopIfWanted);
  RunLock lock(run.files);
  lock.takeIfUsed();
  const FrameSpan wanted = wantedFrames(options, run.numbers);
  StartingPoint start = findStart(options.continuation, wanted, run, stopIfWanted);
  tell(observer, start.note);
  const FrameReplacement replacement(
      run, start.span, requireOwnFrames(options.continuation, run, start, stopIfWanted),
      options.continuation.waysOut);
  if (start.span.begin == start.span.end) {
    replacement.finish();
    return;
  }
  const auto countWritten = [&](int j) {  // all before frame j
    stopping.setWritten(j - wanted.begin, wanted.end - wanted.begin);
  };
  countWritten(start.span.begin);

  FrameForm form = formOf(options, inputs, observer, stopIfWanted);
  RunSize size = sizeOfRun(options, inputs);
  const FilmWindow window(options, inputs.color.files.count(), frameCount);
  const auto settingFor = [&](std::int64_t& maskPixels, const std::function<void()>& beforeFlow) {
    GuideStreamSetting setting;
    setting.storage = {kWaitingBytes, run.files.folder()};
    setting.masksRead = [&](std::size_t mostPixels) {
      maskPixels = static_cast<std::int64_t>(mostPixels);
      requireMemory(options, size);
    };
    setting.beforeFlow = beforeFlow;
    return setting;
  };
  const auto counts = [&](ReadingStage stage, int count) {
    return countsReading(stopping, observer, stage, count);
  };
  const int filmFrames = inputs.sourceMask.files.count();
  const auto beforeFilmFlow = counts(ReadingStage::kFilmMovement, filmFrames);
  const auto beforeTargetFlow = counts(ReadingStage::kTargetMovement, frameCount);
  GuideStreamSetting sourceSetting = settingFor(size.exemplarMaskPixels, beforeFilmFlow);
  sourceSetting.keeps = !window.isWhole();
  GuideStream sourceGuides(
      filmFrames,
      [&, beforeMask = counts(ReadingStage::kFilmMasks, filmFrames)](int frame) {
        beforeMask();
        return readMask(inputs.sourceMask, sourceChannel, frame);
      },
      guideOptions(options, *options.blurSigmaPx, MotionModel::kNormals),
      flowReader(inputs.sourceFlow, beforeFilmFlow), sourceSetting);
  requireMaterial(options, window, sourceGuides);
  GuideStream guides(
      frameCount,
      [&, beforeMask = counts(ReadingStage::kTargetMasks, frameCount)](int frame) {
        beforeMask();
        return readMask(inputs.target, targetChannel, frame);
      },
      guideOptions(options, *options.targetBlurSigmaPx, options.motionModel),
      flowReader(inputs.targetFlow, beforeTargetFlow),
      settingFor(size.targetMaskPixels, beforeTargetFlow));
  tell(observer, memoryNote(options, size));
  tellOfEmptyTarget(observer, options, guides);
  const bool withAges = comparesAges(options, guides, observer);
  Film film(options, inputs, window,
            start.state ? start.state->filmBegin : window.beginFor(start.span.begin), stopping);
  film.readPictures();
  createOutputFolders(options, outPaths);
  tell(observer, lock.take());
  film.readGuides(sourceGuides, withAges, observer);
  StopAtStages stops(stopping);
  Synthesizer synthesizer(film.exemplar(), options.synthesis, &stops);
  FrameWriter writer(std::move(form));
  RunJournal journal(run, wanted, start, pathOptions(options), options.continuation);
  replacement.begin();
  journal.discardOldStates();

  const bool dumps = options.dumpGuidesDirectory.has_value();
  const std::vector<int>& numbers = run.numbers;
  FrameStages stages;
  const GuideSource targetSource = targetGuides(guides, withAges);
  stages.guide = [&targetSource](int /*frame*/) { return targetSource.next(); };
  FramePainter painter(synthesizer, options.synthesis.temporalCoherence, start.span, frameCount,
                       dumps);
  std::deque<std::string> notes;  // on each frame that is not finished; empty where there is none
  stages.paint = [&](int j, GuideFrame frame) {
    film.advanceTo(window.beginFor(j));
    notes.push_back(
        flowNote("--target-path " + options.target.path, numbers[at(j)], frame.diffusion)
            .value_or(""));
    std::vector<PaintedFrame> painted = painter.paint(j, std::move(frame));
    if (recoloring) {
      for (PaintedFrame& f : painted) recolor(*recoloring, f.guides, f.picture);
    }
    return painted;
  };
  stages.write = [&](int j, const PaintedFrame& painted) {
    const Digest digest =
        writer.write(outPaths[at(j)], painted.picture, painted.guides,
                     [&](const Digest& written) { replacement.beforeWriting(j, written); });
    if (dumps) {
      const std::string folder = dumpFolder(options, "target");
      dumpGuides(folder, numbers[at(j)], painted.guides);
      dumpNearestNeighborField(folder, numbers[at(j)], *painted.nnf, inputs.color.files.numbers,
                               inputs.color.scaled);
    }
    journal.frameWritten(j, digest, painted.state);
  };

  FrameEvents events;
  events.begins = [&](int /*frame*/) { stopping.check(); };
  events.painted = [&](int j) {
    tell(observer, notes.front());
    notes.pop_front();
    countWritten(j + 1);
  };
  events.written = [&](int j, double seconds) {
    if (!observer.frameDone) return;
    observer.frameDone({j, start.span.end, numbers[at(j)], seconds, outPaths[at(j)],
                        options.reverse == Reverse::kOn});
  };
  if (observer.paintingBegins) observer.paintingBegins(start.span.begin, start.span.end);
  lock.setUnfinished(true);
  paintSavingState(journal, [&] {
    goOn(targetSource, start, stopping, synthesizer);
    runFrames(painter.painted(), stages, shares, events);
  });
  replacement.finish();
  lock.setUnfinished(false);
}

}  // namespace

void stylize(const Options& given, const Observer& observer) {
  validate(given);
  const Options options = inPaintingOrder(given, observer);
  if (options.continuation.existing != ExistingFrames::kKeep) {
    paintInOrder(options, observer);
    return;
  }
  for (const Options& run : runsForMissingFrames(options, observer)) paintInOrder(run, observer);
}

}  // namespace fluidymation
