#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fluidymation::bench {

/// What is timed, in the order of the report.
enum class Stage {
  kFrame,        ///< guides, painting, conversion and file, as the tool does for every frame
  kFirstFrame,   ///< the same for the first one, which starts from random matches
  kGuidesAhead,  ///< what GuideStream does before the first frame, by frame
  kGuides,       ///< GuideStream::next
  kPaint,        ///< Synthesizer::paint; the stages from here to kPaintedVote are its parts
  kShift,
  kPyramid,  ///< target's guides on all levels
  kTargetLevel,
  kDownscale,
  kPrevious,  ///< picture and modulation of the temporal term
  kUpscale,
  kMerge,
  kRepair,
  kSearch,  ///< findNearestNeighbors
  kVote,
  kPaintedVote,
  kRgba,  ///< CIELAB to the bytes of a file
  kPng,   ///< encoding, writing, flushing
};

/// All stages, in order, and their names.
[[nodiscard]] const std::vector<Stage>& allStages();
[[nodiscard]] const std::string& nameOf(Stage stage);

/// A stage on one level of the pyramid; kNoLevel where it has no levels, or for their sum.
inline constexpr int kNoLevel = -1;
struct StageOfLevel {
  Stage stage = Stage::kFrame;
  int level = kNoLevel;
  friend bool operator<(const StageOfLevel& a, const StageOfLevel& b) {
    return a.stage != b.stage ? a.stage < b.stage : a.level < b.level;
  }
};

/// What the search did.
struct SearchCounts {
  std::uint64_t distances = 0;  ///< patch distances begun
  std::uint64_t samples = 0;    ///< window samples they read before they stopped
};

/// What was spent on a stage.
struct Cost {
  double wallSeconds = 0.0;
  double cpuSeconds = 0.0;  ///< of all threads
  std::optional<SearchCounts> counts;

  Cost& operator+=(const Cost& other);
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
  /// Does the work, adds its cost, and hands on what it returns.
  template <typename Work>
  auto time(Stage stage, int level, const Work& work) {
    const Adder adder(*this, {stage, level});
    return work();
  }

  void add(StageOfLevel stage, const Cost& cost) { costs_[stage] += cost; }

  [[nodiscard]] const std::map<StageOfLevel, Cost>& costs() const { return costs_; }

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
