// Bad and unusual input files, given to the real program.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <functional>

#include "support/png_maker.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kInputs = {"src", "mask", "target"};
constexpr std::int64_t kModestBytes = 400'000'000;  // with a sanitizer's share

/// As `refusal`, by an ordinary user.
ProcessResult refusalOfOthers(const SmallScene& scene) {
  ProcessResult result = scene.paintUnprivileged({{"--quiet", ""}});
  EXPECT_EQ(scene.names("out"), kNothing);
  return result;
}

/// Runs the tool, which has to refuse before it paints anything.
ProcessResult refusal(const SmallScene& scene, const ToolOptions& options = {}) {
  ProcessResult result = scene.paint(quietly(options));
  EXPECT_EQ(scene.names("out"), kNothing);
  return result;
}

TEST(EndToEndInput, PatternsThatAreNoFrameNumbersAreWrongUsage) {
  const SmallScene scene(1);
  for (const char* option : {"--src-path", "--src-mask-path", "--target-path", "--out-path"}) {
    for (const char* pattern :
         {"a.png", "%d-%d.png", "%s.png", "%n.png", "%99999999d.png", "%", "%5.3d.png", "%*d.png",
          "%ld.png", "%x.png", "%1$d.png", "%d%", "%%d.png", "%d/1.png"}) {
      const std::string prefix = std::string(option) + ": " + pattern + ": ";
      EXPECT_TRUE(failedNaming(
          2, prefix, {"; wanted a path with exactly one frame number, e.g. frames/%05d.png"},
          refusal(scene, {{option, pattern}})));
    }
  }
  EXPECT_FALSE(fs::exists(scene.file("out")));
}

TEST(EndToEndInput, MissingFilesAreNamedWithWhatWasAskedFor) {
  for (const std::string& input : kInputs) {
    const SmallScene scene;
    scene.remove(input);
    EXPECT_TRUE(failedWith(1,
                           input +
                               "/00001.png: cannot be opened (No such file or directory); frames "
                               "1 to 50 in steps of 1 were asked for",
                           refusal(scene)));
    EXPECT_FALSE(fs::exists(scene.file("out")));
  }
  const SmallScene scene;
  EXPECT_TRUE(failedWith(
      1,
      "target/00007.png: cannot be opened (No such file or directory); frames 7 to 9 in "
      "steps of 2 were asked for; files of this pattern are numbered 1 to 4 "
      "(--target-start)",
      refusal(scene,
              {{"--target-start", "7"}, {"--target-speed", "2"}, {"--target-frames", "2"}})));
}

TEST(EndToEndInput, UnreadableFilesAreNamed) {
  for (const std::string& input : kInputs) {
    const SmallScene scene;
    fs::permissions(scene.file(SmallScene::frame(input, 3)), fs::perms::none);
    EXPECT_TRUE(failedWith(1, input + "/00003.png: cannot be opened (Permission denied)",
                           refusalOfOthers(scene)));
    EXPECT_FALSE(fs::exists(scene.file("out")));
  }
}

TEST(EndToEndInput, UnreadableFoldersAreNamed) {
  for (const std::string& input : kInputs) {
    const SmallScene scene;
    fs::permissions(scene.file(input), fs::perms::none);
    const ProcessResult result = refusalOfOthers(scene);
    fs::permissions(scene.file(input), fs::perms::owner_all);
    EXPECT_TRUE(
        failedNaming(1, input + "/00001.png: cannot be opened (Permission denied)", {}, result));
  }
}

/// A way to spoil a file, and what the tool says about the result after the file's name.
struct Damage {
  const char* complaint;
  std::function<Bytes(Bytes)> spoil;
};

Bytes withoutChunk(const Bytes& file, const std::string& name) {
  std::vector<PngChunk> kept;
  for (const PngChunk& chunk : splitPng(file)) {
    if (chunk.name != name) kept.push_back(chunk);
  }
  return joinPng(kept);
}

std::vector<Damage> damages() {
  const auto cutTo = [](std::size_t bytes) {
    return [bytes](Bytes file) {
      file.resize(bytes);
      return file;
    };
  };
  const auto flipAt = [](std::size_t fromEnd) {
    return [fromEnd](Bytes file) {
      file.at(file.size() - fromEnd) ^= 0x55U;
      return file;
    };
  };
  return {
      {"is empty; wanted a PNG file", cutTo(0)},
      {"damaged PNG file (it ends within the header)", cutTo(20)},
      {"damaged PNG file (it ends too early)", cutTo(60)},
      {"damaged PNG file (it ends too early)",
       [](Bytes file) {
         file.resize(file.size() - 12);  // without its last chunk, IEND
         return file;
       }},
      {"damaged PNG file (IDAT: CRC error)", flipAt(14)},
      {"damaged PNG file (", flipAt(24)},
      {"damaged PNG file (", [](const Bytes& file) { return withoutChunk(file, "IDAT"); }},
      {"damaged PNG file (its header is corrupt)",
       [](Bytes file) {
         file.at(18) ^= 0x01U;  // the width, which the check sum protects
         return file;
       }},
      {"is no PNG file", [](const Bytes&) { return bytesOf("P6 24 20 255 and some pixels"); }},
      {"is no PNG file", [](const Bytes&) { return Bytes{0xFF, 0xD8, 0xFF, 0xE0, 0, 16}; }},
      {"is no PNG file",
       [](Bytes file) {
         file.at(0) = 'x';
         return file;
       }},
  };
}

TEST(EndToEndInput, DamagedFilesAreNamedBeforeAnythingIsPainted) {
  for (const std::string& input : kInputs) {
    for (const Damage& damage : damages()) {
      const SmallScene scene;
      const std::string name = SmallScene::frame(input, 4);
      scene.write(name, damage.spoil(scene.read(name)));
      EXPECT_TRUE(failedNaming(1, name + ": " + damage.complaint, {}, refusal(scene)));
    }
  }
}

TEST(EndToEndInput, WhatIsNoFileIsNamedAndNeverWaitedFor) {
  for (const std::string& input : kInputs) {
    const SmallScene scene;
    const std::string name = SmallScene::frame(input, 2);
    scene.remove(name);
    fs::create_directory(scene.file(name));
    EXPECT_TRUE(failedNaming(1, name + ": is a folder", {}, refusal(scene)));
    scene.remove(name);
    ASSERT_EQ(mkfifo(scene.file(name).c_str(), 0600), 0);
    EXPECT_TRUE(failedNaming(1, name + ": is no regular file", {}, refusal(scene)));
    scene.remove(name);
    fs::create_symlink("nowhere.png", scene.file(name));
    EXPECT_TRUE(failedNaming(1, name + ": cannot be opened (No such file or directory)", {},
                             refusal(scene)));
  }
}

TEST(EndToEndInput, AllHolesAreListed) {
  const std::vector<std::string> options = {"--src-path", "--src-mask-path", "--target-path"};
  for (std::size_t i = 0; i < kInputs.size(); ++i) {
    const SmallScene scene(9);
    for (const int number : {2, 3, 4, 6, 8}) scene.remove(SmallScene::frame(kInputs[i], number));
    EXPECT_TRUE(failedWith(1,
                           options[i] + " " + kInputs[i] +
                               "/%05d.png: 5 frames are missing although later ones exist: 2-4, 6, "
                               "8; frames 1 to 50 in steps of 1 were asked for",
                           refusal(scene)));
    EXPECT_FALSE(fs::exists(scene.file("out")));
  }
}

TEST(EndToEndInput, FramesOfOneSequenceHaveOneSize) {
  for (const std::string& input : kInputs) {
    const SmallScene scene;
    const Mask other(Size{13, 11}, 1);
    scene.write(SmallScene::frame(input, 3), maskPng(other));
    EXPECT_TRUE(failedNaming(1, input + "/00003.png: size 13x11, but " + input + "/00001.png is ",
                             {"; all frames of a sequence must have one size"}, refusal(scene)));
    EXPECT_FALSE(fs::exists(scene.file("out")));
  }
}

TEST(EndToEndInput, AnExemplarAndItsMasksAgreeInSizeAndNumber) {
  const SmallScene scene(3);
  scene.write("mask/00004.png", maskPng(scene.sourceMask(3)));
  EXPECT_TRUE(failedWith(1,
                         "--src-mask-path mask/%05d.png: 4 frames, but --src-path src/%05d.png has "
                         "3; an exemplar and its masks must agree",
                         refusal(scene)));
  scene.remove("mask/00004.png");
  scene.remove("mask/00003.png");
  EXPECT_TRUE(failedWith(1,
                         "--src-mask-path mask/%05d.png: 2 frames, but --src-path src/%05d.png has "
                         "3; an exemplar and its masks must agree",
                         refusal(scene)));
  for (int number = 1; number <= 3; ++number) {
    scene.write(SmallScene::frame("mask", number), maskPng(Mask(Size{20, 24}, 1)));
  }
  EXPECT_TRUE(failedWith(1,
                         "mask/00001.png: size 20x24, but src/00001.png is 24x20; an exemplar and "
                         "its masks must agree",
                         refusal(scene)));
  EXPECT_FALSE(fs::exists(scene.file("out")));
}

TEST(EndToEndInput, GiganticHeadersAreRefusedAtOnce) {
  struct Claim {
    std::uint32_t width;
    std::uint32_t height;
    const char* complaint;
  };
  const std::vector<Claim> claims = {
      {0x7FFFFFFFU, 0x7FFFFFFFU, "claims 2147483647x2147483647 pixels; wanted at most 16384"},
      {0xFFFFFFFFU, 0xFFFFFFFFU, "claims 4294967295x4294967295 pixels; wanted at most 16384"},
      {16385, 1, "claims 16385x1 pixels; wanted at most 16384 a side"},
      {16384, 16384, "claims 16384x16384 pixels; wanted at most 16384 a side and 120 million"},
      {0, 5, "damaged PNG file (it claims 0x5 pixels)"},
      {10000, 10000, "damaged PNG file (its "},  // within the limits, but the file is tiny
  };
  for (const std::string& input : kInputs) {
    for (const Claim& claim : claims) {
      const SmallScene scene(1);
      const Bytes file = joinPng({{"IHDR", pngHeader(claim.width, claim.height, 8, 6)},
                                  {"IDAT", deflatedZeros(1000)},
                                  {"IEND", {}}});
      // An exemplar and masks of one size, or that alone would be reason enough.
      const std::vector<std::string> faulty = input == "target"
                                                  ? std::vector<std::string>{input}
                                                  : std::vector<std::string>{"src", "mask"};
      for (const std::string& name : faulty) scene.write(SmallScene::frame(name, 1), file);
      const ProcessResult result = refusal(scene);
      EXPECT_EQ(result.exitCode, 1);
      for (const std::string& name : faulty) {
        const std::string wanted =
            "fluidymation: error: " + SmallScene::frame(name, 1) + ": " + claim.complaint;
        EXPECT_NE(result.err.find(wanted), std::string::npos) << wanted << "\n" << result.err;
      }
      EXPECT_LT(result.peakBytes, kModestBytes) << input << " " << claim.complaint;
      EXPECT_LT(result.seconds, 20.0) << input << " " << claim.complaint;
    }
  }
}

TEST(EndToEndInput, MasksThatAreAllEmptyMakeNoExemplar) {
  const SmallScene scene(2);
  for (int number = 1; number <= 2; ++number) {
    scene.write(SmallScene::frame("mask", number), maskPng(Mask(Size{24, 20})));
  }
  EXPECT_TRUE(failedWith(1,
                         "--src-mask-path mask/%05d.png: all 2 masks are empty after smoothing "
                         "with --blur-sigma 1, given, found or set by --preset; wanted some "
                         "material, so check the masks or lower --blur-sigma",
                         refusal(scene)));
}

TEST(EndToEndInput, AnExemplarMayBeEmptyInSomeFrames) {
  const SmallScene scene(4);
  for (const int number : {1, 3}) {
    scene.write(SmallScene::frame("mask", number), maskPng(Mask(Size{24, 20})));
  }
  EXPECT_EQ(scene.painting().size(), 4U);
}

// ---------------------------------------------------------------------------------------------
// Every kind of PNG

struct Kind {
  PngColor color;
  int bitDepth;
};

const std::vector<Kind> kKinds = {
    {PngColor::kGray, 1},       {PngColor::kGray, 2},    {PngColor::kGray, 4},
    {PngColor::kGray, 8},       {PngColor::kGray, 16},   {PngColor::kPalette, 1},
    {PngColor::kPalette, 2},    {PngColor::kPalette, 4}, {PngColor::kPalette, 8},
    {PngColor::kRgb, 8},        {PngColor::kRgb, 16},    {PngColor::kGrayAlpha, 8},
    {PngColor::kGrayAlpha, 16}, {PngColor::kRgba, 8},    {PngColor::kRgba, 16},
};

/// White inside the mask and black outside, opaque, as a file of this kind.
Bytes blackAndWhite(const Mask& mask, const Kind& kind, bool interlaced) {
  PngSpec spec;
  spec.size = mask.size();
  spec.color = kind.color;
  spec.bitDepth = kind.bitDepth;
  spec.interlaced = interlaced;
  const bool palette = kind.color == PngColor::kPalette;
  if (palette) spec.palette = {{0, 0, 0}, {255, 255, 255}};
  const bool alpha = kind.color == PngColor::kGrayAlpha || kind.color == PngColor::kRgba;
  const auto largest = static_cast<std::uint16_t>((1U << static_cast<unsigned>(kind.bitDepth)) - 1);
  const std::uint16_t white = palette ? 1 : largest;
  const int colors = channelsOf(kind.color) - (alpha ? 1 : 0);
  for (const std::uint8_t inside : mask) {
    for (int c = 0; c < colors; ++c) spec.samples.push_back(inside != 0 ? white : 0);
    if (alpha) spec.samples.push_back(largest);
  }
  return makePng(spec);
}

TEST(EndToEndInput, EveryKindOfPngMeansTheSame) {
  const int frames = 2;
  for (const std::string& input : kInputs) {
    const SmallScene scene(frames);
    // A black and white picture: the one thing that all kinds can say.
    const auto picture = [&](int number) {
      if (input == "mask") return scene.sourceMask(number);
      if (input == "target") return scene.targetMask(number);
      return randomBlobs(Size{24, 20}, 5 + static_cast<std::uint64_t>(number));
    };
    const auto paintedFrom = [&](const Kind& kind, bool interlaced) {
      for (int number = 1; number <= frames; ++number) {
        scene.write(SmallScene::frame(input, number),
                    blackAndWhite(picture(number), kind, interlaced));
      }
      return scene.painting({{"--src-frames", "2"}, {"--target-frames", "2"}});
    };
    const SmallScene::Painting expected = paintedFrom({PngColor::kRgb, 8}, false);
    ASSERT_EQ(expected.size(), 2U);
    for (const Kind& kind : kKinds) {
      for (const bool interlaced : {false, true}) {
        EXPECT_TRUE(paintedFrom(kind, interlaced) == expected)
            << input << ": colour type " << static_cast<int>(kind.color) << ", " << kind.bitDepth
            << " bit" << (interlaced ? ", interlaced" : "");
      }
    }
  }
}

/// A mask held by the alpha of an image whose colour says the opposite.
Bytes alphaMask(const Mask& mask, PngColor color, int bitDepth) {
  PngSpec spec;
  spec.size = mask.size();
  spec.color = color;
  spec.bitDepth = bitDepth;
  const auto largest = static_cast<std::uint16_t>((1U << static_cast<unsigned>(bitDepth)) - 1);
  for (const std::uint8_t inside : mask) {
    for (int c = 0; c + 1 < channelsOf(color); ++c) {
      spec.samples.push_back(inside != 0 ? 0 : largest);
    }
    spec.samples.push_back(inside != 0 ? largest : 0);
  }
  return makePng(spec);
}

TEST(EndToEndInput, AMaskWithAlphaIsItsAlpha) {
  const SmallScene scene(1);
  const SmallScene::Painting expected =
      scene.painting({{"--src-frames", "1"}, {"--target-frames", "1"}});
  for (const std::string input : {"mask", "target"}) {
    const Bytes original = scene.read(SmallScene::frame(input, 1));
    const Mask mask = input == "mask" ? scene.sourceMask(1) : scene.targetMask(1);
    for (const Kind& kind : {Kind{PngColor::kGrayAlpha, 8}, Kind{PngColor::kGrayAlpha, 16},
                             Kind{PngColor::kRgba, 8}, Kind{PngColor::kRgba, 16}}) {
      scene.write(SmallScene::frame(input, 1), alphaMask(mask, kind.color, kind.bitDepth));
      EXPECT_TRUE(scene.painting({{"--src-frames", "1"}, {"--target-frames", "1"}}) == expected)
          << input;
    }
    // Transparency that a palette or a single colour declares is alpha too.
    PngSpec palette;
    palette.size = mask.size();
    palette.color = PngColor::kPalette;
    palette.palette = {{200, 200, 200}, {10, 10, 10}};
    palette.paletteAlpha = {0, 255};
    PngSpec keyed;
    keyed.size = mask.size();
    keyed.transparent = {{77, 77, 77}};
    for (const std::uint8_t inside : mask) {
      palette.samples.push_back(inside);
      keyed.samples.push_back(inside != 0 ? 3 : 77);
    }
    for (const PngSpec& spec : {palette, keyed}) {
      scene.write(SmallScene::frame(input, 1), makePng(spec));
      EXPECT_TRUE(scene.painting({{"--src-frames", "1"}, {"--target-frames", "1"}}) == expected)
          << input;
    }
    scene.write(SmallScene::frame(input, 1), original);
  }
}

TEST(EndToEndInput, OneFrameWithAlphaMakesItAlphaForTheSequence) {
  const SmallScene scene(3);
  const Mask full(scene.targetMask(1).size(), 1);
  scene.write(SmallScene::frame("target", 2), maskPng(full));
  const SmallScene::Painting expected = scene.painting();
  // Black shapes; the second covers its frame wholly, so that nothing of it is transparent.
  for (const int number : {1, 2, 3}) {
    scene.write(
        SmallScene::frame("target", number),
        alphaMask(number == 2 ? full.clone() : scene.targetMask(number), PngColor::kRgba, 8));
  }
  EXPECT_TRUE(scene.painting() == expected);
  // Some tools then leave the alpha channel out.
  PngSpec black;
  black.size = full.size();
  black.samples.assign(full.pixelCount(), 0);
  scene.write(SmallScene::frame("target", 2), makePng(black));
  EXPECT_TRUE(scene.painting() == expected);
  // Nor does it matter which frame it is.
  const ToolOptions fromTheSecond = {{"--target-start", "2"}, {"--target-frames", "2"}};
  const SmallScene::Painting black23 = scene.painting(fromTheSecond);
  scene.write(SmallScene::frame("target", 2), maskPng(full));
  scene.write(SmallScene::frame("target", 3), maskPng(scene.targetMask(3)));
  EXPECT_TRUE(scene.painting(fromTheSecond) == black23);
}

TEST(EndToEndInput, TheAlphaOfAnExemplarIsIgnored) {
  const SmallScene scene(1);
  const ToolOptions one = {{"--src-frames", "1"}, {"--target-frames", "1"}};
  const SmallScene::Painting expected = scene.painting(one);
  const Image<Rgba> picture = readPng(scene.file("src/00001.png"));
  PngSpec spec;
  spec.size = picture.size();
  spec.color = PngColor::kRgba;
  for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
    const Rgba& p = picture.data()[i];
    for (const float c : {p.r, p.g, p.b}) {
      spec.samples.push_back(static_cast<std::uint16_t>(255.0F * c + 0.5F));
    }
    spec.samples.push_back(static_cast<std::uint16_t>(i * 7 % 256));
  }
  scene.write("src/00001.png", makePng(spec));
  EXPECT_TRUE(scene.painting(one) == expected);
}

}  // namespace
}  // namespace fluidymation::test
