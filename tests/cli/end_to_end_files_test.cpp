// What is in the files that the real program writes: bit depth, background, colour chunks.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "compositing/over.h"
#include "fluidymation/core/color.h"
#include "fluidymation/io/color_chunks.h"
#include "fluidymation/io/png.h"
#include "support/png_maker.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBitDepthByte = 24;
constexpr std::size_t kColorTypeByte = 25;
constexpr std::uint8_t kRgb = 2;
constexpr std::uint8_t kRgba = 6;

/// A picture that is another colour everywhere.
Image<Rgba8> wash(Size size) {
  Image<Rgba8> picture(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      picture(x, y) = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(9 * y), 90, 255};
    }
  }
  return picture;
}

TEST(EndToEndFiles, SixteenBitsRoundToTheEightBitFrames) {
  const SmallScene scene;
  ASSERT_EQ(scene.paint({{"--out-path", "narrow/%05d.png"}}).exitCode, 0);
  const SmallScene::Painting wide = scene.painting({{"--bit-depth", "16"}});
  int between = 0;
  for (const auto& [name, file] : wide) {
    ASSERT_EQ(file[kBitDepthByte], 16);
    const Image<Rgba> exact = readPng(scene.file("out/" + name));
    const Image<Rgba> narrow = readPng(scene.file("narrow/" + name));
    for (std::size_t i = 0; i < exact.pixelCount(); ++i) {
      const Rgba a = exact.data()[i];
      const Rgba b = narrow.data()[i];
      ASSERT_EQ(a.a, b.a) << "hard masks are 0 or 1";
      if (a.a == 0.0F) continue;
      // 8-bit values are the nearest, within what 16 bits cannot tell
      ASSERT_NEAR(255.0F * a.r, 255.0F * b.r, 0.502F);
      ASSERT_NEAR(255.0F * a.b, 255.0F * b.b, 0.502F);
      between += std::abs(a.g - b.g) > 1e-4F ? 1 : 0;
    }
  }
  EXPECT_GT(between, 100);
}

TEST(EndToEndFiles, ABackgroundIsWhatACompositorLaysUnder) {
  const SmallScene scene;
  writePng(scene.file("wash.png"), wash({28, 22}));
  ASSERT_EQ(scene.paint({{"--out-path", "bare/%05d.png"}}).exitCode, 0);
  const Image<Rgb> picture = readColor(scene.file("wash.png"));
  for (const char* depth : {"8", "16"}) {
    const SmallScene::Painting laid =
        scene.painting({{"--background", "wash.png"}, {"--bit-depth", depth}});
    for (const auto& [name, file] : laid) {
      ASSERT_EQ(file[kColorTypeByte], kRgb);
      const Image<Rgba> frame = readPng(scene.file("out/" + name));
      const Image<Rgb> wanted = composited(readPng(scene.file("bare/" + name)), picture);
      for (std::size_t i = 0; i < frame.pixelCount(); ++i) {
        ASSERT_NEAR(255.0F * frame.data()[i].r, 255.0F * wanted.data()[i].r, 0.502F);
        ASSERT_NEAR(255.0F * frame.data()[i].b, 255.0F * wanted.data()[i].b, 0.502F);
      }
    }
  }
}

TEST(EndToEndFiles, AColorAndTheFilmsOwnSurfaceAreBackgroundsToo) {
  const SmallScene scene;
  for (const char* background : {"#204060", "exemplar"}) {
    for (const auto& [name, file] : scene.painting({{"--background", background}})) {
      ASSERT_EQ(file[kColorTypeByte], kRgb);
    }
    const Rgba corner = readPng(scene.file("out/00001.png"))(0, 0);
    // The scene's paper is bright
    EXPECT_EQ(toByte(corner.g) == 0x40, background[0] == '#') << toByte(corner.g);
    EXPECT_EQ(corner.g > 0.7F, background[0] != '#') << toByte(corner.g);
  }
}

TEST(EndToEndFiles, ABackgroundThatIsNoneIsWrongUsage) {
  const SmallScene scene;
  EXPECT_TRUE(failedWith(2,
                         "--background none.png: no colour, and no file of that name; wanted "
                         "#RRGGBB, white, black, gray, a PNG file, or exemplar",
                         scene.paint(quietly({{"--background", "none.png"}}))));
  scene.write("text.png", bytesOf("not a picture"));
  EXPECT_TRUE(failedWith(1, "text.png: is no PNG file",
                         scene.paint(quietly({{"--background", "text.png"}}))));
  EXPECT_TRUE(
      failedWith(2, "--preview-background: not wanted with --background, whose frames are opaque",
                 scene.paint(quietly({{"--background", "white"},
                                      {"--preview", "p.png"},
                                      {"--preview-background", "black"}}))));
  EXPECT_EQ(scene.names("out"), std::vector<std::string>{});
}

TEST(EndToEndFiles, ABackgroundDoesNotTakeThePlaceOfRecords) {
  const SmallScene scene;
  for (const char* name : {"out/fluidymation.json", "out/.fluidymation/times.json"}) {
    std::filesystem::create_directories(std::filesystem::path(scene.file(name)).parent_path());
    writePng(scene.file(name), wash({28, 22}));
    const ProcessResult result = scene.paint(quietly({{"--background", scene.file(name)}}));
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find(std::string(name) + " is an input and has the place of what"),
              std::string::npos)
        << result.err;
    EXPECT_EQ(readColor(scene.file(name)).size(), (Size{28, 22}));
    scene.remove("out");
  }
}

TEST(EndToEndFiles, ABackgroundIsNotOverwritten) {
  const SmallScene scene;
  fs::create_directories(scene.file("out"));
  const Bytes picture = encodePng(wash({28, 22}));
  scene.write("out/00002.png", picture);
  EXPECT_TRUE(failedWith(
      2,
      "--out-path out/%05d.png: out/00002.png is an input and would be overwritten; choose "
      "another --out-path",
      scene.paint(quietly({{"--background", "out/00002.png"}, {"--overwrite", ""}}))));
  EXPECT_TRUE(failedWith(
      2, "--preview out/00002.png: is an input and would be overwritten; choose another name",
      scene.paint(quietly({{"--background", "out/00002.png"},
                           {"--out-path", "other/%05d.png"},
                           {"--preview", "out/00002.png"}}))));
  EXPECT_TRUE(scene.read("out/00002.png") == picture);
}

/// A part is painted, and its state stays for the rest; with another form it is refused.
TEST(EndToEndFiles, GoingOnWantsTheSameForm) {
  const SmallScene scene;
  writePng(scene.file("wash.png"), wash({28, 22}));
  const ToolOptions options = {{"--background", "wash.png"}, {"--render-frames", "1-2"}};
  ASSERT_EQ(scene.paint(options).exitCode, 0);
  ToolOptions goingOn = quietly({{"--background", "wash.png"}, {"--resume", ""}});
  const auto refusal = [&](const std::string& difference) {
    return "out/.fluidymation/state-2.bin: is the state of another run (" + difference +
           "); --restart discards it and begins anew";
  };
  const auto with = [&](const std::string& name, const std::string& value) {
    ToolOptions changed = goingOn;
    changed[name] = value;
    return scene.paint(changed);
  };
  EXPECT_TRUE(failedWith(1, refusal("--bit-depth was 8, now 16"), with("--bit-depth", "16")));
  EXPECT_TRUE(failedWith(
      1, refusal("--background was not given, now #ffffff; --background was given, now not"),
      with("--background", "white")));
  // Neither where it lies nor what it is called counts, but what it shows
  fs::copy(scene.file("wash.png"), scene.file("copy.png"));
  Image<Rgba8> other = wash({28, 22});
  other(3, 3).b = 91;
  writePng(scene.file("wash.png"), other);
  EXPECT_TRUE(failedWith(1, refusal("--background has changed"), scene.paint(goingOn)));
  EXPECT_EQ(with("--background", "copy.png").exitCode, 0);
  const SmallScene::Painting painted = filesOf(scene.file("out"));
  EXPECT_TRUE(painted == scene.painting({{"--background", "copy.png"}, {"--restart", ""}}));
}

TEST(EndToEndFiles, GoingOnTakesAColourByAnyOfItsNames) {
  const SmallScene scene;
  ASSERT_EQ(scene.paint({{"--background", "white"}, {"--render-frames", "1-2"}}).exitCode, 0);
  const ProcessResult result = scene.paint(quietly({{"--background", "#FFF"}, {"--resume", ""}}));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const SmallScene::Painting painted = filesOf(scene.file("out"));
  EXPECT_TRUE(painted == scene.painting({{"--background", "#ffffff"}, {"--restart", ""}}));
}

TEST(EndToEndFiles, AManifestPaintsTheSameFormAgain) {
  const SmallScene scene;
  writePng(scene.file("wash.png"), wash({28, 22}));
  for (const char* background : {"wash.png", "#345"}) {
    const SmallScene::Painting first =
        scene.painting({{"--background", background}, {"--bit-depth", "16"}});
    EXPECT_EQ(scene
                  .paintWithoutDefaults(quietly(
                      {{"--config", "out/fluidymation.json"}, {"--out-path", "again/%05d.png"}}))
                  .exitCode,
              0);
    EXPECT_TRUE(filesOf(scene.file("again")) == first) << background;
  }
}

/// The frame with these chunks behind its header.
void addChunks(const SmallScene& scene, int number, const std::vector<PngChunk>& chunks) {
  const std::string name = SmallScene::frame("src", number);
  std::vector<PngChunk> all = splitPng(scene.read(name));
  all.insert(all.begin() + 1, chunks.begin(), chunks.end());
  scene.write(name, joinPng(all));
}

const PngChunk kSrgbGamma{"gAMA", {0, 0, 0xB1, 0x8F}};  // 45455

TEST(EndToEndFiles, ColorChunksOfTheFirstFrameAreCarriedAlong) {
  const SmallScene scene;
  const SmallScene::Painting plain = scene.painting();
  for (int number = 1; number <= 4; ++number) addChunks(scene, number, {{"sRGB", {1}}, kSrgbGamma});
  const ProcessResult result = scene.paint({{"--overwrite", ""}});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err.find("the meaning of colours"), std::string::npos) << result.err;
  for (const auto& [name, file] : plain) {
    const ColorChunks chunks = readColorChunks(scene.file("out/" + name)).chunks;
    EXPECT_EQ(chunks.srgbIntent, 1);
    EXPECT_EQ(chunks.gamma, 45455);
    std::vector<PngChunk> painted = splitPng(scene.read("out/" + name));
    painted.erase(painted.begin() + 1, painted.begin() + 3);
    EXPECT_TRUE(joinPng(painted) == file) << "and nothing else changes";
  }
}

TEST(EndToEndFiles, TellsOfChunksThatDifferAndOfThoseThatAreBroken) {
  const SmallScene scene;
  addChunks(scene, 1, {kSrgbGamma, {"iCCP", {1, 2, 3}}});
  const ProcessResult result = scene.paint();
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.err.find("--src-path src/%05d.png: chunks of frame 1 are damaged, against each "
                            "other or not of RGB pictures (iCCP); the painted frames go without "
                            "them"),
            std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("--src-path src/%05d.png: frame 2 (none) and 2 more say other than "
                            "frame 1 (gAMA) about the meaning of colours; the painted frames say "
                            "as frame 1 does"),
            std::string::npos)
      << result.err;
  EXPECT_EQ(namesOf(readColorChunks(scene.file("out/00003.png")).chunks), "gAMA");
}

/// An exemplar of 16 bits is not cut to 8 on its way.
TEST(EndToEndFiles, SixteenBitsOfTheFilmAreRead) {
  const SmallScene scene;
  const SmallScene::Painting before = scene.painting({{"--bit-depth", "16"}});
  for (int number = 1; number <= 4; ++number) {
    const std::string path = scene.file(SmallScene::frame("src", number));
    const Image<Rgb> picture = readColor(path);
    Image<Rgba16> finer(picture.size());
    std::transform(picture.begin(), picture.end(), finer.begin(), [](Rgb c) {
      const auto lower = [](float v) {  // by a fifth of an 8-bit step
        return static_cast<std::uint16_t>(std::max(0L, std::lround(65535.0F * v) - 51));
      };
      return Rgba16{lower(c.r), lower(c.g), lower(c.b), 65535};
    });
    writeBytes(path, encodePng(finer));
  }
  const SmallScene::Painting after = scene.painting({{"--bit-depth", "16"}, {"--overwrite", ""}});
  EXPECT_TRUE(before != after);
}

TEST(EndToEndFiles, FramesAreTransparentUnlessTold) {
  const SmallScene scene;
  for (const auto& [name, file] : scene.painting()) {
    EXPECT_EQ(file[kBitDepthByte], 8);
    EXPECT_EQ(file[kColorTypeByte], kRgba);
    EXPECT_EQ(namesOf(readColorChunks(scene.file("out/" + name)).chunks), "none");
  }
}

}  // namespace
}  // namespace fluidymation::test
