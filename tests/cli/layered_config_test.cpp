// The file of `fluidymation layers`.

#include "cli/layered_config.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/layers_command.h"
#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation::cli {
namespace {

using test::messageOf;
using test::TemporaryFolder;

constexpr const char* kShared =
    "out-path = \"shot/%05d.png\"\n"
    "src-path = \"s/%d.png\"\n"
    "src-mask-path = \"m/%d.png\"\n"
    "target-path = \"t/%d.png\"\n";

class ShotFile {
 public:
  explicit ShotFile(const std::string& text) : path_(folder_.file("shot.toml")) {
    test::writeBytes(path_, test::bytesOf(text));
  }

  [[nodiscard]] ShotRequest shot(const CommandLine& told) const { return shotOf(path_, told); }
  [[nodiscard]] ShotRequest shot() const {
    static const CommandLine nothing;
    return shot(nothing);
  }

  /// With the file's name cut off.
  [[nodiscard]] std::string fault() const {
    const std::string message = messageOf<UsageError>([&] { (void)shot(); });
    return message.compare(0, path_.size() + 2, path_ + ": ") == 0
               ? message.substr(path_.size() + 2)
               : message;
  }

 private:
  TemporaryFolder folder_;
  std::string path_;
};

std::string faultOf(const std::string& text) { return ShotFile(kShared + text).fault(); }

TEST(LayeredConfig, GivesEachLayerWhatAllShareAndItsOwn) {
  const ShotRequest request = ShotFile(std::string(kShared) +
                                       "background = \"exemplar:cat\"  # of the upper film\n"
                                       "preset = \"thesis\"\n"
                                       "seed = 7\n"
                                       "[layer.horse]\n"
                                       "lambda = 3\n"
                                       "[layer.cat]   # above\n"
                                       "src-path = 'c/%d.png'\n"
                                       "seed = 8\n"
                                       "recolor = \"#ff0000\"\n")
                                  .shot();
  ASSERT_EQ(request.shot.layers.size(), 2U);
  const Options& horse = request.shot.layers[0].options;
  const Options& cat = request.shot.layers[1].options;
  EXPECT_EQ(request.shot.layers[0].name, "horse");
  EXPECT_EQ(request.shot.layers[1].name, "cat");
  EXPECT_EQ(request.shot.outPath, "shot/%05d.png");
  EXPECT_EQ(request.shot.background, "exemplar:cat");
  EXPECT_EQ(horse.outPath, "shot/layers/horse/%05d.png");
  EXPECT_EQ(cat.outPath, "shot/layers/cat/%05d.png");
  EXPECT_EQ(horse.source.path, "s/%d.png");
  EXPECT_EQ(cat.source.path, "c/%d.png");
  EXPECT_EQ(horse.synthesis.seed, 7U);
  EXPECT_EQ(cat.synthesis.seed, 8U);
  EXPECT_EQ(horse.synthesis.lambda, 3.0F);
  EXPECT_EQ(cat.synthesis.edgeGain, 1.0F) << "the shared preset";
  EXPECT_FALSE(horse.recolor);
  EXPECT_EQ(colorText(cat.recolor.value_or(Rgb8{})), "#ff0000");
}

TEST(LayeredConfig, TakesAPresetOfALayerBeforeItsOtherOptions) {
  const ShotRequest request =
      ShotFile(std::string(kShared) + "[layer.a]\nlambda = 9\npreset = \"thesis\"\n").shot();
  EXPECT_EQ(request.shot.layers[0].options.synthesis.lambda, 9.0F);
  EXPECT_EQ(request.shot.layers[0].options.synthesis.edgeGain, 1.0F);
}

TEST(LayeredConfig, LetsTheCommandLinePrevail) {
  CommandLine told;
  told.options.continuation.resume = true;
  told.options.continuation.existing = ExistingFrames::kReplace;
  told.options.threads = 3;
  told.options.maxMemoryBytes = 1 << 30;
  const std::string text = std::string(kShared) + "[layer.a]\nthreads = 2\n[layer.b]\n";
  const ShotRequest found = ShotFile(text).shot(told);
  for (const Layer& layer : found.shot.layers) {
    EXPECT_TRUE(layer.options.continuation.resume);
    EXPECT_EQ(layer.options.continuation.existing, ExistingFrames::kReplace);
    EXPECT_EQ(layer.options.maxMemoryBytes, 1 << 30);
  }
  EXPECT_EQ(found.shot.continuation.existing, ExistingFrames::kReplace);
  EXPECT_EQ(found.shot.layers[0].options.threads, 2) << "the machine's number gives way";
  EXPECT_EQ(found.shot.layers[1].options.threads, 3);
  told.threadsAreGiven = true;
  EXPECT_EQ(ShotFile(text).shot(told).shot.layers[0].options.threads, 3);
}

TEST(LayeredConfig, LetsTheCommandLinesProgressPrevailWhateverItIs) {
  const ShotFile file(std::string(kShared) + "progress = \"json\"\n[layer.a]\n");
  CommandLine told;
  EXPECT_EQ(file.shot(told).composite.progress, ProgressFormat::kJson);
  EXPECT_EQ(file.shot(told).lines[0].progress, ProgressFormat::kJson);
  told.progressIsGiven = true;
  EXPECT_EQ(file.shot(told).composite.progress, ProgressFormat::kHuman);
  EXPECT_EQ(file.shot(told).lines[0].progress, ProgressFormat::kHuman);
}

TEST(LayeredConfig, NamesTheLineOfWhatIsWrongInALayer) {
  EXPECT_EQ(faultOf("[layer.a]\n\nborder-with = 12\n"),
            "line 7: border-with: there is no such option; did you mean border-width?");
  EXPECT_EQ(faultOf("[layer.a]\nborder-width = wide\n").find("line 6: --border-width wide: wanted"),
            0U);
  EXPECT_EQ(faultOf("[layer.a]\nseed = 1\nseed = 2\n"),
            "line 7: seed: is given before; wanted once");
  EXPECT_EQ(faultOf("[layer.a]\nresume = true\n"),
            "line 6: resume: is for the command line, not for a config file");
}

TEST(LayeredConfig, RefusesTwoLayersOfOneName) {
  const std::string fault = faultOf("[layer.a]\n[layer.b]\n[layer.a]\n");
  EXPECT_EQ(fault.find("line 7: layer a: is there before, see "), 0U) << fault;
  EXPECT_NE(fault.find(": line 5; wanted another name"), std::string::npos) << fault;
}

TEST(LayeredConfig, RefusesSectionsThatAreNoLayers) {
  for (const char* section : {"[horse]", "[layer]", "[layer.]", "[layer.a/b]", "[layer...]",
                              "[layer.a b]", "[[layer.a]]", "[layer.a", "[]"}) {
    const std::string fault = faultOf(std::string(section) + "\n");
    EXPECT_EQ(fault.find("line 5: no layer is named by "), 0U) << fault;
    EXPECT_NE(fault.find("wanted [layer.NAME]"), std::string::npos) << fault;
  }
  EXPECT_EQ(faultOf("[layer." + std::string(65, 'a') + "]\n").find("line 5: "), 0U);
  EXPECT_EQ(faultOf("[layer." + std::string(64, 'a') + "]\n"), "");
}

TEST(LayeredConfig, WantsALayer) {
  EXPECT_EQ(faultOf("").find("there is no layer; wanted [layer.NAME]"), 0U) << faultOf("");
}

TEST(LayeredConfig, WantsEachOptionInItsPart) {
  EXPECT_EQ(faultOf("[layer.a]\nout-path = \"a/%d.png\"\n"),
            "line 6: out-path: is of the whole shot; wanted above the first layer");
  EXPECT_EQ(faultOf("[layer.a]\nbackground = \"white\"\n"),
            "line 6: background: is of the whole shot; wanted above the first layer");
  EXPECT_EQ(faultOf("dump-guides = \"d\"\n[layer.a]\n"),
            "line 5: dump-guides: layers cannot share it; wanted in a layer");
  EXPECT_EQ(faultOf("preview = \"p.png\"\n[layer.a]\n").find("line 5: preview: "), 0U);
}

TEST(LayeredConfig, LaysTheShotOverItsBackgroundAndNoLayer) {
  const ShotRequest request =
      ShotFile(std::string(kShared) + "background = \"#fff\"\n[layer.a]\n").shot();
  EXPECT_EQ(request.shot.background, "#fff");
  EXPECT_FALSE(request.shot.layers[0].options.background);
  EXPECT_FALSE(request.composite.options.background);
  EXPECT_FALSE(ShotFile(std::string(kShared) + "[layer.a]\n").shot().shot.background);
  EXPECT_EQ(faultOf("background = \"#fff\"\nbackground = \"#000\"\n[layer.a]\n"),
            "line 6: background: is given before; wanted once");
  EXPECT_EQ(faultOf("background = \"\"\n[layer.a]\n"),
            "line 5: --background with an empty value: wanted a colour, a file, exemplar or "
            "exemplar:NAME");
}

TEST(LayeredConfig, SaysWhatALayerLacks) {
  EXPECT_EQ(ShotFile("out-path = \"o/%d.png\"\nsrc-path = \"s/%d.png\"\n[layer.cat]\n").fault(),
            "layer cat: --src-mask-path, --target-path: required, but not given (see --help)");
  EXPECT_EQ(ShotFile("src-path = \"s/%d.png\"\n[layer.cat]\n").fault(),
            "out-path: required, but not given above the first layer");
}

}  // namespace
}  // namespace fluidymation::cli
