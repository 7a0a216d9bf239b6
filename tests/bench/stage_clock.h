#pragma once

#include <map>
#include <string>
#include <vector>

namespace fluidymation::bench {

/// What is timed, in the order of the report. From kGuides to kOther these are the parts of kFrame
/// and do not overlap.
enum class TimedStage {
  kFrame,        ///< guides, painting, conversion and file, as the tool does for every frame
  kFirstFrame,   ///< the same for the first one, which starts from random matches
  kReading,      ///< a mask: file, decoding, scaling
  kGuidesAhead,  ///< what GuideStream does before the first frame besides, by frame
  kGuides,       ///< GuideStream::next
  // The engine's own, see `Stage`
  kShift,
  kLevels,
  kPrevious,
  kUpscale,
  kMerge,
  kRepair,
  kSearch,
  kVote,
  kPaint,
  kPng,    ///< encoding
  kFile,   ///< the colours of a file, writing and flushing
  kOther,  ///< what is left of a frame
};

/// All stages, in order, and their names.
[[nodiscard]] const std::vector<TimedStage>& allStages();
[[nodiscard]] const std::string& nameOf(TimedStage stage);

/// A stage on one level of the pyramid; kNoLevel where it has no levels, or for their sum.
inline constexpr int kNoLevel = -1;
struct StageOfLevel {
  TimedStage stage = TimedStage::kFrame;
  int level = kNoLevel;
  friend bool operator<(const StageOfLevel& a, const StageOfLevel& b) {
    return a.stage != b.stage ? a.stage < b.stage : a.level < b.level;
  }
};

/// What was spent on a stage.
struct Cost {
  double wallSeconds = 0.0;
  double cpuSeconds = 0.0;  ///< of all threads
  double distances = 0.0;   ///< of a search: patch distances
  double samples = 0.0;     ///< of a search: pixels compared in them before they stopped

  Cost& operator+=(const Cost& other);
  Cost& operator-=(const Cost& other);
  /// The share of each of `parts` equal parts.
  [[nodiscard]] Cost dividedBy(int parts) const;
};

/// Measures from its construction on.
class Stopwatch {
 public:
  Stopwatch();
  [[nodiscard]] Cost elapsed() const;

 private:
  double wallStart_;
  double cpuStart_;
};

/// Sums up costs by stage and level.
class StageClock {
 public:
  /// Does the work, adds its cost to a stage that has no levels, and hands on what it returns.
  template <typename Work>
  auto time(TimedStage stage, const Work& work) {
    const Adder adder(*this, {stage, kNoLevel});
    return work();
  }

  void add(StageOfLevel stage, const Cost& cost) { costs_[stage] += cost; }

  [[nodiscard]] const std::map<StageOfLevel, Cost>& costs() const { return costs_; }

  /// Of all stages together.
  [[nodiscard]] Cost sum() const;

 private:
  /// Adds the time of its life.
  class Adder {
   public:
    Adder(StageClock& clock, StageOfLevel stage) : clock_(clock), stage_(stage) {}
    Adder(const Adder&) = delete;
    Adder& operator=(const Adder&) = delete;
    ~Adder() { clock_.add(stage_, stopwatch_.elapsed()); }

   private:
    StageClock& clock_;
    StageOfLevel stage_;
    Stopwatch stopwatch_;
  };

  std::map<StageOfLevel, Cost> costs_;
};

}  // namespace fluidymation::bench
