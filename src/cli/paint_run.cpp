#include "cli/paint_run.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "cli/progress.h"
#include "cli/progress_lines.h"
#include "cli/throttle.h"
#include "fluidymation/core/error.h"
#include "fluidymation/preview.h"

namespace fluidymation::cli {

void paintRun(const CommandLine& line, const RunPlace& place, const Streams& streams,
              const Engine& engine, const StopSignal& stopSignal) {
  const std::unique_ptr<ProgressLines> lines = progressLines(line.progress, streams.out, place);
  Progress::Style style =
      streams.errIsTerminal && !lines ? Progress::Style::kTerminal : Progress::Style::kPlain;
  if (line.quiet) style = Progress::Style::kQuiet;
  Progress progress(streams.err, style, place.label());
  requirePreviewFile(line.preview);
  const auto isCancelled = [&] { return stopSignal && stopSignal() != 0; };
  std::optional<Preview> preview;
  bool refreshes = false;
  const auto refresh = [&](const FrameReport& report) {
    try {
      preview->frameWritten(report);
    } catch (const Error& error) {  // the painting is worth more
      progress.note(std::string(error.what()) + "; the preview waits for the end");
      refreshes = false;
    } catch (const Interrupted&) {  // the painting stops by itself, and saves its state
      refreshes = false;
    }
  };
  // Programs get fewer lines, and none where reading is done soon
  using std::chrono_literals::operator""ms;
  Throttle<> readings(lines ? 5000ms : 200ms);
  const auto tellOfReading = [&](const ReadingReport& report) {
    if (!readings.isDue()) return;
    if (lines) {
      lines->reading(report);
    } else {
      progress.reading(report);
    }
  };
  const Observer observer{[&](const std::string& text) { progress.note(text); },
                          [&](const FrameReport& report) {
                            if (lines) {
                              lines->frameDone(report);
                            } else {
                              progress.frameDone(report);
                            }
                            if (refreshes) refresh(report);
                          },
                          isCancelled,
                          [&](int frame, int frameCount) {
                            if (lines) {
                              lines->paintingBegins(frame, frameCount);
                            } else {
                              progress.paintingBegins(frame, frameCount);
                            }
                          },
                          tellOfReading};
  try {
    for (const std::string& text : line.notes) progress.note(text);
    if (!line.preview.path.empty()) preview.emplace(line.options, line.preview, isCancelled);
    refreshes = preview.has_value();
    if (!place.isComposite) {
      if (lines) lines->readingBegins();
      progress.readingBegins();
    }
    engine(line.options, observer);
    progress.allDone();
    if (!preview && place.count == 1) progress.tellOfPreview();
    if (preview && preview->finish() > 0) progress.previewWritten(line.preview.path);
  } catch (const Error& failure) {
    progress.finishLine();
    if (lines) lines->failed(failure.what());
    throw;
  } catch (...) {
    progress.finishLine();
    throw;
  }
}

}  // namespace fluidymation::cli
