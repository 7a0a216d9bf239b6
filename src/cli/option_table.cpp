#include "cli/option_table.h"

#include <optional>
#include <string>
#include <vector>

#include "cli/nearest.h"
#include "cli/table_builder.h"
#include "cli/values.h"
#include "fluidymation/automatic.h"
#include "fluidymation/core/color.h"
#include "fluidymation/core/error.h"
#include "fluidymation/option_ranges.h"
#include "fluidymation/presets.h"

namespace fluidymation::cli {
namespace {

// Groups of the help text.
constexpr const char* kLook = "Look";
constexpr const char* kMasks = "Masks and motion";
constexpr const char* kGuides = "Guides";
constexpr const char* kSynthesis = "Synthesis";

constexpr const char* kSizeWord = "size";  ///< of --border-width: by the film's size

/// Applied before the options that it sets: those given besides replace what it says.
void addLook(Table& table) {
  table.add({"--preset", kLook, "NAME",
             "standard: the best we know; crisp: larger, harder pieces of\nthe film; calm: softer, "
             "less flicker, slower;\nthesis, paper: their numbers and rules, whatever "
             "the\ndefaults; what else is given prevails\n"
             "(default standard; thesis §4.5, paper table 1)",
             false,
             [](CommandLine& line, const std::string& value) {
               const auto preset = findPreset(value);
               if (!preset) {
                 throw UsageError(shown("--preset", value) + ": " +
                                  wantedWord(value, presetNames()));
               }
               preset->apply(line.options);
               line.preset = value;
             },
             [](const CommandLine& line) { return std::optional<std::string>(line.preset); },
             presetNames()});
  table.add({"--recolor", kLook, "COLOR",
             "give the paint this hue and chroma and keep its lightness:\n#RRGGBB, white, black, "
             "gray; the bare surface stays as it is\n(default off; not in the thesis)",
             false,
             [](CommandLine& line, const std::string& value) {
               const std::optional<Rgb> color = colorOf(value);
               if (!color) {
                 throw UsageError(shown("--recolor", value) +
                                  ": wanted a colour, #RRGGBB, white, black or gray");
               }
               line.options.recolor = {toByte(color->r), toByte(color->g), toByte(color->b)};
             },
             [](const CommandLine& line) -> std::optional<std::string> {
               if (!line.options.recolor) return std::nullopt;
               return colorText(*line.options.recolor);
             }});
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

/// A number, or a rule that finds one.
void addBorderWidth(Table& table) {
  table.add(
      {"--border-width", kGuides, "X",
       "width of the border segment; auto: measured, where the film's\ncolours stop depending on "
       "the distance to the edge\n(default size: " +
           numberText(kBorderWidthShare) + " times the square root of the film frames'\narea; in " +
           ranges::kWidthsPx.text() + " px; thesis §3.4: 10)",
       false,
       [](CommandLine& line, const std::string& value) {
         line.options.borderWidthPx.reset();
         line.options.borderWidthRule = BorderWidthRule::kBySize;
         if (value == kSizeWord) return;
         if (value == kAutomaticWord) {
           line.options.borderWidthRule = BorderWidthRule::kMeasured;
         } else {
           line.options.borderWidthPx =
               parseFloat("--border-width", value, ranges::kWidthsPx,
                          std::string(", ") + kAutomaticWord + " or " + kSizeWord);
         }
       },
       [](const CommandLine& line) -> std::optional<std::string> {
         const Options& options = line.options;
         if (options.borderWidthPx) return numberText(*options.borderWidthPx);
         return options.borderWidthRule == BorderWidthRule::kBySize ? kSizeWord : kAutomaticWord;
       }});
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
  table.real("--prev-weight", kGuides,
             "weight of the previous frame; twice that of the thesis' and\n"
             "paper's presets",
             "", ranges::kWeights, "thesis §3.7",
             [](CommandLine& c) -> float& { return c.options.synthesis.prevWeight; });
  table.real("--prev-deepening", kGuides,
             "keeps the body colours of moving shapes, with the two\n"
             "options below; 0: less; 2.5: more, fronts less steady",
             "", ranges::kDeepenings, "thesis §3.7: 0",
             [](CommandLine& c) -> float& { return c.options.synthesis.prevDeepening; });
  table.integer("--prev-depth-reach", kGuides,
                "how far in the film's time remembered matches may go to lie\n"
                "as deep inside the mask as their pixels; 0: not at all",
                "frames", ranges::kDepthReaches, "thesis §3.7: 0",
                [](CommandLine& c) -> int& { return c.options.synthesis.prevDepthReachFrames; });
  table.real("--prev-color-correction", kGuides,
             "pulls the mean colours of moving shapes back to the film's, by\n"
             "this share in each frame; 1: fully, less calm; 0: not at all,\n"
             "as always where lines are drawn",
             "", ranges::kColorCorrections, "thesis §3.7: 0",
             [](CommandLine& c) -> float& { return c.options.synthesis.prevColorCorrection; });
  addBorderWidth(table);
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
  table.word<Reverse>("--reverse", kGuides,
                      "on: paint from the last frame to the first; auto: where lines\n"
                      "are being drawn and --new-material is plain",
                      {{"off", Reverse::kOff}, {"on", Reverse::kOn}, {"auto", Reverse::kAutomatic}},
                      "paper §5, thesis figure 5.4",
                      [](CommandLine& c) -> Reverse& { return c.options.reverse; });
  const ModulationBounds bounds;
  table.add(
      {"--prev-modulation-bounds", kGuides, "M_U,M_L",
       "the previous frame counts fully up to m_l, not from m_u on\n(default " +
           numberText(bounds.upper) + " and " + numberText(bounds.lower) +
           " times the border width;\nin " + ranges::kModulationBoundsPx.text() +
           " px, m_u > m_l; thesis §3.7: 10,2)",
       false,
       [](CommandLine& line, const std::string& value) {
         const FloatPair pair =
             parseDescendingPair("--prev-modulation-bounds", value, ranges::kModulationBoundsPx);
         line.options.synthesis.prevModulation = {pair.first, pair.second, ModulationUnit::kPixels};
       },
       [](const CommandLine& line) -> std::optional<std::string> {
         const ModulationBounds& b = line.options.synthesis.prevModulation;
         if (b.unit != ModulationUnit::kPixels) return std::nullopt;
         return numberText(b.upper) + "," + numberText(b.lower);
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
  table.real("--opt-vote-sigma", kSynthesis,
             "while searching, windows this close count most: small finds\n"
             "more detail, large smoother patches; 0: all count alike;\n"
             "where lines are drawn they always do",
             "px", ranges::kVoteSigmasPx, "thesis §2.1.2: 0",
             [](CommandLine& c) -> float& { return c.options.synthesis.optVoteSigmaPx; });
  table.word<Interpolation>("--vote-interpolation", kSynthesis,
                            "how the film is read between its pixels, softest first",
                            {{"bilinear", Interpolation::kBilinear},
                             {"cubic", Interpolation::kCubic},
                             {"lanczos", Interpolation::kLanczos}},
                            "thesis §4.4.1: bilinear", [](CommandLine& c) -> Interpolation& {
                              return c.options.synthesis.paintedVote.interpolation;
                            });
  table.real("--seam-blending", kSynthesis,
             "softens the seams where pieces of the film meet; 2: softer;\n"
             "0: as they are, harder",
             "", ranges::kSeamWeights, "not in the thesis",
             [](CommandLine& c) -> float& { return c.options.synthesis.paintedVote.seamWeight; });
  table.real("--change-blending", kSynthesis,
             "where pieces of the film give way to others in a new frame, the\n"
             "old ones keep this share for one frame; 0: none, livelier",
             "", ranges::kChangeShares, "not in the thesis",
             [](CommandLine& c) -> float& { return c.options.synthesis.changeBlending; });
  table.real("--detail-restoration", kSynthesis,
             "brings the finest detail to the film's own strength, by this\n"
             "share; 0: as it was painted, mostly softer",
             "", ranges::kDetailShares, "not in the thesis",
             [](CommandLine& c) -> float& { return c.options.synthesis.detailRestoration; });
  table.add({"--seed", kSynthesis, "N",
             "another seed, another painting" + facts(std::to_string(SynthesisOptions{}.seed), "",
                                                      "[0, 2^64 - 1]", "not in the thesis"),
             false,
             [](CommandLine& line, const std::string& value) {
               line.options.synthesis.seed = parseSeed("--seed", value);
             },
             [](const CommandLine& line) {
               return std::optional<std::string>(std::to_string(line.options.synthesis.seed));
             }});
}

[[nodiscard]] Words<ProgressFormat> progressFormats() {
  return {{"human", ProgressFormat::kHuman},
          {"json", ProgressFormat::kJson},
          {"openjd", ProgressFormat::kOpenJobDescription}};
}

void addRunning(Table& table) {
  table.add({"--threads", kRunningGroup, "N",
             "changes the clock only, never a byte\n(default OMP_NUM_THREADS, else "
             "SLURM_CPUS_PER_TASK,\nelse all processors; in " +
                 ranges::kThreads.text() + "; thesis §4.4.2)",
             false,
             [](CommandLine& line, const std::string& value) {
               line.options.threads = parseInt("--threads", value, ranges::kThreads);
               line.threadsAreGiven = true;
             },
             [](const CommandLine& line) -> std::optional<std::string> {
               if (!line.threadsAreGiven) return std::nullopt;
               return std::to_string(line.options.threads);
             }});
  table.add(
      {"--max-memory", kRunningGroup, "SIZE",
       "refuse to begin what may need more, e.g. 4G or 800M\n(default what the machine or its "
       "control group has; at least\n16M; not in the thesis)",
       false,
       [](CommandLine& line, const std::string& value) {
         line.options.maxMemoryBytes = parseBytes("--max-memory", value, ranges::kLeastMemoryBytes);
       },
       [](const CommandLine& line) -> std::optional<std::string> {
         const auto& bytes = line.options.maxMemoryBytes;
         return bytes ? std::optional<std::string>(std::to_string(*bytes)) : std::nullopt;
       }});
  table.add(
      {"--progress", kRunningGroup, "NAME",
       "human: on stderr; json: an object a frame, openjd: Open Job\nDescription's lines; both "
       "on stdout, with --quiet too\n(default human)",
       false,
       [](CommandLine& line, const std::string& value) {
         line.progress = parseWord("--progress", value, progressFormats());
         line.progressIsGiven = true;
       },
       [](const CommandLine& line) {
         return std::optional<std::string>(wordFor(progressFormats(), line.progress));
       },
       namesOf(progressFormats())});
  table.add({"--quiet", kRunningGroup, "",
             "no progress and no notes; errors are still printed\n(default off)", false,
             [](CommandLine& line, const std::string&) { line.quiet = true; },
             [](const CommandLine& line) { return flagText(line.quiet); }});
}

}  // namespace

std::vector<Spec> optionTable() {
  Table table;
  addFiles(table);
  addConfig(table);
  addLook(table);
  addSequences(table);
  addMasksAndMotion(table);
  addGuides(table);
  addSynthesis(table);
  addGoingOn(table);
  addPreview(table);
  addRunning(table);
  return table.take();
}

}  // namespace fluidymation::cli
