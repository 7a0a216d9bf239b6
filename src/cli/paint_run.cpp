#include "cli/paint_run.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/progress.h"
#include "cli/progress_lines.h"
#include "cli/run_listener.h"
#include "cli/throttle.h"
#include "fluidymation/core/error.h"
#include "fluidymation/preview.h"

namespace fluidymation::cli {
namespace {

/// Least time between two words on what is read. Programs get fewer, and none where reading is done
/// soon; humans see the number move.
constexpr std::chrono::milliseconds kPauseForPrograms{5000};
constexpr std::chrono::milliseconds kPauseForHumans{200};

[[nodiscard]] Progress::Style styleOf(const CommandLine& line, bool isTerminal) {
  if (line.quiet) return Progress::Style::kQuiet;
  return isTerminal ? Progress::Style::kTerminal : Progress::Style::kPlain;
}

/// The preview of a run, where one is wanted.
class RunPreview {
 public:
  /// @throws what `Preview` throws.
  RunPreview(const CommandLine& line, const std::function<bool()>& isCancelled, Progress& progress)
      : path_(line.preview.path), progress_(progress) {
    if (!path_.empty()) preview_.emplace(line.options, line.preview, isCancelled);
    refreshes_ = isWanted();
  }

  [[nodiscard]] bool isWanted() const { return preview_.has_value(); }

  /// Shows what is painted so far, until that fails.
  void frameDone(const FrameReport& report) {
    if (!refreshes_) return;
    try {
      preview_->frameWritten(report);
    } catch (const Error& error) {  // the painting is worth more
      progress_.note(std::string(error.what()) + "; the preview waits for the end");
      refreshes_ = false;
    } catch (const Interrupted&) {  // the painting stops by itself, and saves its state
      refreshes_ = false;
    }
  }

  /// Shows all frames. @throws Error, Interrupted.
  void allDone() {
    if (isWanted() && preview_->finish() > 0) progress_.previewWritten(path_);
  }

 private:
  std::string path_;
  Progress& progress_;
  std::optional<Preview> preview_;
  bool refreshes_ = false;
};

/// @param pause  between two words on what is read.
[[nodiscard]] Observer observerOf(RunListener& listener, Progress& progress, RunPreview& preview,
                                  std::chrono::milliseconds pause) {
  Observer observer;
  observer.note = [&progress](const std::string& text) { progress.note(text); };
  observer.frameDone = [&listener, &preview](const FrameReport& report) {
    listener.frameDone(report);
    preview.frameDone(report);
  };
  observer.paintingBegins = [&listener](int frame, int frameCount) {
    listener.paintingBegins(frame, frameCount);
  };
  observer.reading = [&listener, due = Throttle<>(pause)](const ReadingReport& report) mutable {
    if (due.isDue()) listener.reading(report);
  };
  return observer;
}

}  // namespace

void paintRun(const CommandLine& line, const RunPlace& place, const Streams& streams,
              const Engine& engine, const StopSignal& stopSignal) {
  const std::unique_ptr<RunListener> lines = progressLines(line.progress, streams.out, place);
  Progress progress(streams.err, styleOf(line, streams.errIsTerminal && !lines), place.label());
  RunListener& listener = lines ? *lines : progress;
  requirePreviewFile(line.preview);
  const auto isCancelled = [&] { return stopSignal && stopSignal() != 0; };
  try {
    for (const std::string& text : line.notes) progress.note(text);
    RunPreview preview(line, isCancelled, progress);
    Observer observer =
        observerOf(listener, progress, preview, lines ? kPauseForPrograms : kPauseForHumans);
    observer.cancelled = isCancelled;
    if (!place.isComposite) listener.readingBegins();
    engine(line.options, observer);
    progress.allDone();
    if (!preview.isWanted() && place.count == 1) progress.tellOfPreview();
    preview.allDone();
  } catch (const Error& failure) {
    progress.finishLine();
    listener.failed(failure.what());
    throw;
  } catch (...) {
    progress.finishLine();
    throw;
  }
}

}  // namespace fluidymation::cli
