#include "fluidymation/pipeline.h"

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/core/color.h"
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
#include "pipeline/guide_dump.h"
#include "pipeline/inputs.h"
#include "pipeline/medium_colors.h"
#include "pipeline/memory_limit.h"
#include "pipeline/nnf_dump.h"
#include "pipeline/option_texts.h"
#include "pipeline/outputs.h"
#include "pipeline/painting_order.h"
#include "pipeline/run_guides.h"
#include "pipeline/run_journal.h"
#include "pipeline/run_lock.h"
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

/// A run once its inputs have been looked at.
struct PreparedRun {
  Options options;  ///< with a value for every width
  Inputs inputs;
  MaskChannels channels;
  std::optional<Recoloring> recoloring;
  RunIdentity identity;
  FrameSpan wanted;

  [[nodiscard]] bool dumps() const { return options.dumpGuidesDirectory.has_value(); }
};

/// Reads all that the run depends on and is not read for guides; changes nothing on the disk.
/// @param given  leaves widths open.
PreparedRun preparedRun(const Options& given, Inputs inputs, const Observer& observer,
                        const std::function<void()>& stopIfWanted) {
  Options options = given;
  const std::vector<std::string> outPaths = checkOutput(options, inputs);
  const MaskChannels channels{maskChannel(inputs.sourceMask, stopIfWanted),
                              maskChannel(inputs.target, stopIfWanted)};
  fillAutomaticWidths(inputs, channels.source, channels.target, stopIfWanted, options);
  tell(observer, chosenWidths(given, options));
  const std::optional<Recoloring> recoloring =
      recoloringFor(options, inputs, channels.source, stopIfWanted);
  RunIdentity identity = identityOf(options, inputs, outPaths, stopIfWanted);
  const FrameSpan wanted = wantedFrames(options, identity.numbers);
  return {std::move(options), std::move(inputs), channels, recoloring, std::move(identity), wanted};
}

/// All frames before frame `j` are written.
void countWritten(const PreparedRun& run, int j, Stopping& stopping) {
  stopping.setWritten(j - run.wanted.begin, run.wanted.end - run.wanted.begin);
}

/// Brings guides and search to where painting begins.
void goOn(const GuideSource& guides, StartingPoint& start, const Stopping& stopping,
          Synthesizer& synthesizer) {
  const GuidePart last = passOver(start.span.begin, start.state.has_value(), guides,
                                  [&stopping] { stopping.check(); });
  if (start.state) {
    synthesizer.restore(std::move(*start.state), last);
  } else {
    synthesizer.startAfresh(start.span.begin);
  }
}

/// Notes on each frame that is not finished; empty where there is none.
using WaitingNotes = std::deque<std::string>;

/// The stage that paints, see `FrameStages`. What it is given must outlive it.
auto paintStage(const PreparedRun& run, const FilmWindow& window, Film& film, FramePainter& painter,
                WaitingNotes& notes) {
  return [&](int j, GuidePart frame) {
    film.advanceTo(window.beginFor(j));
    notes.push_back(flowNote("--target-path " + run.options.target.path,
                             run.identity.numbers[at(j)], frame.guides.diffusion)
                        .value_or(""));
    std::vector<PaintedFrame> painted = painter.paint(j, std::move(frame));
    if (run.recoloring) {
      for (PaintedFrame& f : painted) recolor(*run.recoloring, f.guides, f.picture);
    }
    return painted;
  };
}

/// The stage that writes, likewise.
auto writeStage(const PreparedRun& run, const FrameReplacement& replacement, FrameWriter& writer,
                RunJournal& journal) {
  return [&](int j, const PaintedFrame& painted) {
    const int number = run.identity.numbers[at(j)];
    const Digest digest =
        writer.write(run.identity.framePaths[at(j)], painted.part, painted.picture, painted.guides,
                     [&](const Digest& written) { replacement.beforeWriting(j, written); });
    if (run.dumps()) {
      const std::string folder = dumpFolder(run.options, "target");
      dumpGuides(folder, number, painted.guides);
      dumpNearestNeighborField(folder, number, *painted.nnf, run.inputs.color.files.numbers,
                               run.inputs.color.scaled);
    }
    journal.frameWritten(j, digest, painted.state);
  };
}

/// What the caller of the run hears of its frames. What it is given must outlive it.
/// @param end  of the frames that are painted.
FrameEvents eventsFor(const Observer& observer, const PreparedRun& run, int end, Stopping& stopping,
                      WaitingNotes& notes) {
  FrameEvents events;
  events.begins = [&](int /*frame*/) { stopping.check(); };
  events.painted = [&](int j) {
    tell(observer, notes.front());
    notes.pop_front();
    countWritten(run, j + 1, stopping);
  };
  events.written = [&, end](int j, double seconds) {
    if (!observer.frameDone) return;
    observer.frameDone({j, end, run.identity.numbers[at(j)], seconds,
                        run.identity.framePaths[at(j)], run.options.reverse == Reverse::kOn});
  };
  return events;
}

/// Makes the guides and paints the frames from `start` on; writes nothing before all masks, flows
/// and colours are read.
void paintFrom(StartingPoint& start, const PreparedRun& run, const FrameReplacement& replacement,
               RunLock& lock, Stopping& stopping, const Observer& observer) {
  const Options& options = run.options;
  const int frameCount = run.identity.frameCount();
  FrameWriter writer(formOf(options, run.inputs, observer, [&] { stopping.check(); }));
  const FilmWindow window(options, run.inputs.color.files.count(), frameCount);
  RunGuides guides(options, run.inputs, run.channels, window, run.identity.files.folder(), stopping,
                   observer);
  tell(observer, memoryNote(options, guides.size()));
  tellOfEmptyTarget(observer, options, guides.target());
  const bool withAges = comparesAges(options, guides.target(), observer);
  Film film(options, run.inputs, window,
            start.state ? start.state->filmBegin : window.beginFor(start.span.begin), stopping);
  film.readPictures();
  createOutputFolders(options, run.identity.framePaths);
  tell(observer, lock.take());
  film.readGuides(guides.film(), withAges, observer);
  StopAtStages stops(stopping);
  Synthesizer synthesizer(film.exemplar(), options.synthesis, &stops);
  RunJournal journal(run.identity, run.wanted, start, pathOptions(options), options.continuation);
  replacement.begin();
  journal.discardOldStates();

  FramePainter painter(synthesizer, options.synthesis.temporalCoherence, start.span, frameCount,
                       run.dumps());
  const std::optional<int> marginPx =
      run.dumps() ? std::nullopt : std::optional(synthesizer.marginPx());
  const GuideSource source = targetGuides(guides.target(), marginPx, withAges);
  WaitingNotes notes;
  FrameStages stages;
  stages.guide = [&source](int /*frame*/) { return source.next(); };
  stages.paint = paintStage(run, window, film, painter, notes);
  stages.write = writeStage(run, replacement, writer, journal);
  if (observer.paintingBegins) observer.paintingBegins(start.span.begin, start.span.end);
  lock.setUnfinished(true);
  paintSavingState(journal, [&] {
    goOn(source, start, stopping, synthesizer);
    runFrames(painter.painted(), stages, shareThreads(options.threads),
              eventsFor(observer, run, start.span.end, stopping, notes));
  });
}

/// Paints the frames of the target in the order that the options give. All files are read before
/// anything is written, and only masks, flows and colours are kept: a damaged one must leave
/// neither half a dump nor an empty folder.
void paintInOrder(const Options& given, const Observer& observer) {
  const ThreadCount threads(given.threads, shareThreads(given.threads).beside());
  Inputs inputs = openInputs(given, observer);
  Stopping stopping(observer, inputs.target.files.count());
  const auto stopIfWanted = [&stopping] { stopping.check(); };
  const PreparedRun run = preparedRun(given, std::move(inputs), observer, stopIfWanted);
  const ContinuationOptions& continuation = run.options.continuation;
  RunLock lock(run.identity.files);
  lock.takeIfUsed();
  StartingPoint start = findStart(continuation, run.wanted, run.identity, stopIfWanted);
  tell(observer, start.note);
  const FrameReplacement replacement(
      run.identity, start.span, requireOwnFrames(continuation, run.identity, start, stopIfWanted),
      continuation.waysOut);
  if (start.span.begin != start.span.end) {
    countWritten(run, start.span.begin, stopping);
    paintFrom(start, run, replacement, lock, stopping, observer);
    replacement.finish();
    lock.setUnfinished(false);
  } else {
    replacement.finish();
  }
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
