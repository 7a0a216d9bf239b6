#include "cli/command_line.h"

#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>
#include <vector>

#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/io/frame_pattern.h"

namespace fluidymation::cli {
namespace {

// Groups of the help text.
constexpr const char* kFiles = "Inputs and outputs";
constexpr const char* kSequences = "Sequences";
constexpr const char* kMasks = "Masks and motion";
constexpr const char* kGuides = "Guides";
constexpr const char* kSynthesis = "Synthesis";
constexpr const char* kRunning = "Running";

// What the options accept. The upper ends are far beyond anything useful; they catch slips and keep
// sums and products of options within their types.
constexpr Range kFrameNumbers{-1e9, 1e9};
constexpr Range kFrameCounts{1, 1e6};
constexpr Range kSpeeds{-1e6, 1e6};
constexpr Range kScales{0, 16, true};
constexpr Range kSigmas{0, 1000};
constexpr Range kThresholds{0, 0.5, true};
constexpr Range kWeights{0, 1e6};
constexpr Range kOccurrenceRadii{0, 1e4};
constexpr Range kAlphas{0, 1, true, true};
constexpr Range kWidths{0.1, 1e4};  // squares of the edge guide stay finite
constexpr Range kModulationBounds{0, 1e5};
constexpr Range kPatchmatchIterations{1, 1000};
constexpr Range kOptIterations{0, 1000};
constexpr Range kThreads{1, 1024};

/// One line of the option table.
struct Spec {
  std::string name;
  std::string group;
  std::string valueName;  ///< stands for the value in the help text; empty for a flag
  std::string help;
  bool required = false;
  std::function<void(CommandLine&, const std::string& value)> apply;
};

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

/// The table, built by one function a kind of value.
class Table {
 public:
  void pattern(const char* name, const char* what, const char* section, Field<std::string> field) {
    const std::string option = name;
    specs_.push_back({option, kFiles, "PATTERN",
                      std::string(what) + "\n(required; " + section + ")", true,
                      [option, field](CommandLine& line, const std::string& value) {
                        try {
                          field(line) = FramePattern(value).text();
                        } catch (const UsageError& error) {
                          throw UsageError(option + ": " + error.what());
                        }
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
                      range.text() + ", 1 to " + std::to_string(kLongestList) + " numbers",
                      section),
         false, [option, range, field](CommandLine& line, const std::string& value) {
           field(line) = parseIntList(option, value, range);
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
  table.pattern("--out-path", "painted frames to write, numbered as --target-path", "thesis §3.1",
                [](CommandLine& c) -> std::string& { return c.options.outPath; });
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

void addSequences(Table& table) {
  table.integer("--src-start", kSequences, "number of the exemplar's first frame", "",
                kFrameNumbers, "thesis §4.5",
                [](CommandLine& c) -> int& { return c.options.source.start; });
  table.integer("--src-frames", kSequences, "frames of the exemplar, at most", "frames",
                kFrameCounts, "thesis §4.5",
                [](CommandLine& c) -> int& { return c.options.source.frames; });
  table.integer(
      "--src-speed", kSequences, "from number to number; negative plays backwards", "", kSpeeds,
      "thesis §4.5", [](CommandLine& c) -> int& { return c.options.source.speed; }, false);
  table.real("--src-scale", kSequences, "scaling of the exemplar and its masks", "", kScales,
             "thesis §4.5", [](CommandLine& c) -> double& { return c.options.source.scale; });
  table.integer("--target-start", kSequences, "number of the animation's first frame", "",
                kFrameNumbers, "thesis §4.5",
                [](CommandLine& c) -> int& { return c.options.target.start; });
  table.integer("--target-frames", kSequences, "frames to paint, at most", "frames", kFrameCounts,
                "thesis §4.5", [](CommandLine& c) -> int& { return c.options.target.frames; });
  table.integer(
      "--target-speed", kSequences, "from number to number; negative plays backwards", "", kSpeeds,
      "thesis §4.5", [](CommandLine& c) -> int& { return c.options.target.speed; }, false);
  table.real("--target-scale", kSequences, "scaling of the animation", "", kScales, "thesis §4.5",
             [](CommandLine& c) -> double& { return c.options.target.scale; });
}

void addMasksAndMotion(Table& table) {
  table.real("--blur-sigma", kMasks, "smoothing of the masks; 0 is off, thin parts vanish", "px",
             kSigmas, "thesis §4.1",
             [](CommandLine& c) -> float& { return c.options.sourceMask.blurSigmaPx; });
  table.add({"--target-blur-sigma", kMasks, "X",
             "the same for the animation alone, to keep its thin parts" +
                 facts("as --blur-sigma", "", kSigmas.text(), "thesis §4.1"),
             false, [](CommandLine& line, const std::string& value) {
               line.options.targetBlurSigmaPx = parseFloat("--target-blur-sigma", value, kSigmas);
             }});
  table.real("--mask-threshold", kMasks, "inside is what the smoothed mask has from here up", "",
             kThresholds, "thesis §4.1",
             [](CommandLine& c) -> float& { return c.options.sourceMask.threshold; });
  table.real("--time-blur-sigma", kMasks, "smoothing of the edges' movement in time", "frames",
             kSigmas, "thesis §4.1",
             [](CommandLine& c) -> float& { return c.options.timeBlurSigmaFrames; });
}

void addGuides(Table& table) {
  table.real("--dist-weight", kGuides, "weight of the edge guide", "", kWeights, "thesis §3.4",
             [](CommandLine& c) -> float& { return c.options.synthesis.distWeight; });
  table.real("--flow-weight", kGuides, "weight of the motion extent guides", "", kWeights,
             "thesis §3.5",
             [](CommandLine& c) -> float& { return c.options.synthesis.flowWeight; });
  table.real("--prev-weight", kGuides, "weight of the previous frame", "", kWeights, "thesis §3.7",
             [](CommandLine& c) -> float& { return c.options.synthesis.prevWeight; });
  table.real("--border-width", kGuides, "width of the border segment", "px", kWidths, "thesis §3.4",
             [](CommandLine& c) -> float& { return c.options.synthesis.borderWidthPx; });
  const ModulationBounds bounds;
  table.add({"--prev-modulation-bounds", kGuides, "M_U,M_L",
             "the previous frame counts fully up to m_l, not from m_u on" +
                 facts(numberText(bounds.upperPx) + "," + numberText(bounds.lowerPx), "px",
                       kModulationBounds.text() + ", m_u > m_l", "thesis §3.7"),
             false, [](CommandLine& line, const std::string& value) {
               const FloatPair pair =
                   parseDescendingPair("--prev-modulation-bounds", value, kModulationBounds);
               line.options.synthesis.prevModulation = {pair.first, pair.second};
             }});
}

void addSynthesis(Table& table) {
  table.real("--lambda", kSynthesis, "how evenly the exemplar is used", "", kWeights,
             "thesis §2.5, §3.3",
             [](CommandLine& c) -> float& { return c.options.synthesis.lambda; });
  table.integer("--occ-radius", kSynthesis, "neighbouring frames that count as used", "frames",
                kOccurrenceRadii, "thesis §3.3",
                [](CommandLine& c) -> int& { return c.options.synthesis.occRadiusFrames; });
  table.real("--patchmatch-alpha", kSynthesis, "shrink of the search box per candidate", "",
             kAlphas, "thesis §4.3",
             [](CommandLine& c) -> float& { return c.options.synthesis.patchmatchAlpha; });
  table.integers("--patchmatch-iterations", kSynthesis,
                 "PatchMatch passes per level, coarsest first, the last repeats",
                 kPatchmatchIterations, "thesis §4.5", [](CommandLine& c) -> std::vector<int>& {
                   return c.options.synthesis.patchmatchIterations;
                 });
  table.integers(
      "--opt-iterations", kSynthesis, "search and vote per level, coarsest first, the last repeats",
      kOptIterations, "thesis §4.5",
      [](CommandLine& c) -> std::vector<int>& { return c.options.synthesis.optIterations; });
  table.add({"--seed", kSynthesis, "N",
             "another seed, another painting" + facts(std::to_string(SynthesisOptions{}.seed), "",
                                                      "[0, 2^64 - 1]", "not in the thesis"),
             false, [](CommandLine& line, const std::string& value) {
               line.options.synthesis.seed = parseSeed("--seed", value);
             }});
}

void addRunning(Table& table) {
  table.add({"--threads", kRunning, "N",
             "changes the clock only, never a byte\n(default OMP_NUM_THREADS, else "
             "SLURM_CPUS_PER_TASK,\nelse all processors; in " +
                 kThreads.text() + "; thesis §4.4.2)",
             false, [](CommandLine& line, const std::string& value) {
               line.options.threads = parseInt("--threads", value, kThreads);
             }});
  table.add({"--quiet", kRunning, "",
             "no progress and no notes; errors are still printed\n(default off)", false,
             [](CommandLine& line, const std::string&) { line.quiet = true; }});
}

[[nodiscard]] std::vector<Spec> optionTable() {
  Table table;
  addFiles(table);
  addSequences(table);
  addMasksAndMotion(table);
  addGuides(table);
  addSynthesis(table);
  addRunning(table);
  return table.take();
}

/// Letters to insert, delete or replace to turn `a` into `b` (Levenshtein).
[[nodiscard]] std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

[[noreturn]] void refuseArgument(const std::string& argument, const std::vector<Spec>& table) {
  if (argument.empty() || argument[0] != '-') {
    throw UsageError(shown("argument", argument) +
                     ": belongs to no option; wanted --option value (see --help)");
  }
  const std::string name = argument.substr(0, argument.find('='));
  std::string nearest;
  constexpr std::size_t kLongestName = 40;
  std::size_t smallest = 4;  // a name further away is another word
  for (const Spec& spec : table) {
    if (name.size() > kLongestName) break;
    const std::size_t distance = editDistance(name, spec.name);
    if (distance >= smallest) continue;
    smallest = distance;
    nearest = spec.name;
  }
  throw UsageError(shown("option", name) + ": there is no such option" +
                   (nearest.empty() ? "; see --help" : "; did you mean " + nearest + "?"));
}

/// CLI11 takes "--seed= 5" for "--seed 5"; to us it is an option without a value.
void refuseEmptyAssignments(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t equals = argument.find('=');
    if (argument.compare(0, 2, "--") == 0 && equals + 1 == argument.size()) {
      throw UsageError(shown(argument.substr(0, equals), "") + ": wanted --option=value");
    }
  }
}

/// The values given for `spec`, checked for number and for a forgotten value.
void applyOption(const Spec& spec, const std::vector<std::string>& values, CommandLine& line) {
  if (values.size() > 1) {
    throw UsageError(spec.name + ": given " + std::to_string(values.size()) +
                     " times; wanted once");
  }
  const std::string& value = values.front();
  if (spec.valueName.empty()) {
    if (value != "true") throw UsageError(shown(spec.name, value) + ": takes no value");
  } else if (value.compare(0, 2, "--") == 0) {
    throw UsageError(spec.name + ": the value is missing (" + shown("option", value) +
                     " follows at once)");
  }
  spec.apply(line, value);
}

void requireOptions(const std::vector<Spec>& table, const CLI::App& app) {
  std::string missing;
  for (const Spec& spec : table) {
    if (!spec.required || app.get_option(spec.name)->count() > 0) continue;
    missing += (missing.empty() ? "" : ", ") + spec.name;
  }
  if (!missing.empty()) throw UsageError(missing + ": required, but not given (see --help)");
}

[[nodiscard]] int firstNumber(const char* text) {
  if (text == nullptr) return 0;
  int value = 0;
  const char* const end = text + std::strlen(text);
  const auto [stop, failure] = std::from_chars(text, end, value);
  const bool complete = stop == end || *stop == ',';  // OMP_NUM_THREADS=4,2: one number per nesting
  return failure == std::errc{} && complete && kThreads.contains(value) ? value : 0;
}

/// What the program is and how it is called, then all options of `table`.
void describe(CLI::App& app, const std::vector<Spec>& table) {
  constexpr std::size_t kHelpColumn = 36;
  app.description(
      "Paints an animation of masks with a filmed medium (\"Stylizing vector animation\").\n"
      "Distances are pixels of the scaled input. PATTERN is a path with one frame number, as\n"
      "printf writes it: frames/%05d.png.");
  app.get_formatter()->column_width(kHelpColumn);
  for (const Spec& spec : table) {
    CLI::Option* option = spec.valueName.empty()
                              ? app.add_flag(spec.name, spec.help)
                              : app.add_option(spec.name, CLI::callback_t{}, spec.help);
    option->group(spec.group);
    if (!spec.valueName.empty()) option->option_text(spec.valueName);
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  // CLI11 lists groups in the order of their first option, so its own flags come last.
  app.set_help_flag("--help", "print this text")->group(kRunning);
  app.add_flag("--version", "print the version")->group(kRunning);
  app.allow_extras();  // so that the complaint is ours
}

}  // namespace

int defaultThreads(const char* ompNumThreads, const char* slurmCpusPerTask, int processors) {
  if (const int threads = firstNumber(ompNumThreads)) return threads;
  if (const int threads = firstNumber(slurmCpusPerTask)) return threads;
  return std::clamp(processors, static_cast<int>(kThreads.low), static_cast<int>(kThreads.high));
}

CommandLine parseCommandLine(int argc, const char* const* argv) {
  const std::vector<Spec> table = optionTable();
  CLI::App app("", "fluidymation");
  describe(app, table);
  CommandLine line;
  try {
    refuseEmptyAssignments(argc, argv);
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    line.information = app.help();
    return line;
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string message = error.what();  // begins with the option's name
    throw UsageError(message.substr(0, message.find(':')) + ": the value is missing (see --help)");
  } catch (const CLI::ParseError& error) {
    throw UsageError(oneLine(error.what()) + " (see --help)");
  }
  if (app.count("--version") > 0) {
    line.information = "fluidymation " FLUIDYMATION_VERSION "\n";
    return line;
  }
  // NOLINTBEGIN(concurrency-mt-unsafe): no other thread runs yet
  line.options.threads = defaultThreads(std::getenv("OMP_NUM_THREADS"),
                                        std::getenv("SLURM_CPUS_PER_TASK"), omp_get_num_procs());
  // NOLINTEND(concurrency-mt-unsafe)
  for (const Spec& spec : table) {
    const std::vector<std::string> values = app.get_option(spec.name)->results();
    if (!values.empty()) applyOption(spec, values, line);
  }
  // After the values: what a forgotten value pushed aside is not the user's mistake.
  const std::vector<std::string> extras = app.remaining();
  if (!extras.empty()) refuseArgument(extras.front(), table);
  requireOptions(table, app);
  return line;
}

}  // namespace fluidymation::cli
