#include "cli/progress.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "cli/values.h"

namespace fluidymation::cli {
namespace {

[[nodiscard]] std::string twoDecimals(double value) {
  std::array<char, 64> buffer{};
  const double shown = std::clamp(value, 0.0, 1e9);
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), shown,
                                    std::chars_format::fixed, 2);
  return {buffer.data(), result.ptr};
}

[[nodiscard]] std::string twoDigits(long long value) {
  return (value < 10 ? "0" : "") + std::to_string(value);
}

}  // namespace

std::string clockText(double seconds) {
  constexpr double kLongest = 1e9;
  const long long whole = std::llround(std::clamp(seconds, 0.0, kLongest));
  const std::string minutesAndSeconds = twoDigits(whole / 60 % 60) + ":" + twoDigits(whole % 60);
  return whole < 3600 ? minutesAndSeconds : std::to_string(whole / 3600) + ":" + minutesAndSeconds;
}

std::string readingText(const ReadingReport& report) {
  const auto stage = [&report] {
    switch (report.stage) {
      case ReadingStage::kFilmMasks:
        return "masks of the exemplar";
      case ReadingStage::kFilmMovement:
        return "movement of the exemplar";
      case ReadingStage::kTargetMasks:
        return "masks of the animation";
      case ReadingStage::kTargetMovement:
        break;
    }
    return "movement of the animation";
  };
  return std::string(stage()) + ": " + std::to_string(report.done) + " of " +
         std::to_string(report.count);
}

void Progress::readingBegins() { rewrite("reading the masks and the exemplar ..."); }

void Progress::reading(const ReadingReport& report) {
  rewrite("reading the " + readingText(report) + " ...");
}

void Progress::paintingBegins(int frame, int frameCount) {
  const std::string count = std::to_string(frameCount);
  if (style_ == Style::kPlain) {
    out_ << label_ +
                (frame == 0 ? "painting " + count + (frameCount == 1 ? " frame" : " frames")
                            : "painting frames " + std::to_string(frame + 1) + " to " + count +
                                  " of " + count) +
                " ...\n"
         << std::flush;
  }
  rewrite("frame " + std::to_string(frame + 1) + " of " + count + " ...");
}

void Progress::note(const std::string& text) {
  if (style_ == Style::kQuiet) return;
  const std::string line = line_;
  if (!line.empty()) rewrite("");
  out_ << noteLine(label_ + text) << std::flush;
  if (!line.empty()) show(line);
}

void Progress::frameDone(const FrameReport& report) {
  if (style_ == Style::kQuiet) return;
  totalSeconds_ += report.seconds;
  const int done = report.index + 1;
  ++framesDone_;
  if (firstPath_.empty()) firstPath_ = report.path;
  lastPath_ = report.path;
  const std::string place =
      "frame " + std::to_string(done) + " of " + std::to_string(report.count) + "  ";
  if (style_ == Style::kPlain) {
    out_ << label_ + place + twoDecimals(report.seconds) + " s  " + oneLine(report.path) + "\n"
         << std::flush;
    return;
  }
  const double mean = totalSeconds_ / framesDone_;
  rewrite(place + twoDecimals(mean) + " s/frame  " + clockText(mean * (report.count - done)) +
          " left");
}

void Progress::allDone() {
  std::string words;
  if (framesDone_ == 1) words = "1 frame in " + clockText(totalSeconds_) + ": " + firstPath_;
  if (framesDone_ > 1) {
    words = std::to_string(framesDone_) + " frames in " + clockText(totalSeconds_) + ": " +
            firstPath_ + " to " + lastPath_;
  }
  if (!words.empty()) rewrite(words);
  finishLine();
  if (!words.empty() && style_ == Style::kPlain)
    out_ << label_ + oneLine(words) + "\n" << std::flush;
}

void Progress::tellOfPreview() {
  if (style_ == Style::kQuiet || framesDone_ == 0) return;
  out_ << "to look at them: fluidymation preview, the same options, and --preview FILE.apng\n"
       << std::flush;
}

void Progress::previewWritten(const std::string& path) {
  if (style_ == Style::kQuiet) return;
  out_ << "preview: " + oneLine(path) + "\n" << std::flush;
}

void Progress::finishLine() {
  if (!line_.empty()) out_ << "\n" << std::flush;
  line_.clear();
}

void Progress::rewrite(const std::string& line) {
  if (style_ != Style::kTerminal) return;
  line_ = line.empty() ? line : oneLine(label_ + line);
  show(line_);
}

void Progress::show(const std::string& line) {
  line_ = line;
  // Back to the first column; the escape sequence clears what a longer line left behind.
  out_ << "\r" + line_ + "\x1b[K" << std::flush;
}

}  // namespace fluidymation::cli
