#include "bench/stage_clock.h"

#include <algorithm>
#include <ctime>
#include <utility>

namespace fluidymation::bench {
namespace {

const std::vector<std::pair<TimedStage, std::string>>& names() {
  static const std::vector<std::pair<TimedStage, std::string>> table = {
      {TimedStage::kFrame, "frame"},     {TimedStage::kFirstFrame, "first-frame"},
      {TimedStage::kReading, "reading"}, {TimedStage::kGuidesAhead, "guides-ahead"},
      {TimedStage::kGuides, "guides"},   {TimedStage::kShift, "shift"},
      {TimedStage::kLevels, "levels"},   {TimedStage::kPrevious, "previous"},
      {TimedStage::kUpscale, "upscale"}, {TimedStage::kMerge, "merge"},
      {TimedStage::kRepair, "repair"},   {TimedStage::kSearch, "search"},
      {TimedStage::kVote, "vote"},       {TimedStage::kPaint, "paint"},
      {TimedStage::kPng, "png"},         {TimedStage::kFile, "file"},
      {TimedStage::kOther, "other"},
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

const std::vector<TimedStage>& allStages() {
  static const std::vector<TimedStage> stages = [] {
    std::vector<TimedStage> all;
    for (const auto& [stage, name] : names()) all.push_back(stage);
    return all;
  }();
  return stages;
}

const std::string& nameOf(TimedStage stage) {
  return std::find_if(names().begin(), names().end(),
                      [&](const auto& entry) { return entry.first == stage; })
      ->second;
}

Cost& Cost::operator+=(const Cost& other) {
  wallSeconds += other.wallSeconds;
  cpuSeconds += other.cpuSeconds;
  distances += other.distances;
  samples += other.samples;
  return *this;
}

Cost& Cost::operator-=(const Cost& other) {
  wallSeconds -= other.wallSeconds;
  cpuSeconds -= other.cpuSeconds;
  distances -= other.distances;
  samples -= other.samples;
  return *this;
}

Cost Cost::dividedBy(int parts) const {
  return {wallSeconds / parts, cpuSeconds / parts, distances / parts, samples / parts};
}

Cost StageClock::sum() const {
  Cost sum;
  for (const auto& [stage, cost] : costs_) sum += cost;
  return sum;
}

Stopwatch::Stopwatch()
    : wallStart_(secondsOf(CLOCK_MONOTONIC)), cpuStart_(secondsOf(CLOCK_PROCESS_CPUTIME_ID)) {}

Cost Stopwatch::elapsed() const {
  return {secondsOf(CLOCK_MONOTONIC) - wallStart_, secondsOf(CLOCK_PROCESS_CPUTIME_ID) - cpuStart_,
          0.0, 0.0};
}

}  // namespace fluidymation::bench
