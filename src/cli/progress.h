#pragma once

#include <ostream>
#include <string>

#include "fluidymation/pipeline.h"

namespace fluidymation::cli {

/// Tells the user what happens: on a terminal one line that is rewritten for every frame, else one
/// plain line a frame.
class Progress {
 public:
  enum class Style { kTerminal, kPlain, kQuiet };

  Progress(std::ostream& out, Style style) : out_(out), style_(style) {}

  void note(const std::string& text);
  void frameDone(const FrameReport& report);

  /// Ends the line being rewritten; call before anything else is printed there.
  void finishLine();

 private:
  std::ostream& out_;
  Style style_;
  double totalSeconds_ = 0.0;
  bool lineOpen_ = false;
};

/// "00:28", "1:02:03" from an hour on.
[[nodiscard]] std::string clockText(double seconds);

}  // namespace fluidymation::cli
