// The names and values that a manifest has of the options are what the command line takes.

#include "pipeline/option_texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "checkpoint/fingerprint.h"
#include "cli/command_line_arguments.h"
#include "cli/option_table.h"

namespace fluidymation::cli {
namespace {

Arguments argumentsFrom(const Options& options) {
  Arguments arguments;
  for (const OptionTexts& texts : {pathOptions(options), shapingOptions(options)}) {
    for (const auto& [name, value] : texts) arguments.push_back(name + "=" + value);
  }
  return arguments;
}

void expectComesBack(const Arguments& arguments) {
  const Options options = parse(arguments).options;
  const Options back = parse(argumentsFrom(options)).options;
  EXPECT_EQ(shapingOptions(back), shapingOptions(options));
  EXPECT_EQ(pathOptions(back), pathOptions(options));
}

TEST(OptionTexts, GiveTheSameOptionsOnTheCommandLine) {
  for (const char* preset : {"standard", "crisp", "calm", "thesis", "paper"}) {
    expectComesBack(complete({"--preset", preset}));
  }
  // Flow files say how things move, so that not all options go together.
  for (const Reaching& o : reachingOptions()) expectComesBack(complete({o.option, o.value}));
}

TEST(OptionTexts, AreNoMoreThanAStateCanHave) { EXPECT_LE(optionTable().size(), kMostOptions); }

TEST(OptionTexts, NameThePresetWhoseRulesApply) {
  for (const char* preset : {"standard", "thesis", "paper"}) {
    for (const Arguments& more : {Arguments{}, Arguments{"--prev-modulation-bounds", "9,3"}}) {
      Arguments arguments = {"--preset", preset};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const OptionTexts texts = shapingOptions(parse(complete(arguments)).options);
      ASSERT_EQ(texts.front().first, "--preset");
      EXPECT_EQ(texts.front().second, preset);
    }
  }
}

/// Options that change no byte of a frame, and those that stand for several others.
const std::set<std::string> kNotShaping = {
    "--dump-guides",   "--resume",        "--restart", "--checkpoint-every",
    "--keep-states",   "--verify",        "--preview", "--preview-background",
    "--preview-every", "--render-frames", "--threads", "--progress",
    "--quiet",         "--max-memory"};

TEST(OptionTexts, AnswerToEveryOptionThatShapesThePicture) {
  for (const Reaching& o : reachingOptions()) {
    if (kNotShaping.count(o.option) > 0 || o.value == std::string("auto")) continue;
    const Options with = parse(complete({o.option, o.value})).options;
    const Options without = parse(kRequired).options;
    Options withFlow = with;  // the flow's convention counts only where there is flow
    Options withoutFlow = without;
    if (std::string(o.option) == "--flow-convention") {
      withFlow.sourceFlowPath = withoutFlow.sourceFlowPath = "f/%d.flo";
    }
    EXPECT_TRUE(shapingOptions(withFlow) != shapingOptions(withoutFlow) ||
                pathOptions(withFlow) != pathOptions(withoutFlow))
        << o.option << ": a state would be gone on from although this option is another";
  }
}

TEST(OptionTexts, TellAMixtureThatNoPresetHas) {
  Options options = parse(complete({"--preset", "paper"})).options;
  options.synthesis.edgeGain = 2.0F;
  EXPECT_EQ(shapingOptions(options).front().second,
            "edge gain 2, gain of the previous frame 1, vote depth sigma 0, modulation unclamped, "
            "bounds 0.1,0.01 target sides");
}

}  // namespace
}  // namespace fluidymation::cli
