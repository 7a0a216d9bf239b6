// What the command line is read as, and what it is refused for.

#include "cli/command_line.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <clocale>
#include <cmath>
#include <locale>
#include <set>
#include <string>

#include "cli/command_line_arguments.h"
#include "cli/painter_syntax.h"
#include "fluidymation/core/error.h"
#include "support/environment.h"
#include "support/temporary_folder.h"

namespace fluidymation::cli {
namespace {

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
  EXPECT_TRUE(parse(complete({"--resume"})).options.continuation.resume);
  EXPECT_TRUE(parse(complete({"--restart"})).options.continuation.restart);
  EXPECT_EQ(parse(complete({"--overwrite"})).options.continuation.existing,
            ExistingFrames::kReplace);
  EXPECT_EQ(parse(complete({"--skip-existing"})).options.continuation.existing,
            ExistingFrames::kKeep);
  EXPECT_EQ(complaint(complete({"--skip-existing", "--overwrite"})),
            "--overwrite, --skip-existing: wanted one of them at most");
  EXPECT_TRUE(parse(complete({"--keep-states"})).options.continuation.keepStates);
  EXPECT_EQ(parse({"--verify", "m.json"}).manifest, "m.json");
}

TEST(CommandLine, PathsReachTheOptions) {
  const Options options = parse(kRequired).options;
  EXPECT_EQ(options.source.path, "s/%d.png");
  EXPECT_EQ(options.sourceMaskPath, "m/%d.png");
  EXPECT_EQ(options.target.path, "t/%d.png");
  EXPECT_EQ(options.outPath, "o/%d.png");
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
  const std::string wantedSigma = ": wanted a number in [0, 1000] or auto";
  const std::string wantedTimeSigma = ": wanted a number in [0, 50]";
  const std::string wantedWeight = ": wanted a number in [0, 1000000]";
  const std::string wantedAlpha = ": wanted a number in (0, 0.99]";
  const std::string wantedWidth = ": wanted a number in [0.1, 10000], auto or size";
  const std::string wantedRange =
      ": wanted two frame numbers and a step from 1 up, e.g. 10-80x2, or without x2";
  const struct {
    const char* option;
    std::string value;
    std::string wanted;
  } cases[] = {
      {"--preset", "Paper", ": wanted standard, crisp, calm, thesis or paper; did you mean paper?"},
      {"--new-material", "flesh", ": wanted auto, fresh or plain; did you mean fresh?"},
      {"--src-range", "10-80x0", wantedRange},
      {"--src-range", "10-80x", wantedRange},
      {"--target-range", "10-", wantedRange},
      {"--target-range", "x2", wantedRange},
      {"--target-range", "1-2000000", ": 2000000 frames; wanted a number in [1, 1000000]"},
      {"--shape-guide", "edge", ": wanted distance or blurred"},
      {"--segments", "1", ": wanted hard or none"},
      {"--search", "all", ": wanted focused or everywhere"},
      {"--flow-convention", "both", ": wanted backward or forward"},
      {"--dir-weight", "-1", wantedWeight},
      {"--lambda", "1e-300", ": is too near to 0; wanted a number in [0, 1000000]"},
      {"--lambda", "-1e-300", ": is too near to 0; wanted a number in [0, 1000000]"},
      {"--lambda", "1e300", wantedWeight},
      {"--lambda", "1e-3x", wantedWeight},
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
      {"--src-scale", "1e-999", ": is too near to 0; wanted a number in (0, 16]"},
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
      {"--compression-level", "10", ": wanted a whole number in [0, 9]"},
      {"--compression-level", "best", ": wanted a whole number in [0, 9]"},
      {"--threads", "0", ": wanted a whole number in [1, 1024]"},
      {"--threads", "1025", ": wanted a whole number in [1, 1024]"},
      {"--max-memory", "4X", ": wanted a size of at least 16M, with K, M, G or T, e.g. 800M or 4G"},
      {"--max-memory", "G", ": wanted a size of at least 16M, with K, M, G or T, e.g. 800M or 4G"},
      {"--max-memory", "-4G",
       ": wanted a size of at least 16M, with K, M, G or T, e.g. 800M or 4G"},
      {"--max-memory", "1e300T",
       ": wanted a size of at least 16M, with K, M, G or T, e.g. 800M or 4G"},
      {"--max-memory", "16777215",
       ": wanted a size of at least 16M, with K, M, G or T, e.g. 800M or 4G"},
      {"--max-memory", "90000T",
       ": wanted a size of at least 16M, with K, M, G or T, e.g. 800M or 4G"},
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

TEST(CommandLine, MinusZeroIsZero) {
  EXPECT_FALSE(std::signbit(parse(complete({"--lambda=-0"})).options.synthesis.lambda));
  EXPECT_FALSE(std::signbit(
      parse(complete({"--seam-blending=-0.0"})).options.synthesis.paintedVote.seamWeight));
}

TEST(CommandLine, UnknownArgumentsAreNamedWithTheNearestOption) {
  EXPECT_EQ(complaint(complete({"--target-pth", "x"})),
            "option --target-pth: there is no such option; did you mean --target-path?");
  EXPECT_EQ(complaint(complete({"--border_width=3"})),
            "option --border_width: there is no such option; did you mean --border-width?");
  EXPECT_EQ(complaint(complete({"--blur", "4"})),
            "option --blur: there is no such option; did you mean --blur-sigma?");
  EXPECT_EQ(complaint(complete({"--prev-=1"})),
            "option --prev-: there is no such option; did you mean --prev-weight, "
            "--prev-deepening, --prev-depth-reach, --prev-color-correction, "
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
    // Any name will do for these, as far as the command line can tell
    if (std::set<std::string>{"--background", "--dump-guides", "--preview", "--preview-background"}
            .count(o.option) > 0) {
      continue;
    }
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

  const test::EnvironmentVariable omp("OMP_NUM_THREADS", nullptr);
  const test::EnvironmentVariable slurm("SLURM_CPUS_PER_TASK", "7");
  EXPECT_EQ(parse(kRequired).options.threads, 7);
  {
    const test::EnvironmentVariable ompGiven("OMP_NUM_THREADS", "5");
    EXPECT_EQ(parse(kRequired).options.threads, 5);
    EXPECT_EQ(parse(complete({"--threads", "2"})).options.threads, 2);
  }
  const test::EnvironmentVariable slurmMissing("SLURM_CPUS_PER_TASK", nullptr);
  EXPECT_EQ(parse(kRequired).options.threads, omp_get_num_procs());
}

TEST(CommandLine, NoArgumentsAtAllIsWrongUsage) {
  EXPECT_NE(
      test::messageOf<UsageError>([] { (void)parseCommandLine(painterSyntax(), 0, nullptr); }), "");
}

}  // namespace
}  // namespace fluidymation::cli
