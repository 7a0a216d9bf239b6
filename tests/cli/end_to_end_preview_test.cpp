// --preview and `fluidymation preview`, run as users run them.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/io/png.h"
#include "support/png_maker.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

constexpr int kFrames = 6;
constexpr int kGapPx = 4;

std::size_t chunksOf(const Bytes& file, const std::string& name) {
  std::size_t count = 0;
  for (const PngChunk& chunk : splitPng(file)) count += chunk.name == name ? 1 : 0;
  return count;
}

/// Runs `fluidymation preview` in the scene's folder.
ProcessResult previewed(const SmallScene& scene, const ToolOptions& options) {
  ToolOptions all = SmallScene::defaults();
  for (const auto& [name, value] : options) all[name] = value;
  std::vector<std::string> arguments = argumentsOf(all);
  arguments.insert(arguments.begin(), "preview");
  ProcessSetup setup;
  setup.workingFolder = scene.file(".");
  return runProcess(FLUIDYMATION_PROGRAM, arguments, setup);
}

TEST(EndToEndPreview, ChangesNoFrameAndShowsThemAll) {
  const SmallScene scene(kFrames);
  const SmallScene::Painting plain = scene.painting();
  const ToolOptions withPreview = {{"--preview", "look/sheet.png"},
                                   {"--preview-background", "exemplar"},
                                   {"--preview-every", "2"}};
  EXPECT_EQ(scene.painting(withPreview), plain);
  // 4 and 2 frames of 28x22 in rows
  EXPECT_EQ(readPngSize(scene.file("look/sheet.png")),
            (Size{4 * (28 + kGapPx) - kGapPx, 2 * (22 + kGapPx) - kGapPx}));
  EXPECT_EQ(scene.names("look"), (std::vector<std::string>{"sheet.png"}));
}

TEST(EndToEndPreview, TheCommandShowsWhatIsPaintedOverAColor) {
  const SmallScene scene(kFrames);
  EXPECT_TRUE(failedWith(1, "--out-path out/%05d.png: no painted frame is there; paint some first",
                         previewed(scene, quietly({{"--preview", "film.apng"}}))));
  (void)scene.painting();
  const ProcessResult result =
      previewed(scene, {{"--preview", "film.apng"}, {"--preview-background", "#00ff00"}});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out, "film.apng: shows 6 frames\n");
  EXPECT_EQ(chunksOf(scene.read("film.apng"), "fcTL"), static_cast<std::size_t>(kFrames));

  const Image<Rgba> shown = readPng(scene.file("film.apng"));
  const Image<Rgba> painted = readPng(scene.file("out/00001.png"));
  ASSERT_EQ(shown.size(), painted.size());
  for (int y = 0; y < shown.height(); ++y) {
    for (int x = 0; x < shown.width(); ++x) {
      const Rgba wanted = painted(x, y).a == 0.0F ? Rgba{0.0F, 1.0F, 0.0F, 1.0F} : painted(x, y);
      EXPECT_EQ(toByte(shown(x, y).r), toByte(wanted.r));
      EXPECT_EQ(toByte(shown(x, y).g), toByte(wanted.g));
    }
  }
}

TEST(EndToEndPreview, ShowsOnlyTheFramesThatWereAskedFor) {
  const SmallScene scene(kFrames);
  (void)scene.painting();
  const ProcessResult result =
      previewed(scene, {{"--preview", "film.apng"}, {"--render-frames", "2-4"}});
  EXPECT_EQ(result.out, "film.apng: shows 3 frames\n");
}

TEST(EndToEndPreview, ARunThatGoesOnShowsTheEarlierFramesToo) {
  const SmallScene scene(kFrames);
  const ToolOptions part = {{"--render-frames", "1-3"}, {"--keep-states", ""}};
  EXPECT_EQ(scene.paint(quietly(part)).exitCode, 0);
  const ProcessResult result =
      scene.paint({{"--render-frames", "1-6"}, {"--resume", ""}, {"--preview", "film.apng"}});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_NE(result.err.find("preview: film.apng\n"), std::string::npos) << result.err;
  EXPECT_EQ(chunksOf(scene.read("film.apng"), "fcTL"), static_cast<std::size_t>(kFrames));
}

TEST(EndToEndPreview, FilmAndMasksStandBeside) {
  const SmallScene scene(2);
  (void)scene.painting({{"--preview", "sheet.png"}, {"--preview-beside", ""}});
  // Two cells of film (26x22, even), mask and frame
  EXPECT_EQ(readPngSize(scene.file("sheet.png")).height, 22);
  EXPECT_GT(readPngSize(scene.file("sheet.png")).width, 2 * (26 + 28 + 28));
}

TEST(EndToEndPreview, IsRefusedBeforeAnythingIsPainted) {
  const SmallScene scene;
  const auto refused = [&](const ToolOptions& options, const std::string& message) {
    EXPECT_TRUE(failedWith(2, message, scene.paint(quietly(options))));
    EXPECT_EQ(scene.names("out"), kNothing);
  };
  refused({{"--preview", "film.avi"}},
          "--preview film.avi: wanted a name that ends in .png (a sheet), .apng, .gif or .mp4");
  refused({{"--preview", "target/00001.png"}},
          "--preview target/00001.png: is an input and would be overwritten; choose another name");
  refused({{"--preview", "out/00009.png"}},
          "--preview out/00009.png: is the name of a painted frame; choose another one");
  refused({{"--preview-every", "3"}}, "--preview-every: wanted with --preview FILE only");
  ProcessSetup nowhere;
  nowhere.environment["PATH"] = scene.file("none");
  EXPECT_TRUE(failedNaming(2, "--preview film.mp4: is made by the program ffmpeg", {},
                           scene.paint(quietly({{"--preview", "film.mp4"}}), nowhere)));
}

TEST(EndToEndPreview, ANameThatIsTakenIsSeenBeforeAnythingIsPainted) {
  const SmallScene scene;
  std::filesystem::create_directories(scene.file("look/sheet.png"));
  EXPECT_TRUE(failedWith(1, "look/sheet.png: cannot be written (it is a folder)",
                         scene.paint(quietly({{"--preview", "look/sheet.png"}}))));
  EXPECT_EQ(scene.names("out"), kNothing);
}

}  // namespace
}  // namespace fluidymation::test
