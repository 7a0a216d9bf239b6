#include "cli/command_line.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <functional>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation::cli {
namespace {

using Arguments = std::vector<std::string>;

const Arguments kRequired = {"--src-path",    "s/%d.png", "--src-mask-path", "m/%d.png",
                             "--target-path", "t/%d.png", "--out-path",      "o/%d.png"};

CommandLine parse(const Arguments& arguments) {
  std::vector<const char*> argv = {"fluidymation"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return parseCommandLine(static_cast<int>(argv.size()), argv.data());
}

/// With the four required options before `more`.
Arguments complete(const Arguments& more) {
  Arguments arguments = kRequired;
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string complaint(const Arguments& arguments) {
  return test::messageOf<UsageError>([&] { (void)parse(arguments); });
}

/// A variable of the environment for the time of a test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    if (value != nullptr) {
      setenv(name, value, 1);
    } else {
      unsetenv(name);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

struct Reaching {
  const char* option;
  const char* value;
  std::function<bool(const CommandLine&)> reached;
};

using C = const CommandLine&;
using List = std::vector<int>;

/// Every option that takes a value, with a value that is not its default.
const std::vector<Reaching>& reachingOptions() {
  static const std::vector<Reaching> options = {
      {"--src-start", "-3", [](C c) { return c.options.source.start == -3; }},
      {"--src-frames", "7", [](C c) { return c.options.source.frames == 7; }},
      {"--src-speed", "-1", [](C c) { return c.options.source.speed == -1; }},
      {"--src-scale", "0.5", [](C c) { return c.options.source.scale == 0.5; }},
      {"--target-start", "0", [](C c) { return c.options.target.start == 0; }},
      {"--target-frames", "1000000", [](C c) { return c.options.target.frames == 1000000; }},
      {"--target-speed", "2", [](C c) { return c.options.target.speed == 2; }},
      {"--target-scale", "16", [](C c) { return c.options.target.scale == 16.0; }},
      {"--blur-sigma", "0", [](C c) { return c.options.blurSigmaPx == 0.0F; }},
      {"--target-blur-sigma", "1e1", [](C c) { return c.options.targetBlurSigmaPx == 10.0F; }},
      {"--mask-threshold", ".5", [](C c) { return c.options.maskThreshold == 0.5F; }},
      {"--time-blur-sigma", "1.25", [](C c) { return c.options.timeBlurSigmaFrames == 1.25F; }},
      {"--flow-blur-sigma", "1.5", [](C c) { return c.options.flowBlurSigmaFrames == 1.5F; }},
      {"--dir-weight", "1", [](C c) { return c.options.synthesis.dirWeight == 1.0F; }},
      {"--shape-guide", "blurred",
       [](C c) { return c.options.synthesis.shape.guide == ShapeGuide::kBlurredMask; }},
      {"--segments", "none", [](C c) { return !c.options.synthesis.shape.hardSegments; }},
      {"--tex-weight", "2", [](C c) { return c.options.synthesis.texWeight == 2.0F; }},
      {"--dist-weight", "4", [](C c) { return c.options.synthesis.distWeight == 4.0F; }},
      {"--flow-weight", "0.01", [](C c) { return c.options.synthesis.flowWeight == 0.01F; }},
      {"--prev-weight", "0", [](C c) { return c.options.synthesis.prevWeight == 0.0F; }},
      {"--lambda", "1.5", [](C c) { return c.options.synthesis.lambda == 1.5F; }},
      {"--occ-radius", "5", [](C c) { return c.options.synthesis.occRadiusFrames == 5; }},
      {"--patchmatch-alpha", "0.5",
       [](C c) { return c.options.synthesis.patchmatchAlpha == 0.5F; }},
      {"--border-width", "30", [](C c) { return c.options.borderWidthPx == 30.0F; }},
      {"--prev-modulation-bounds", "7.5,0",
       [](C c) {
         const ModulationBounds& bounds = c.options.synthesis.prevModulation;
         return bounds.upper == 7.5F && bounds.lower == 0.0F &&
                bounds.unit == ModulationUnit::kPixels;
       }},
      {"--patchmatch-iterations", "3",
       [](C c) { return c.options.synthesis.patchmatchIterations == List{3}; }},
      {"--opt-iterations", "5,0,1,2",
       [](C c) {
         return c.options.synthesis.optIterations == List{5, 0, 1, 2};
       }},
      {"--motion-model", "rigid",
       [](C c) { return c.options.motionModel == MotionModel::kRigidParts; }},
      {"--new-material", "fresh", [](C c) { return c.options.newMaterial == NewMaterial::kFresh; }},
      {"--new-material", "plain", [](C c) { return c.options.newMaterial == NewMaterial::kPlain; }},
      {"--thin-parts", "fringe",
       [](C c) { return c.options.synthesis.thinParts == ThinParts::kFringe; }},
      {"--extent-unit", "px",
       [](C c) { return c.options.synthesis.extentUnit == ExtentUnit::kPixels; }},
      {"--carry-motion", "off", [](C c) { return !c.options.synthesis.carriesMotion; }},
      {"--finest-level", "searched",
       [](C c) { return c.options.synthesis.finestLevel == FinestLevel::kSearched; }},
      {"--vote-sigma", "1.5", [](C c) { return c.options.synthesis.paintedVote.sigmaPx == 1.5F; }},
      {"--vote-interpolation", "bilinear",
       [](C c) {
         return c.options.synthesis.paintedVote.interpolation == Interpolation::kBilinear;
       }},
      {"--seed", "18446744073709551615",
       [](C c) { return c.options.synthesis.seed == 18446744073709551615U; }},
      {"--threads", "3", [](C c) { return c.options.threads == 3; }},
      {"--src-flow-path", "f/%d.flo", [](C c) { return c.options.sourceFlowPath == "f/%d.flo"; }},
      {"--target-flow-path", "g/%d.png",
       [](C c) { return c.options.targetFlowPath == "g/%d.png"; }},
      {"--flow-convention", "forward",
       [](C c) { return c.options.flowConvention == FlowConvention::kForward; }},
      {"--dump-guides", "d", [](C c) { return c.options.dumpGuidesDirectory == "d"; }},
  };
  return options;
}

TEST(CommandLine, EveryOptionReachesTheOptions) {
  const CommandLine defaults = parse(kRequired);
  for (const Reaching& o : reachingOptions()) {
    const bool machineDependent = std::string(o.option) == "--threads";
    EXPECT_TRUE(machineDependent || !o.reached(defaults)) << o.option;
    EXPECT_TRUE(o.reached(parse(complete({o.option, o.value})))) << o.option;
    EXPECT_TRUE(o.reached(parse(complete({std::string(o.option) + "=" + o.value})))) << o.option;
  }
  EXPECT_TRUE(parse(complete({"--quiet"})).quiet);
  EXPECT_FALSE(defaults.quiet);
}

TEST(CommandLine, PathsReachTheOptions) {
  const Options options = parse(kRequired).options;
  EXPECT_EQ(options.source.path, "s/%d.png");
  EXPECT_EQ(options.sourceMaskPath, "m/%d.png");
  EXPECT_EQ(options.target.path, "t/%d.png");
  EXPECT_EQ(options.outPath, "o/%d.png");
}

TEST(CommandLine, NumbersAreThoseOfTheThesisInEitherPreset) {
  for (const char* preset : {"standard", "thesis"}) {
    SCOPED_TRACE(preset);
    const Options o = parse(complete({"--preset", preset})).options;
    for (const SequenceOptions& sequence : {o.source, o.target}) {
      EXPECT_EQ(sequence.start, 1);
      EXPECT_EQ(sequence.frames, 50);
      EXPECT_EQ(sequence.speed, 1);
      EXPECT_EQ(sequence.scale, 1.0);
    }
    EXPECT_FALSE(o.targetBlurSigmaPx);
    EXPECT_EQ(o.maskThreshold, 0.3F);
    EXPECT_EQ(o.timeBlurSigmaFrames, 2.0F);
    EXPECT_EQ(o.flowBlurSigmaFrames, 0.0F);
    EXPECT_EQ(o.synthesis.shape.guide, ShapeGuide::kEdgeDistance);
    EXPECT_TRUE(o.synthesis.shape.hardSegments);
    EXPECT_EQ(o.synthesis.shape.modulation, ModulationDistance::kClamped);
    EXPECT_EQ(o.synthesis.dirWeight, 0.0F);
    EXPECT_EQ(o.synthesis.texWeight, 1.0F);
    EXPECT_EQ(o.synthesis.distWeight, 5.0F);
    EXPECT_EQ(o.synthesis.flowWeight, 0.1F);
    EXPECT_EQ(o.synthesis.prevWeight, 1.0F);
    EXPECT_EQ(o.synthesis.lambda, 2.0F);
    EXPECT_EQ(o.synthesis.occRadiusFrames, 10);
    EXPECT_EQ(o.synthesis.patchmatchAlpha, 0.75F);
    EXPECT_EQ(o.synthesis.patchmatchIterations, (List{6, 4}));
    EXPECT_EQ(o.synthesis.optIterations, (List{4, 3, 2}));
    EXPECT_EQ(o.synthesis.seed, 0U);
    EXPECT_FALSE(o.dumpGuidesDirectory);
  }
}

TEST(CommandLine, TheThesisPresetHasItsRulesAndGivesWayToOtherOptions) {
  const Options all = parse(complete({"--preset", "thesis"})).options;
  EXPECT_EQ(all.blurSigmaPx, 8.0F);
  EXPECT_EQ(all.borderWidthPx, 10.0F);
  EXPECT_EQ(all.motionModel, MotionModel::kNormals);
  EXPECT_EQ(all.newMaterial, NewMaterial::kPlain);
  EXPECT_EQ(all.synthesis.thinParts, ThinParts::kFringe);
  EXPECT_EQ(all.synthesis.extentUnit, ExtentUnit::kPixels);
  EXPECT_FALSE(all.synthesis.carriesMotion);
  EXPECT_EQ(all.synthesis.edgeGain, 1.0F);
  EXPECT_EQ(all.synthesis.prevModulation.upper, 10.0F);
  EXPECT_EQ(all.synthesis.prevModulation.lower, 2.0F);
  EXPECT_EQ(all.synthesis.prevModulation.unit, ModulationUnit::kPixels);
  const VoteOptions& thesis = all.synthesis.paintedVote;
  EXPECT_EQ(thesis.sigmaPx, 0.0F);
  EXPECT_EQ(thesis.interpolation, Interpolation::kBilinear);
  const VoteOptions standard = parse(kRequired).options.synthesis.paintedVote;
  EXPECT_NE(standard.sigmaPx, 0.0F);
  EXPECT_EQ(standard.interpolation, Interpolation::kLanczos);
  // Before or after it on the command line
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--vote-sigma", "2", "--lambda", "7", "--preset", "thesis"},
        std::vector<std::string>{"--preset", "thesis", "--lambda", "7", "--vote-sigma", "2"}}) {
    const SynthesisOptions given = parse(complete(arguments)).options.synthesis;
    EXPECT_EQ(given.paintedVote.sigmaPx, 2.0F);
    EXPECT_EQ(given.paintedVote.interpolation, Interpolation::kBilinear);
    EXPECT_EQ(given.lambda, 7.0F);
  }
}

TEST(CommandLine, ThePaperPresetHasTheNumbersOfItsTableAndItsRules) {
  const Options o = parse(complete({"--preset", "paper"})).options;
  const SynthesisOptions& s = o.synthesis;
  EXPECT_EQ(o.borderWidthPx, 30.0F);
  EXPECT_EQ(s.occRadiusFrames, 5);
  EXPECT_EQ(s.distWeight, 4.0F);
  EXPECT_EQ(s.flowWeight, 0.25F);
  EXPECT_EQ(s.dirWeight, 1.0F);
  EXPECT_EQ(s.prevWeight, 4.0F);
  EXPECT_EQ(s.lambda, 1.0F);
  EXPECT_EQ(s.prevModulation.upper, 0.1F);
  EXPECT_EQ(s.prevModulation.lower, 0.01F);
  EXPECT_EQ(s.prevModulation.unit, ModulationUnit::kTargetSides);
  EXPECT_EQ(s.shape.guide, ShapeGuide::kBlurredMask);
  EXPECT_FALSE(s.shape.hardSegments);
  EXPECT_EQ(s.shape.modulation, ModulationDistance::kUnclamped);
  EXPECT_EQ(o.timeBlurSigmaFrames, 0.0F);
  EXPECT_EQ(o.flowBlurSigmaFrames, 1.5F);
  EXPECT_EQ(s.extentUnit, ExtentUnit::kPixels);
  // What the paper leaves open is as in the thesis
  EXPECT_EQ(o.blurSigmaPx, 8.0F);
  EXPECT_EQ(s.edgeGain, 1.0F);
  EXPECT_EQ(s.thinParts, ThinParts::kFringe);
  EXPECT_FALSE(s.carriesMotion);
  EXPECT_EQ(o.motionModel, MotionModel::kNormals);
  EXPECT_EQ(o.newMaterial, NewMaterial::kPlain);
  EXPECT_EQ(s.paintedVote.sigmaPx, 0.0F);
  EXPECT_EQ(s.paintedVote.interpolation, Interpolation::kBilinear);
  EXPECT_EQ(s.optIterations, (List{4, 3, 2}));
}

TEST(CommandLine, OtherOptionsChangeThePaperPreset) {
  const SynthesisOptions s =
      parse(complete({"--prev-modulation-bounds", "7,3", "--preset", "paper", "--shape-guide",
                      "distance", "--segments", "hard", "--dir-weight", "0"}))
          .options.synthesis;
  EXPECT_EQ(s.prevModulation.upper, 7.0F);
  EXPECT_EQ(s.prevModulation.unit, ModulationUnit::kPixels);
  EXPECT_EQ(s.shape.guide, ShapeGuide::kEdgeDistance);
  EXPECT_TRUE(s.shape.hardSegments);
  EXPECT_EQ(s.dirWeight, 0.0F);
  EXPECT_EQ(s.prevWeight, 4.0F);
}

TEST(CommandLine, BadValuesAreNamedWithWhatIsWanted) {
  const std::string seed = ": wanted a whole number in [0, 18446744073709551615]";
  const std::string bounds = ": wanted two numbers m_u,m_l in pixels, e.g. 10,2";
  const std::string order =
      ": wanted two numbers m_u,m_l in [0, 100000] pixels with m_u greater than m_l, e.g. 10,2";
  const std::string optList =
      ": wanted 1 to 32 whole numbers in [0, 1000] separated by commas, e.g. 4,3,2";
  const std::string pmList =
      ": wanted 1 to 32 whole numbers in [1, 1000] separated by commas, e.g. 4,3,2";
  const std::string wantedStart = ": wanted a whole number in [-1000000000, 1000000000]";
  const std::string wantedFrames = ": wanted a whole number in [1, 1000000]";
  const std::string wantedSpeed = ": wanted a whole number in [-1000000, 1000000] other than 0";
  const std::string wantedScale = ": wanted a number in (0, 16]";
  const std::string wantedSigma = ": wanted a number in [0, 1000]";
  const std::string wantedTimeSigma = ": wanted a number in [0, 50]";
  const std::string wantedWeight = ": wanted a number in [0, 1000000]";
  const std::string wantedAlpha = ": wanted a number in (0, 0.99]";
  const std::string wantedWidth = ": wanted a number in [0.1, 10000]";
  const struct {
    const char* option;
    std::string value;
    std::string wanted;
  } cases[] = {
      {"--preset", "Paper", ": wanted standard, thesis or paper"},
      {"--shape-guide", "edge", ": wanted distance or blurred"},
      {"--segments", "1", ": wanted hard or none"},
      {"--flow-convention", "both", ": wanted backward or forward"},
      {"--dir-weight", "-1", wantedWeight},
      {"--flow-blur-sigma", "51", wantedTimeSigma},
      {"--mask-threshold", "0.7", ": wanted a number in (0, 0.5]"},
      {"--mask-threshold", "0", ": wanted a number in (0, 0.5]"},
      {"--mask-threshold", "0,3", ": wanted a number in (0, 0.5]"},
      {"--src-start", "2147483648", wantedStart},
      {"--src-start", "99999999999999999999", wantedStart},
      {"--src-start", "1.5", wantedStart},
      {"--target-start", "0x10", wantedStart},
      {"--src-frames", "0", wantedFrames},
      {"--src-frames", "-1", wantedFrames},
      {"--target-frames", "5x", wantedFrames},
      {"--target-frames", " 5", wantedFrames},
      {"--target-frames", "5 ", wantedFrames},
      {"--src-speed", "0", wantedSpeed},
      {"--target-speed", "-", wantedSpeed},
      {"--src-scale", "0", wantedScale},
      {"--src-scale", "-1", wantedScale},
      {"--src-scale", "nan", wantedScale},
      {"--src-scale", "1e-999", wantedScale},
      {"--target-scale", "inf", wantedScale},
      {"--target-scale", "16.01", wantedScale},
      {"--blur-sigma", "-0.1", wantedSigma},
      {"--blur-sigma", "8px", wantedSigma},
      {"--target-blur-sigma", "NaN", wantedSigma},
      {"--time-blur-sigma", "1e999", wantedTimeSigma},
      {"--time-blur-sigma", "50.01", wantedTimeSigma},
      {"--dist-weight", "-1", wantedWeight},
      {"--flow-weight", "infinity", wantedWeight},
      {"--prev-weight", "one", wantedWeight},
      {"--lambda", "2;3", wantedWeight},
      {"--occ-radius", "10001", ": wanted a whole number in [0, 10000]"},
      {"--occ-radius", "-1", ": wanted a whole number in [0, 10000]"},
      {"--patchmatch-alpha", "1", wantedAlpha},
      {"--patchmatch-alpha", "0", wantedAlpha},
      {"--patchmatch-alpha", "0.9901", wantedAlpha},
      {"--border-width", "0", wantedWidth},
      {"--border-width", "1e-30", wantedWidth},
      {"--prev-modulation-bounds", "10", bounds},
      {"--prev-modulation-bounds", "10,2,1", bounds},
      {"--prev-modulation-bounds", "2,10", order},
      {"--prev-modulation-bounds", "2,2", order},
      {"--prev-modulation-bounds", "10,-1", order},
      {"--prev-modulation-bounds", "10,", order},
      {"--prev-modulation-bounds", "inf,2", order},
      {"--patchmatch-iterations", "0", pmList},
      {"--patchmatch-iterations", "6,0", pmList},
      {"--patchmatch-iterations", ",", pmList},
      {"--opt-iterations", "4,,2", optList},
      {"--opt-iterations", "4,3,", optList},
      {"--opt-iterations", "4, 3", optList},
      {"--opt-iterations", "-1", optList},
      {"--opt-iterations", "[4,3]", optList},
      {"--seed", "-1", seed},
      {"--seed", "18446744073709551616", seed},
      {"--seed", "+1", seed},
      {"--threads", "0", ": wanted a whole number in [1, 1024]"},
      {"--threads", "1025", ": wanted a whole number in [1, 1024]"},
  };
  for (const auto& c : cases) {
    const std::string expected = std::string(c.option) + " " + c.value + c.wanted;
    EXPECT_EQ(complaint(complete({c.option, c.value})), expected);
    EXPECT_EQ(complaint(complete({std::string(c.option) + "=" + c.value})), expected);
  }
}

TEST(CommandLine, EndsOfARangeBelongToItWhateverTheirBinaryForm) {
  // The float next to 0.99 is above it, the one next to 0.1 as well.
  const Options options =
      parse(complete({"--patchmatch-alpha", "0.99", "--border-width", "0.1"})).options;
  EXPECT_EQ(options.synthesis.patchmatchAlpha, 0.99F);
  EXPECT_EQ(options.borderWidthPx, 0.1F);
}

TEST(CommandLine, EmptyValuesAreRefusedForEveryOption) {
  for (const Reaching& o : reachingOptions()) {
    const std::string begin = std::string(o.option) + " with an empty value: wanted ";
    EXPECT_EQ(complaint(complete({o.option, ""})).find(begin), 0U) << o.option;
    EXPECT_EQ(complaint(complete({std::string(o.option) + "=", "5"})), begin + "--option=value");
  }
  EXPECT_EQ(complaint({"--src-path", ""}),
            "--src-path: the path is empty; wanted one such as frames/%05d.png");
}

TEST(CommandLine, MissingValuesAreNoticed) {
  EXPECT_EQ(complaint(complete({"--seed"})), "--seed: the value is missing (see --help)");
  EXPECT_EQ(complaint(complete({"--seed", "--threads", "2"})),
            "--seed: the value is missing (option --threads follows at once)");
  EXPECT_EQ(complaint({"--src-path", "--src-mask-path", "m/%d.png"}),
            "--src-path: the value is missing (option --src-mask-path follows at once)");
}

TEST(CommandLine, AnAssignedValueMayBeginLikeAnOption) {
  Arguments arguments(kRequired.begin(), kRequired.begin() + 6);
  arguments.emplace_back("--out-path=--x/%d.png");
  EXPECT_EQ(parse(arguments).options.outPath, "--x/%d.png");
  EXPECT_EQ(parse(complete({"--dump-guides=--quiet"})).options.dumpGuidesDirectory, "--quiet");
  EXPECT_EQ(complaint(complete({"--dump-guides", "--x"})),
            "--dump-guides: the value is missing (option --x follows at once)");
  EXPECT_EQ(complaint(complete({"--seed=--5"})).find("--seed --5: wanted "), 0U);
}

TEST(CommandLine, FlagsTakeNoValue) {
  for (const std::string flag : {"--help", "--version", "--quiet"}) {
    for (const std::string value : {"1", "2", "true", "false", "{}", "yes", "--help"}) {
      EXPECT_EQ(complaint(complete({flag + "=" + value})), flag + " " + value + ": takes no value");
    }
    EXPECT_EQ(complaint(complete({flag + "="})), flag + " with an empty value: takes no value");
  }
  EXPECT_EQ(complaint(complete({"--quiet", "true"})).find("argument true: belongs to no option"),
            0U);
  EXPECT_TRUE(parse(complete({"--quiet"})).quiet);
}

TEST(CommandLine, RepeatedOptionsAreRefused) {
  for (const Reaching& o : reachingOptions()) {
    EXPECT_EQ(complaint(complete({o.option, o.value, o.option, o.value})),
              std::string(o.option) + ": given 2 times; wanted once");
  }
  EXPECT_EQ(complaint(complete({"--out-path", "x/%d.png"})),
            "--out-path: given 2 times; wanted once");
  EXPECT_EQ(complaint(complete({"--quiet", "--quiet"})), "--quiet: given 2 times; wanted once");
}

TEST(CommandLine, UnknownArgumentsAreNamedWithTheNearestOption) {
  EXPECT_EQ(complaint(complete({"--target-pth", "x"})),
            "option --target-pth: there is no such option; did you mean --target-path?");
  EXPECT_EQ(complaint(complete({"--border_width=3"})),
            "option --border_width: there is no such option; did you mean --border-width?");
  EXPECT_EQ(complaint(complete({"--blur", "4"})),
            "option --blur: there is no such option; did you mean --blur-sigma?");
  EXPECT_EQ(complaint(complete({"--prev=1"})),
            "option --prev: there is no such option; did you mean --prev-weight, "
            "--prev-modulation-bounds?");
  EXPECT_EQ(complaint(complete({"-", "x"})), "option -: there is no such option; see --help");
  EXPECT_EQ(complaint(complete({"--brush", "x"})),
            "option --brush: there is no such option; see --help");
  EXPECT_EQ(complaint(complete({"-s", "x"})), "option -s: there is no such option; see --help");
  EXPECT_EQ(complaint(complete({"stray"})),
            "argument stray: belongs to no option; wanted --option value (see --help)");
  EXPECT_EQ(complaint(complete({"--seed-1", "x"})).find("option --seed-1: there is no such"), 0U);
}

TEST(CommandLine, RequiredOptionsAreAllNamed) {
  EXPECT_EQ(complaint({}),
            "--src-path, --src-mask-path, --target-path, --out-path: required, but not given (see "
            "--help)");
  EXPECT_EQ(complaint(Arguments(kRequired.begin(), kRequired.begin() + 6)),
            "--out-path: required, but not given (see --help)");
}

TEST(CommandLine, PatternsAreCheckedAndNamed) {
  for (const char* option : {"--src-path", "--src-mask-path", "--target-path", "--out-path",
                             "--src-flow-path", "--target-flow-path"}) {
    for (const char* pattern : {"a.png", "%s.png", "%n", "%99999999d", "%", "%d%d", "%d/a.png"}) {
      const std::string message = complaint({option, pattern});
      EXPECT_EQ(message.find(std::string(option) + ": " + pattern + ": "), 0U) << message;
    }
  }
}

TEST(CommandLine, OutputIsNamedAsWhatItIs) {
  const std::string wanted = ": frames are written as PNG; wanted a name that ends in .png";
  for (const char* pattern :
       {"x/%05d.jpg", "x/%05d", "x.png/%05d", "%dpng", "x.png%d", "%d.png "}) {
    Arguments arguments = kRequired;
    arguments.back() = pattern;
    EXPECT_EQ(complaint(arguments), "--out-path: " + std::string(pattern) + wanted);
  }
  for (const char* pattern : {"x/%05d.PNG", "%d.png", "x%d_.Png"}) {
    Arguments arguments = kRequired;
    arguments.back() = pattern;
    EXPECT_EQ(parse(arguments).options.outPath, pattern);
  }
}

TEST(CommandLine, EveryComplaintIsOneLine) {
  const std::string hostile = "a\nb\x1b[31m%d\r" + std::string(100000, 'x');
  for (const Reaching& o : reachingOptions()) {
    if (std::string(o.option) == "--dump-guides") continue;  // any folder's name will do
    const std::string message = complaint(complete({o.option, hostile}));
    EXPECT_EQ(message.find_first_of("\n\r\x1b"), std::string::npos) << message;
    EXPECT_NE(message, "");
    EXPECT_LT(message.size(), 400U);
  }
  for (const Arguments& arguments :
       {Arguments{hostile}, {"--" + hostile}, {"--src-path", hostile}, {"-" + hostile}}) {
    const std::string message = complaint(arguments);
    EXPECT_EQ(message.find_first_of("\n\r\x1b"), std::string::npos) << message;
    EXPECT_LT(message.size(), 400U);
  }
}

TEST(CommandLine, HelpNamesEveryOptionWithDefaultAndRange) {
  const std::string help = parse({"--help"}).information.value_or("");
  for (const Reaching& o : reachingOptions()) {
    EXPECT_NE(help.find("  " + std::string(o.option) + " "), std::string::npos) << o.option;
  }
  for (const char* text : {"--src-path PATTERN",
                           "--src-mask-path PATTERN",
                           "--target-path PATTERN",
                           "--out-path PATTERN",
                           "--quiet",
                           "--version",
                           "--help",
                           "Inputs and outputs:",
                           "Sequences:",
                           "Masks and motion:",
                           "Guides:",
                           "Synthesis:",
                           "Running:",
                           "(default 0.0125 times the square root of their mean area;",
                           "in [0, 1000] px; thesis §4.1: 8)",
                           "(default 0.3; in (0, 0.5]",
                           "(default 0.75; in (0, 0.99]",
                           "(default 1 and 0.2 times the border width;",
                           "(default 6,4;",
                           "(default 4,3,2;",
                           "(default 50 frames; in [1, 1000000]",
                           "(default 0.1;",
                           "(default that of --blur-sigma if given, else by its own masks;",
                           "OMP_NUM_THREADS",
                           "SLURM_CPUS_PER_TASK",
                           "thesis §3.7"}) {
    EXPECT_NE(help.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(help.find("\n\n\n"), std::string::npos);
}

TEST(CommandLine, NoLineOfTheHelpIsLongerThan100Characters) {
  std::istringstream help(parse({"--help"}).information.value_or(""));
  for (std::string line; std::getline(help, line);) {
    const auto characters = std::count_if(line.begin(), line.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // what continues one in UTF-8
    });
    EXPECT_LE(characters, 100) << line;
  }
}

/// From `begin` on up to the next `end`; all of it where one is not found.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t first = text.find(begin);
  return text.substr(first, text.find(end, first) - first);
}

TEST(CommandLine, TheReadmeListsTheOptionsAsHelpDoes) {
  const std::string firstGroup = "Inputs and outputs:\n";
  const std::string help = parse({"--help"}).information.value_or("");
  ASSERT_NE(help.find(firstGroup), std::string::npos);
  const test::Bytes bytes = test::readBytes(FLUIDYMATION_README);
  const std::string readme(bytes.begin(), bytes.end());
  ASSERT_NE(readme.find(firstGroup), std::string::npos);
  std::string options = help.substr(help.find(firstGroup));
  options.erase(options.find_last_not_of('\n') + 1);
  EXPECT_EQ(between(readme, firstGroup, "\n```"), options);
}

TEST(CommandLine, HelpAndVersionNeedNothingElse) {
  EXPECT_EQ(parse({"--version"}).information, "fluidymation " FLUIDYMATION_VERSION "\n");
  EXPECT_TRUE(parse({"--seed", "5", "--help"}).information);
  EXPECT_EQ(parse({"-h"}).information, parse({"--help"}).information);
  EXPECT_FALSE(parse(kRequired).information);
}

/// Numbers as in much of Europe: 1.000,5.
class DecimalComma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(CommandLine, TheLocaleDoesNotMatter) {
  const std::string help = parse({"--help"}).information.value_or("");
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string cBefore = std::setlocale(LC_ALL, nullptr);
  // C's own locale where the machine has such a one; the C++ one above is always there.
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  const CommandLine line = parse(complete({"--lambda", "1.5", "--src-frames", "1000000"}));
  const std::string message = complaint(complete({"--lambda", "1,5"}));
  const std::string helpThere = parse({"--help"}).information.value_or("");
  std::setlocale(LC_ALL, cBefore.c_str());
  std::locale::global(before);
  EXPECT_EQ(line.options.synthesis.lambda, 1.5F);
  EXPECT_EQ(line.options.source.frames, 1000000);
  EXPECT_EQ(message, "--lambda 1,5: wanted a number in [0, 1000000]");
  EXPECT_EQ(helpThere, help);
}

TEST(CommandLine, ThreadsFollowTheEnvironmentUnlessGiven) {
  EXPECT_EQ(defaultThreads(nullptr, nullptr, 6), 6);
  EXPECT_EQ(defaultThreads("4", "3", 6), 4);
  EXPECT_EQ(defaultThreads("4,2", "3", 6), 4);
  EXPECT_EQ(defaultThreads(nullptr, "3", 6), 3);
  for (const char* invalid : {"", "0", "-2", "many", "4x", "1e3", "99999999999", "1025", " "}) {
    EXPECT_EQ(defaultThreads(invalid, "3", 6), 3) << invalid;
    EXPECT_EQ(defaultThreads(nullptr, invalid, 6), 6) << invalid;
  }
  EXPECT_EQ(defaultThreads(nullptr, nullptr, 5000), 1024);
  EXPECT_EQ(defaultThreads(nullptr, nullptr, 0), 1);

  const Variable omp("OMP_NUM_THREADS", nullptr);
  const Variable slurm("SLURM_CPUS_PER_TASK", "7");
  EXPECT_EQ(parse(kRequired).options.threads, 7);
  {
    const Variable ompGiven("OMP_NUM_THREADS", "5");
    EXPECT_EQ(parse(kRequired).options.threads, 5);
    EXPECT_EQ(parse(complete({"--threads", "2"})).options.threads, 2);
  }
  const Variable slurmMissing("SLURM_CPUS_PER_TASK", nullptr);
  EXPECT_EQ(parse(kRequired).options.threads, omp_get_num_procs());
}

TEST(CommandLine, NoArgumentsAtAllIsWrongUsage) {
  EXPECT_NE(test::messageOf<UsageError>([] { (void)parseCommandLine(0, nullptr); }), "");
}

}  // namespace
}  // namespace fluidymation::cli
