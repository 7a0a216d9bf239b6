#pragma once

#include <ostream>
#include <string>
#include <utility>

#include "cli/run_listener.h"
#include "fluidymation/pipeline.h"

namespace fluidymation::cli {

/// Tells the user what happens: on a terminal one line, shown from the beginning and rewritten for
/// every frame, with notes above it; else one plain line a frame.
class Progress : public RunListener {
 public:
  enum class Style { kTerminal, kPlain, kQuiet };

  /// @param label  every line begins with it; empty for a run that is alone.
  Progress(std::ostream& out, Style style, std::string label = "")
      : out_(out), style_(style), label_(std::move(label)) {}

  void readingBegins() override;
  void reading(const ReadingReport& report) override;
  void paintingBegins(int frame, int frameCount) override;
  void frameDone(const FrameReport& report) override;
  /// Ends the line: who catches the fault says what it is.
  void failed(const std::string& /*reason*/) override { finishLine(); }

  void note(const std::string& text);

  /// The last words: how many frames, how long, which files.
  void allDone();

  /// How to see the frames, after `allDone`, where there is no preview.
  void tellOfPreview();

  /// Where the preview is, after `allDone`.
  void previewWritten(const std::string& path);

  /// Ends the line being rewritten; call before anything else is printed there.
  void finishLine();

 private:
  void rewrite(const std::string& line);
  void show(const std::string& line);

  std::ostream& out_;
  Style style_;
  std::string label_;
  std::string line_;  ///< on the terminal now, not yet ended; empty where there is none
  int framesDone_ = 0;
  double totalSeconds_ = 0.0;
  std::string firstPath_;
  std::string lastPath_;
};

/// "masks of the animation: 120 of 400".
[[nodiscard]] std::string readingText(const ReadingReport& report);

/// "00:28", "1:02:03" from an hour on.
[[nodiscard]] std::string clockText(double seconds);

}  // namespace fluidymation::cli
