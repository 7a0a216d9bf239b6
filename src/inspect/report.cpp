#include "inspect/report.h"

#include <algorithm>

#include "fluidymation/core/text.h"
#include "fluidymation/option_ranges.h"
#include "inspect/numbers.h"
#include "pipeline/memory.h"

namespace fluidymation {
namespace {

/// "400x222", "800x444 scaled to 400x222".
[[nodiscard]] std::string sizeOf(const InputSequence& input) {
  if (input.stored == input.scaled) return sizeText(input.stored);
  return sizeText(input.stored) + " scaled to " + sizeText(input.scaled);
}

void addSequence(const std::string& name, const InputSequence& input,
                 const SequenceFigures& sequence, std::vector<std::string>& lines) {
  const std::vector<int>& numbers = input.files.numbers;
  const int count = input.files.count();
  lines.push_back(name + ": " + sizeOf(input) + ", " + std::to_string(count) +
                  (count == 1 ? " frame (" : " frames (") + std::to_string(numbers.front()) +
                  (count == 1 ? "" : " to " + std::to_string(numbers.back())) + "), masks " +
                  (sequence.soft ? "anti-aliased" : "black and white"));
  std::vector<double> areas;
  std::vector<double> shares;
  double depth = 0.0;
  int empty = 0;
  for (const ShapeFigures& frame : sequence.frames) {
    areas.push_back(static_cast<double>(frame.insidePx));
    shares.push_back(areas.back() / static_cast<double>(frame.framePx));
    depth = std::max(depth, double{frame.depthPx});
    empty += frame.empty() ? 1 : 0;
  }
  const Spread area = spreadOf(areas);
  const Spread share = spreadOf(shares);
  lines.push_back("  smoothed masks: least " + fixedText(area.least, 0) + " px (" +
                  percentText(share.least) + " of the picture), mean " + fixedText(area.mean, 0) +
                  " px (" + percentText(share.mean) + "), largest " + fixedText(area.largest, 0) +
                  " px (" + percentText(share.largest) + "); " +
                  (empty == 0 ? "none" : std::to_string(empty)) + " empty");
  lines.push_back("  edges move by " + fixedText(typicalBorderSpeed(sequence), 1) +
                  " px a frame (median); deepest " + fixedText(depth, 1) + " px from the edge");
}

/// "50 s", "12 min", "3.5 h".
[[nodiscard]] std::string durationText(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  constexpr double kLongestInSeconds = 120.0;
  constexpr double kLongestInMinutes = 7200.0;
  if (seconds < 10.0) return fixedText(seconds, 1) + " s";
  if (seconds < kLongestInSeconds) return fixedText(seconds, 0) + " s";
  if (seconds < kLongestInMinutes) return fixedText(seconds / kMinute, 0) + " min";
  return fixedText(seconds / kHour, 1) + " h";
}

}  // namespace

std::vector<std::string> reportLines(const Inputs& inputs, const KnownRun& run,
                                     const ReportFacts& facts) {
  std::vector<std::string> lines = {"files: all " + std::to_string(facts.filesRead) +
                                    " can be read"};
  addSequence("exemplar", inputs.color, run.exemplar, lines);
  lines.push_back("  its colours settle " + fixedText(double{run.rimWidthPx}, 0) +
                  " px from the edge (--border-width auto); the border is " +
                  numberText(run.borderWidthPx) + " px wide");
  addSequence("animation", inputs.target, run.target, lines);
  if (facts.drawsLines) lines.emplace_back("  lines being drawn: see --new-material");
  if (!facts.chosenWidths.empty()) lines.push_back(facts.chosenWidths);
  lines.push_back("memory: at most " + memoryText(facts.mostBytes) + " (the limit is " +
                  memoryText(facts.limitBytes) + ")");
  lines.push_back("time: " + durationText(facts.time.leastSeconds) + " to " +
                  durationText(facts.time.mostSeconds) + " with " + std::to_string(facts.threads) +
                  (facts.threads == 1 ? " thread" : " threads") + ": " +
                  fixedText(static_cast<double>(run.target.insidePx()) / 1e6, 1) +
                  " million mask pixels at " + fixedText(kLeastMicroseconds, 1) + " to " +
                  fixedText(kMostMicroseconds, 1) +
                  " microseconds each, from a quiet to a busy machine");
  const std::vector<std::string> expected = expectations(run);
  if (expected.empty()) lines.emplace_back("look: nothing stands out that would look bad");
  for (const std::string& line : expected) lines.push_back("look: " + line);
  return lines;
}

}  // namespace fluidymation
