// Options from a file, and the file that --print-config writes.

#include "cli/config_file.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "cli/command_line_arguments.h"
#include "cli/nearest.h"
#include "fluidymation/core/error.h"
#include "pipeline/option_texts.h"
#include "support/temporary_folder.h"

namespace fluidymation::cli {
namespace {

using test::messageOf;
using test::TemporaryFolder;

/// A config file of these lines.
class ConfigFile {
 public:
  explicit ConfigFile(const std::string& text) : path_(folder_.file("shot.toml")) {
    test::writeBytes(path_, test::bytesOf(text));
  }

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] CommandLine parsed(const Arguments& more = {}) const {
    Arguments arguments = {"--config", path_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return parse(arguments);
  }
  /// With the file's name cut off.
  [[nodiscard]] std::string fault() const {
    const std::string message = messageOf<UsageError>([&] { (void)parsed(kRequired); });
    return message.compare(0, path_.size() + 2, path_ + ": ") == 0
               ? message.substr(path_.size() + 2)
               : message;
  }

 private:
  TemporaryFolder folder_;
  std::string path_;
};

constexpr const char* kPaths =
    "src-path = \"s/%d.png\"\nsrc-mask-path = 'm/%d.png'\ntarget-path = t/%d.png\n"
    "out-path = \"o, my #1 folder/###.png\"  # a comment\n";

TEST(ConfigFile, GivesOptionsAsTheCommandLineDoes) {
  const ConfigFile file(std::string("# A shot.\r\n") + kPaths +
                        "\n  border-width=12 # px\nopt-iterations = [4, 2]\n"
                        "patchmatch-iterations = 5,3\nquiet = true\nkeep-states = false\n"
                        "src-range = \"3-9x2\"\nseed=7\nlambda = 1");
  const CommandLine line = file.parsed();
  EXPECT_EQ(line.options.source.path, "s/%d.png");
  EXPECT_EQ(line.options.sourceMaskPath, "m/%d.png");
  EXPECT_EQ(line.options.target.path, "t/%d.png");
  EXPECT_EQ(line.options.outPath, "o, my #1 folder/###.png");
  EXPECT_EQ(line.options.borderWidthPx, 12.0F);
  EXPECT_EQ(line.options.synthesis.optIterations, (List{4, 2}));
  EXPECT_EQ(line.options.synthesis.patchmatchIterations, (List{5, 3}));
  EXPECT_TRUE(line.quiet);
  EXPECT_FALSE(line.options.continuation.keepStates);
  EXPECT_EQ(line.options.source.frames, 4);
  EXPECT_EQ(line.options.synthesis.seed, 7U);
  EXPECT_EQ(line.options.synthesis.lambda, 1.0F);
}

TEST(ConfigFile, GivesWayToTheCommandLine) {
  const ConfigFile file(std::string(kPaths) +
                        "lambda = 7\nborder-width = 12\nsrc-start = 4\nvote-sigma = 3\n"
                        "preset = \"paper\"\n");
  const Options given = file.parsed({"--lambda", "1", "--border-width", "size"}).options;
  EXPECT_EQ(given.synthesis.lambda, 1.0F);
  EXPECT_FALSE(given.borderWidthPx);
  EXPECT_EQ(given.synthesis.prevWeight, 4.0F);  // the paper's
  EXPECT_EQ(given.synthesis.paintedVote.sigmaPx, 3.0F);
  const Options thesis = file.parsed({"--preset", "thesis"}).options;
  EXPECT_EQ(thesis.synthesis.lambda, 2.0F);
  EXPECT_EQ(thesis.borderWidthPx, 10.0F);
  const Options standard = file.parsed({"--preset", "standard", "--src-range", "5-6"}).options;
  EXPECT_EQ(shapingOptions(standard),
            shapingOptions(parse(complete({"--src-range", "5-6"})).options));
}

TEST(ConfigFile, FaultsAreNamedWithTheirLine) {
  const struct {
    const char* text;
    std::string fault;
  } cases[] = {
      {"\nborder-widht = 12\n",
       "line 2: border-widht: there is no such option; did you mean border-width?"},
      {"colour = 3", "line 1: colour: there is no such option; did you mean recolor?"},
      {"seed = 1\nseed = 2", "line 2: seed: is given before; wanted once"},
      {"lambda = much", "line 1: --lambda much: wanted a number in [0, 1000000]"},
      {"quiet = 1", "line 1: --quiet 1: wanted true or false"},
      {"preset = papre",
       "line 1: --preset papre: wanted standard, crisp, calm, thesis or paper; did you mean "
       "paper?"},
      {"resume = true", "line 1: resume: is for the command line, not for a config file"},
      {"config = a.toml", "line 1: config: is for the command line, not for a config file"},
      {"[look]\nseed = 1",
       "line 1: [look]: there are no sections; wanted a line such as border-width = 12 "
       "(files with layers are for fluidymation layers)"},
      {"seed", "line 1: no option is given by seed; wanted a line such as border-width = 12"},
      {"opt-iterations = [4,\n 3]",
       "line 1: opt-iterations: the value is missing or goes on in the next line; wanted a line "
       "such as border-width = 12"},
      {"dump-guides = my guides",
       "line 1: dump-guides my guides: wanted one value, in quotes where it has blanks"},
      {"seed = 1\nx\x01 = 2", "line 2: holds a control character; wanted a text file"},
      {"src-range = 1-4\nsrc-speed = 2", "--src-range, --src-speed: wanted one of them at most"},
  };
  for (const auto& c : cases) EXPECT_EQ(ConfigFile(c.text).fault(), c.fault);
}

TEST(ConfigFile, ThatCannotBeReadIsNamed) {
  EXPECT_EQ(messageOf<Error>([] {
              (void)parse({"--config", "/no/such.toml"});
            }),
            "/no/such.toml: cannot be opened (No such file or directory)");
  const ConfigFile large(std::string(2 << 20, '\n'));
  EXPECT_EQ(messageOf<Error>([&] { (void)large.parsed(); }),
            large.path() + ": is too large; wanted a config file");
  const ConfigFile json("{\"program\": \"other\"}");
  EXPECT_EQ(messageOf<Error>([&] { (void)json.parsed(); }),
            json.path() + ": is no manifest of fluidymation");
}

std::string printed(const Arguments& arguments) {
  Arguments all = arguments;
  all.emplace_back("--print-config");
  return parse(all).information.value_or("");
}

TEST(PrintConfig, GivesTheSameOptionsBack) {
  for (const Arguments& more :
       {Arguments{}, Arguments{"--preset", "paper", "--quiet", "--threads", "3"}}) {
    const ConfigFile file(printed(complete(more)));
    EXPECT_EQ(printed({"--config", file.path()}), printed(complete(more)));
  }
  for (const Reaching& o : reachingOptions()) {
    if (std::string(o.option) == "--render-frames") continue;
    const std::string text = printed(complete({o.option, o.value}));
    const ConfigFile file(text);
    EXPECT_TRUE(o.reached(file.parsed())) << o.option << "\n" << text;
    EXPECT_EQ(printed({"--config", file.path()}), text);
  }
}

TEST(PrintConfig, HoldsAllOptionsButThoseOfOneRun) {
  const std::set<std::string> ofOneRun = {"--config",    "--print-config",  "--resume",
                                          "--restart",   "--render-frames", "--verify",
                                          "--overwrite", "--skip-existing"};
  const std::string text = printed(kRequired);
  for (const Spec& spec : optionTable()) {
    const bool held = text.find("\n" + spec.name.substr(2) + " = ") != std::string::npos ||
                      text.find("\n# " + spec.name.substr(2) + " = ") != std::string::npos;
    EXPECT_NE(held, ofOneRun.count(spec.name) > 0) << spec.name;
  }
  EXPECT_NE(text.find("\nborder-width = \"size\"\n"), std::string::npos);
  EXPECT_NE(printed({}).find("\n# src-path = (required)\n"), std::string::npos);
}

TEST(PrintConfig, QuotesWhatItCanAndRefusesTheRest) {
  const std::string odd = "a \"b\" \\ #1,=[]/%d.png";
  Arguments arguments = kRequired;
  arguments[1] = odd;
  const ConfigFile file(printed(arguments));
  EXPECT_EQ(file.parsed().options.source.path, odd);
  arguments[1] = "it's \"b\"/%d.png";
  EXPECT_NE(messageOf<UsageError>([&] { (void)printed(arguments); }).find("both kinds of quotes"),
            std::string::npos);
}

TEST(Nearest, IsTheWordWithTheFewestSlips) {
  EXPECT_EQ(nearest("fluidd", {"solid", "fluid"}), "fluid");
  EXPECT_EQ(nearest("xyz", {"fluid", "abc"}), "");
  EXPECT_EQ(nearest("", {"on", "off"}), "");
  EXPECT_EQ(choiceText({"a", "b", "c"}), "a, b or c");
  EXPECT_EQ(choiceText({"a", "b"}), "a or b");
  EXPECT_EQ(choiceText({"a"}), "a");
}

TEST(Nearest, IsElseTheOneThatBeginsMostAlike) {
  const std::vector<std::string> names = {"--detail", "--detail-restoration", "--src-path"};
  EXPECT_EQ(nearest("--detail-restore", names), "--detail-restoration");
  EXPECT_EQ(nearest("--detail-resolution-of", names), "");
  EXPECT_EQ(nearest("--src-x", names), "");
}

}  // namespace
}  // namespace fluidymation::cli
