#include "bench/stage_clock.h"

#include <algorithm>
#include <ctime>
#include <utility>

namespace fluidymation::bench {
namespace {

const std::vector<std::pair<Stage, std::string>>& names() {
  static const std::vector<std::pair<Stage, std::string>> table = {
      {Stage::kFrame, "frame"},
      {Stage::kFirstFrame, "first-frame"},
      {Stage::kGuidesAhead, "guides-ahead"},
      {Stage::kGuides, "guides"},
      {Stage::kPaint, "paint"},
      {Stage::kShift, "shift"},
      {Stage::kPyramid, "pyramid"},
      {Stage::kTargetLevel, "target-level"},
      {Stage::kDownscale, "downscale"},
      {Stage::kPrevious, "previous"},
      {Stage::kUpscale, "upscale"},
      {Stage::kMerge, "merge"},
      {Stage::kRepair, "repair"},
      {Stage::kSearch, "search"},
      {Stage::kVote, "vote"},
      {Stage::kPaintedVote, "painted-vote"},
      {Stage::kRgba, "rgba"},
      {Stage::kPng, "png"},
  };
  return table;
}

double secondsOf(clockid_t clock) {
  constexpr double kSecondsPerNanosecond = 1e-9;
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * kSecondsPerNanosecond;
}

}  // namespace

const std::vector<Stage>& allStages() {
  static const std::vector<Stage> stages = [] {
    std::vector<Stage> all;
    for (const auto& [stage, name] : names()) all.push_back(stage);
    return all;
  }();
  return stages;
}

const std::string& nameOf(Stage stage) {
  return std::find_if(names().begin(), names().end(),
                      [&](const auto& entry) { return entry.first == stage; })
      ->second;
}

Cost& Cost::operator+=(const Cost& other) {
  wallSeconds += other.wallSeconds;
  cpuSeconds += other.cpuSeconds;
  if (other.counts) {
    if (!counts) counts.emplace();
    counts->distances += other.counts->distances;
    counts->samples += other.counts->samples;
  }
  return *this;
}

Cost Cost::dividedBy(int parts) const {
  Cost part{wallSeconds / parts, cpuSeconds / parts, counts};
  if (part.counts) {
    part.counts->distances /= static_cast<std::uint64_t>(parts);
    part.counts->samples /= static_cast<std::uint64_t>(parts);
  }
  return part;
}

Stopwatch::Stopwatch()
    : wallStart_(secondsOf(CLOCK_MONOTONIC)), cpuStart_(secondsOf(CLOCK_PROCESS_CPUTIME_ID)) {}

Cost Stopwatch::elapsed() const {
  return {secondsOf(CLOCK_MONOTONIC) - wallStart_, secondsOf(CLOCK_PROCESS_CPUTIME_ID) - cpuStart_,
          std::nullopt};
}

}  // namespace fluidymation::bench
