#include "cli/option_table.h"

#include <array>
#include <optional>
#include <utility>

#include "cli/values.h"
#include "fluidymation/automatic.h"
#include "fluidymation/core/error.h"
#include "fluidymation/option_ranges.h"
#include "fluidymation/presets.h"

namespace fluidymation::cli {
namespace {

// Groups of the help text.
constexpr const char* kFiles = "Inputs and outputs";
constexpr const char* kLook = "Look";
constexpr const char* kSequences = "Sequences";
constexpr const char* kMasks = "Masks and motion";
constexpr const char* kGuides = "Guides";
constexpr const char* kSynthesis = "Synthesis";
constexpr const char* kGoingOn = "Stopping and going on";

/// Finds a field in a CommandLine, to read its default and to set it.
template <typename T>
using Field = T& (*)(CommandLine&);

template <typename T>
[[nodiscard]] T defaultOf(Field<T> field) {
  CommandLine defaults;
  return field(defaults);
}

[[nodiscard]] std::string facts(const std::string& defaultText, const std::string& unit,
                                const std::string& range, const std::string& section) {
  return "\n(default " + defaultText + (unit.empty() ? "" : " " + unit) +
         (range.empty() ? "" : "; in " + range) + "; " + section + ")";
}

/// The words that an option takes, and what each stands for.
template <typename T>
using Words = std::vector<std::pair<std::string, T>>;

template <typename T>
[[nodiscard]] std::string wordFor(const Words<T>& words, T wanted) {
  for (const auto& [word, value] : words) {
    if (value == wanted) return word;
  }
  return {};
}

template <typename T>
[[nodiscard]] T parseWord(const std::string& option, const std::string& text,
                          const Words<T>& words) {
  std::string wanted;
  for (const auto& [word, value] : words) {
    if (text == word) return value;
    wanted += (wanted.empty() ? "" : " or ") + word;
  }
  throw UsageError(shown(option, text) + ": wanted " + wanted);
}

/// The table, built by one function a kind of value.
class Table {
 public:
  using PatternCheck = void (*)(const std::string& option, const std::string& pattern);

  void pattern(const char* name, const char* what, const char* section, Field<std::string> field,
               PatternCheck check = checkPattern) {
    const std::string option = name;
    specs_.push_back({option, kFiles, "PATTERN",
                      std::string(what) + "\n(required; " + section + ")", true,
                      [option, field, check](CommandLine& line, const std::string& value) {
                        check(option, value);
                        field(line) = value;
                      }});
  }

  void optionalPattern(const char* name, const char* what, const char* section,
                       Field<std::optional<std::string>> field) {
    const std::string option = name;
    specs_.push_back({option, kFiles, "PATTERN", what + facts("off", "", "", section), false,
                      [option, field](CommandLine& line, const std::string& value) {
                        if (value.empty()) {
                          throw UsageError(shown(option, value) + ": wanted a path with a number");
                        }
                        checkPattern(option, value);
                        field(line) = value;
                      }});
  }

  void integer(const char* name, const char* group, const char* what, const char* unit,
               const Range& range, const char* section, Field<int> field, bool zeroAllowed = true) {
    const std::string option = name;
    specs_.push_back(
        {option, group, "N",
         what + facts(std::to_string(defaultOf(field)), unit,
                      range.text() + (zeroAllowed ? "" : ", not 0"), section),
         false, [option, range, zeroAllowed, field](CommandLine& line, const std::string& value) {
           field(line) = parseInt(option, value, range, zeroAllowed);
         }});
  }

  void real(const char* name, const char* group, const char* what, const char* unit,
            const Range& range, const char* section, Field<float> field) {
    const std::string option = name;
    specs_.push_back({option, group, "X",
                      what + facts(numberText(defaultOf(field)), unit, range.text(), section),
                      false, [option, range, field](CommandLine& line, const std::string& value) {
                        field(line) = parseFloat(option, value, range);
                      }});
  }

  void real(const char* name, const char* group, const char* what, const char* unit,
            const Range& range, const char* section, Field<double> field) {
    const std::string option = name;
    specs_.push_back({option, group, "X",
                      what + facts(numberText(defaultOf(field)), unit, range.text(), section),
                      false, [option, range, field](CommandLine& line, const std::string& value) {
                        field(line) = parseDouble(option, value, range);
                      }});
  }

  void integers(const char* name, const char* group, const char* what, const Range& range,
                const char* section, Field<std::vector<int>> field) {
    const std::string option = name;
    specs_.push_back(
        {option, group, "N,N,...",
         what + facts(listText(defaultOf(field)), "",
                      range.text() + ", 1 to " + std::to_string(ranges::kLongestList) + " numbers",
                      section),
         false, [option, range, field](CommandLine& line, const std::string& value) {
           field(line) = parseIntList(option, value, range);
         }});
  }

  /// A number in px of a field that is found from the inputs where it is not given.
  void automatic(const char* name, const char* group, const char* what,
                 const std::string& automaticValue, const Range& range, const char* section,
                 Field<std::optional<float>> field) {
    const std::string option = name;
    specs_.push_back({option, group, "X",
                      std::string(what) + "\n(default " + automaticValue + ";\nin " + range.text() +
                          " px; " + section + ")",
                      false, [option, range, field](CommandLine& line, const std::string& value) {
                        field(line) = parseFloat(option, value, range);
                      }});
  }

  /// One of a few words.
  template <typename T>
  void word(const char* name, const char* group, const char* what, const Words<T>& words,
            const char* section, Field<T> field) {
    const std::string option = name;
    specs_.push_back({option, group, "NAME",
                      what + facts(wordFor(words, defaultOf(field)), "", "", section), false,
                      [option, words, field](CommandLine& line, const std::string& value) {
                        field(line) = parseWord(option, value, words);
                      }});
  }

  void add(Spec spec) { specs_.push_back(std::move(spec)); }

  [[nodiscard]] std::vector<Spec> take() { return std::move(specs_); }

 private:
  std::vector<Spec> specs_;
};

void addFiles(Table& table) {
  table.pattern("--src-path", "exemplar frames, PNG, e.g. leaf/rgb/%05d.png", "thesis §3.1",
                [](CommandLine& c) -> std::string& { return c.options.source.path; });
  table.pattern("--src-mask-path", "masks of the exemplar, numbered as --src-path", "thesis §3.1",
                [](CommandLine& c) -> std::string& { return c.options.sourceMaskPath; });
  table.pattern("--target-path", "masks of the animation to paint", "thesis §3.1",
                [](CommandLine& c) -> std::string& { return c.options.target.path; });
  table.pattern(
      "--out-path", "painted frames to write, PNG, numbered as --target-path", "thesis §3.1",
      [](CommandLine& c) -> std::string& { return c.options.outPath; }, checkOutputPattern);
  table.optionalPattern("--src-flow-path",
                        "the exemplar's motion, .flo or KITTI PNG, not derived from\n"
                        "masks; unknown vectors count as 0: fill holes before",
                        "paper §3", [](CommandLine& c) -> std::optional<std::string>& {
                          return c.options.sourceFlowPath;
                        });
  table.optionalPattern(
      "--target-flow-path", "the same for the animation", "paper §3",
      [](CommandLine& c) -> std::optional<std::string>& { return c.options.targetFlowPath; });
  table.word<FlowConvention>(
      "--flow-convention", kFiles,
      "file n is seen on frame n; backward: how it came from n-1;\n"
      "forward: how it goes on to n+1",
      {{"backward", FlowConvention::kBackward}, {"forward", FlowConvention::kForward}},
      "not in the thesis",
      [](CommandLine& c) -> FlowConvention& { return c.options.flowConvention; });
  table.integer("--compression-level", kFiles,
                "of the painted frames; 0 is fastest, 9 smallest: all have the\nsame pixels", "",
                ranges::kCompressionLevels, "not in the thesis",
                [](CommandLine& c) -> int& { return c.options.compressionLevel; });
  table.add({"--dump-guides", kFiles, "DIR",
             "write masks, guides and matches to DIR/source, DIR/target\n(default off; not in the "
             "thesis)",
             false, [](CommandLine& line, const std::string& value) {
               if (value.empty()) {
                 throw UsageError(shown("--dump-guides", value) + ": wanted a folder's name");
               }
               line.options.dumpGuidesDirectory = value;
             }});
}

/// Applied before the options that it sets: those given besides replace what it says.
void addLook(Table& table) {
  table.add(
      {"--preset", kLook, "NAME",
       "standard: the best we know; thesis, paper: their numbers\nand rules, whatever the "
       "defaults; what else is given prevails\n(default standard; thesis §4.5, paper table 1)",
       false, [](CommandLine& line, const std::string& value) {
         if (value == "thesis") {
           applyThesisPreset(line.options);
         } else if (value == "paper") {
           applyPaperPreset(line.options);
         } else if (value != "standard") {
           throw UsageError(shown("--preset", value) + ": wanted standard, thesis or paper");
         }
       }});
}

void addSequences(Table& table) {
  table.integer("--src-start", kSequences, "number of the exemplar's first frame", "",
                ranges::kFrameNumbers, "thesis §4.5",
                [](CommandLine& c) -> int& { return c.options.source.start; });
  table.integer("--src-frames", kSequences, "frames of the exemplar, at most", "frames",
                ranges::kFrameCounts, "thesis §4.5",
                [](CommandLine& c) -> int& { return c.options.source.frames; });
  table.integer(
      "--src-speed", kSequences, "from number to number; negative plays backwards", "",
      ranges::kSpeeds, "thesis §4.5", [](CommandLine& c) -> int& { return c.options.source.speed; },
      false);
  table.real("--src-scale", kSequences, "scaling of the exemplar and its masks", "",
             ranges::kScales, "thesis §4.5",
             [](CommandLine& c) -> double& { return c.options.source.scale; });
  table.integer("--target-start", kSequences, "number of the animation's first frame", "",
                ranges::kFrameNumbers, "thesis §4.5",
                [](CommandLine& c) -> int& { return c.options.target.start; });
  table.integer("--target-frames", kSequences, "frames to paint, at most", "frames",
                ranges::kFrameCounts, "thesis §4.5",
                [](CommandLine& c) -> int& { return c.options.target.frames; });
  table.integer(
      "--target-speed", kSequences, "from number to number; negative plays backwards", "",
      ranges::kSpeeds, "thesis §4.5", [](CommandLine& c) -> int& { return c.options.target.speed; },
      false);
  table.real("--target-scale", kSequences, "scaling of the animation", "", ranges::kScales,
             "thesis §4.5", [](CommandLine& c) -> double& { return c.options.target.scale; });
}

void addMasksAndMotion(Table& table) {
  table.automatic("--blur-sigma", kMasks, "smoothing of the masks; 0 is off, thin parts vanish",
                  numberText(kBlurSigmaShare) + " times the square root of their mean area",
                  ranges::kSigmasPx, "thesis §4.1: 8",
                  [](CommandLine& c) -> std::optional<float>& { return c.options.blurSigmaPx; });
  table.automatic(
      "--target-blur-sigma", kMasks, "the same for the animation alone, to keep its thin parts",
      "that of --blur-sigma if given, else by its own masks", ranges::kSigmasPx, "thesis §4.1",
      [](CommandLine& c) -> std::optional<float>& { return c.options.targetBlurSigmaPx; });
  table.real("--mask-threshold", kMasks, "inside is what the smoothed mask has from here up", "",
             ranges::kThresholds, "thesis §4.1",
             [](CommandLine& c) -> float& { return c.options.maskThreshold; });
  table.real("--time-blur-sigma", kMasks,
             "smoothing of the edges' movement in time; not of given flow", "frames",
             ranges::kTimeSigmasFrames, "thesis §4.1",
             [](CommandLine& c) -> float& { return c.options.timeBlurSigmaFrames; });
  table.real("--flow-blur-sigma", kMasks,
             "smoothing of the movement itself in time; not of given flow", "frames",
             ranges::kTimeSigmasFrames, "paper App. A: 1.5",
             [](CommandLine& c) -> float& { return c.options.flowBlurSigmaFrames; });
  table.word<MotionModel>("--motion-model", kMasks,
                          "rigid: the animation's parts travel, turn and grow as wholes;\n"
                          "normals: what their edges do fades inwards",
                          {{"normals", MotionModel::kNormals}, {"rigid", MotionModel::kRigidParts}},
                          "thesis §3.8: normals",
                          [](CommandLine& c) -> MotionModel& { return c.options.motionModel; });
}

void addGuides(Table& table) {
  table.real("--dist-weight", kGuides, "weight of the edge or shape guide", "", ranges::kWeights,
             "thesis §3.4",
             [](CommandLine& c) -> float& { return c.options.synthesis.distWeight; });
  table.real("--flow-weight", kGuides, "weight of the motion extent guides", "", ranges::kWeights,
             "thesis §3.5",
             [](CommandLine& c) -> float& { return c.options.synthesis.flowWeight; });
  table.real("--dir-weight", kGuides, "weight of the directions of motion within a window", "",
             ranges::kWeights, "thesis §3.6, paper §3.2: 1",
             [](CommandLine& c) -> float& { return c.options.synthesis.dirWeight; });
  table.real("--prev-weight", kGuides, "weight of the previous frame", "", ranges::kWeights,
             "thesis §3.7",
             [](CommandLine& c) -> float& { return c.options.synthesis.prevWeight; });
  table.automatic("--border-width", kGuides, "width of the border segment",
                  numberText(kBorderWidthShare) + " times the square root of the film frames' area",
                  ranges::kWidthsPx, "thesis §3.4: 10",
                  [](CommandLine& c) -> std::optional<float>& { return c.options.borderWidthPx; });
  table.word<ShapeGuide>(
      "--shape-guide", kGuides, "distance: to the edge; blurred: the mask, by the border width",
      {{"distance", ShapeGuide::kEdgeDistance}, {"blurred", ShapeGuide::kBlurredMask}},
      "paper §3.1: blurred",
      [](CommandLine& c) -> ShapeGuide& { return c.options.synthesis.shape.guide; });
  table.word<bool>("--segments", kGuides,
                   "hard: border and interior are matched apart; none: freely",
                   {{"hard", true}, {"none", false}}, "thesis §3.4: hard",
                   [](CommandLine& c) -> bool& { return c.options.synthesis.shape.hardSegments; });
  table.word<ThinParts>("--thin-parts", kGuides,
                        "of the animation, thinner than the film's rim; body: they\n"
                        "get its inner colour; fringe: its rim only",
                        {{"fringe", ThinParts::kFringe}, {"body", ThinParts::kBody}},
                        "thesis §3.4: fringe",
                        [](CommandLine& c) -> ThinParts& { return c.options.synthesis.thinParts; });
  table.word<ExtentUnit>(
      "--extent-unit", kGuides,
      "film: motion extents relative to the film's, and bounded;\npx: as they are",
      {{"px", ExtentUnit::kPixels}, {"film", ExtentUnit::kExemplar}}, "thesis §3.5: px",
      [](CommandLine& c) -> ExtentUnit& { return c.options.synthesis.extentUnit; });
  table.word<NewMaterial>("--new-material", kGuides,
                          "fresh: as in the film's first frames, older behind a brush;\n"
                          "plain: by its motion; auto: fresh for lines being drawn",
                          {{"auto", NewMaterial::kAutomatic},
                           {"fresh", NewMaterial::kFresh},
                           {"plain", NewMaterial::kPlain}},
                          "thesis §5: plain",
                          [](CommandLine& c) -> NewMaterial& { return c.options.newMaterial; });
  const ModulationBounds bounds;
  table.add(
      {"--prev-modulation-bounds", kGuides, "M_U,M_L",
       "the previous frame counts fully up to m_l, not from m_u on\n(default " +
           numberText(bounds.upper) + " and " + numberText(bounds.lower) +
           " times the border width;\nin " + ranges::kModulationBoundsPx.text() +
           " px, m_u > m_l; thesis §3.7: 10,2)",
       false, [](CommandLine& line, const std::string& value) {
         const FloatPair pair =
             parseDescendingPair("--prev-modulation-bounds", value, ranges::kModulationBoundsPx);
         line.options.synthesis.prevModulation = {pair.first, pair.second, ModulationUnit::kPixels};
       }});
}

void addSynthesis(Table& table) {
  table.real("--tex-weight", kSynthesis, "weight of the texture: colours alike in whole windows",
             "", ranges::kWeights, "thesis §3.7: 1",
             [](CommandLine& c) -> float& { return c.options.synthesis.texWeight; });
  table.word<TemporalCoherence>(
      "--temporal-coherence", kSynthesis,
      "forward: with the frame before; bidirectional: with the one\n"
      "after, too, calmer where shapes shrink, in twice the time",
      {{"forward", TemporalCoherence::kForward},
       {"bidirectional", TemporalCoherence::kBidirectional}},
      "thesis §3.7: forward; paper §5",
      [](CommandLine& c) -> TemporalCoherence& { return c.options.synthesis.temporalCoherence; });
  table.word<bool>("--carry-motion", kSynthesis,
                   "on: movement too small for a step of the film is kept for\n"
                   "later; off: slow animations freeze",
                   {{"off", false}, {"on", true}}, "thesis §3.7: off",
                   [](CommandLine& c) -> bool& { return c.options.synthesis.carriesMotion; });
  table.real("--coherence-weight", kSynthesis,
             "how much neighbours keep together: pieces of the film as\n"
             "large as they fit, for its large structures",
             "", ranges::kWeights, "thesis: 0",
             [](CommandLine& c) -> float& { return c.options.synthesis.coherenceWeight; });
  table.real("--lambda", kSynthesis, "how evenly the exemplar is used", "", ranges::kWeights,
             "thesis §2.5, §3.3",
             [](CommandLine& c) -> float& { return c.options.synthesis.lambda; });
  table.integer("--occ-radius", kSynthesis, "neighbouring frames that count as used", "frames",
                ranges::kOccurrenceRadii, "thesis §3.3",
                [](CommandLine& c) -> int& { return c.options.synthesis.occRadiusFrames; });
  table.real("--patchmatch-alpha", kSynthesis, "shrink of the search box per candidate", "",
             ranges::kAlphas, "thesis §4.3",
             [](CommandLine& c) -> float& { return c.options.synthesis.patchmatchAlpha; });
  table.integers(
      "--patchmatch-iterations", kSynthesis,
      "PatchMatch passes per coarser level, coarsest first, the last\n"
      "repeats; the finest level: see --opt-iterations",
      ranges::kPatchmatchIterations, "thesis §4.5",
      [](CommandLine& c) -> std::vector<int>& { return c.options.synthesis.patchmatchIterations; });
  table.integers("--opt-iterations", kSynthesis,
                 "search and vote per coarser level, coarsest first, the last\n"
                 "repeats; the finest has one sweep, none where its number is\n"
                 "0, unless --finest-level says upscaled",
                 ranges::kOptIterations, "thesis §4.5", [](CommandLine& c) -> std::vector<int>& {
                   return c.options.synthesis.optIterations;
                 });
  table.word<SearchEffort>(
      "--search", kSynthesis,
      "focused: random matches are tried where matches still change;\n"
      "everywhere: in every pass at every pixel",
      {{"focused", SearchEffort::kWhereItChanges}, {"everywhere", SearchEffort::kEverywhere}},
      "thesis §4.3: everywhere",
      [](CommandLine& c) -> SearchEffort& { return c.options.synthesis.searchEffort; });
  table.word<FinestLevel>("--finest-level", kSynthesis,
                          "refined: full-resolution matches of the last frame and of\n"
                          "neighbours are taken where they are better; searched: others\n"
                          "are looked for too, calmer but slow; upscaled: all come from\n"
                          "the next coarser level",
                          {{"upscaled", FinestLevel::kUpscaled},
                           {"refined", FinestLevel::kRefined},
                           {"searched", FinestLevel::kSearched}},
                          "thesis §4.4.3: upscaled", [](CommandLine& c) -> FinestLevel& {
                            return c.options.synthesis.finestLevel;
                          });
  table.real("--vote-sigma", kSynthesis,
             "painted pixels trust windows this close most; 0: all alike", "px",
             ranges::kVoteSigmasPx, "thesis §2.1.2: 0",
             [](CommandLine& c) -> float& { return c.options.synthesis.paintedVote.sigmaPx; });
  table.word<Interpolation>("--vote-interpolation", kSynthesis,
                            "how the film is read between its pixels, softest first",
                            {{"bilinear", Interpolation::kBilinear},
                             {"cubic", Interpolation::kCubic},
                             {"lanczos", Interpolation::kLanczos}},
                            "thesis §4.4.1: bilinear", [](CommandLine& c) -> Interpolation& {
                              return c.options.synthesis.paintedVote.interpolation;
                            });
  table.add({"--seed", kSynthesis, "N",
             "another seed, another painting" + facts(std::to_string(SynthesisOptions{}.seed), "",
                                                      "[0, 2^64 - 1]", "not in the thesis"),
             false, [](CommandLine& line, const std::string& value) {
               line.options.synthesis.seed = parseSeed("--seed", value);
             }});
}

void addGoingOn(Table& table) {
  table.add(
      {"--resume", kGoingOn, "",
       "go on after the last frame that a stopped run has saved a\nstate of: the same bytes as "
       "without a stop\n(default off)",
       false,
       [](CommandLine& line, const std::string&) { line.options.continuation.resume = true; }});
  table.add(
      {"--restart", kGoingOn, "",
       "discard what a stopped run has left, and begin anew\n(default off)", false,
       [](CommandLine& line, const std::string&) { line.options.continuation.restart = true; }});
  table.add({"--checkpoint-every", kGoingOn, "N",
             "frames from one saved state to the next\n(default as often as costs 2 % of the time; "
             "in " +
                 ranges::kCheckpointFrames.text() + ")",
             false, [](CommandLine& line, const std::string& value) {
               line.options.continuation.checkpointEvery =
                   parseInt("--checkpoint-every", value, ranges::kCheckpointFrames);
             }});
  table.add({"--keep-states", kGoingOn, "",
             "keep all saved states, for --render-frames\n(default off: the last one, until all is "
             "painted)",
             false, [](CommandLine& line, const std::string&) {
               line.options.continuation.keepStates = true;
             }});
  table.add({"--render-frames", kGoingOn, "A-B",
             "paint only these of the animation's frames, guided by all of\nthem; as in a full run "
             "where a state of the frame before A is\nsaved, else afresh\n(default all)",
             false, [](CommandLine& line, const std::string& value) {
               line.options.continuation.render = parseFrameNumbers("--render-frames", value);
             }});
  table.add(
      {"--verify", kGoingOn, "MANIFEST",
       "paint nothing; compare the frames beside a manifest,\nfluidymation.json, with what it "
       "says of them\n(default off)",
       false, [](CommandLine& line, const std::string& value) {
         if (value.empty()) {
           throw UsageError(shown("--verify", value) + ": wanted a manifest's name");
         }
         line.manifest = value;
       }});
}

void addRunning(Table& table) {
  table.add({"--threads", kRunningGroup, "N",
             "changes the clock only, never a byte\n(default OMP_NUM_THREADS, else "
             "SLURM_CPUS_PER_TASK,\nelse all processors; in " +
                 ranges::kThreads.text() + "; thesis §4.4.2)",
             false, [](CommandLine& line, const std::string& value) {
               line.options.threads = parseInt("--threads", value, ranges::kThreads);
             }});
  table.add({"--quiet", kRunningGroup, "",
             "no progress and no notes; errors are still printed\n(default off)", false,
             [](CommandLine& line, const std::string&) { line.quiet = true; }});
}

}  // namespace

std::vector<Spec> optionTable() {
  Table table;
  addFiles(table);
  addLook(table);
  addSequences(table);
  addMasksAndMotion(table);
  addGuides(table);
  addSynthesis(table);
  addGoingOn(table);
  addRunning(table);
  return table.take();
}

}  // namespace fluidymation::cli
