// Painted frames are made up here, so that every pixel of a composited one is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint/manifest.h"
#include "fluidymation/core/error.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/layers.h"
#include "fluidymation/verify.h"
#include "support/small_scene.h"

namespace fluidymation {
namespace {

using test::messageOf;
using test::SmallScene;

constexpr Size kSize{28, 22};  // of the small scene's targets
constexpr Rgba8 kRed{230, 20, 40, 255};
constexpr Rgba8 kVeil{10, 60, 200, 128};

/// A small scene with two layers of two frames each: "low" is red in its left half, "high" has a
/// blue veil over its upper half.
class Layers : public ::testing::Test {
 protected:
  static constexpr int kFrames = 2;

  Layers() : scene_(kFrames) {
    shot_.outPath = scene_.file("shot/%05d.png");
    for (const char* name : {"low", "high"}) shot_.layers.push_back({name, optionsFor(name)});
    for (int number = 1; number <= kFrames; ++number) {
      paint("low", number, [](int x, int) { return x < kSize.width / 2 ? kRed : Rgba8{}; });
      paint("high", number, [](int, int y) { return y < kSize.height / 2 ? kVeil : Rgba8{}; });
    }
  }

  [[nodiscard]] Options optionsFor(const std::string& name) const {
    Options options;
    options.source.path = scene_.file("src/%05d.png");
    options.sourceMaskPath = scene_.file("mask/%05d.png");
    options.target.path = scene_.file("target/%05d.png");
    options.outPath = scene_.file("shot/layers/" + name + "/%05d.png");
    return options;
  }

  template <typename Color>
  void paint(const std::string& layer, int number, const Color& color) const {
    Image<Rgba8> frame(kSize);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) frame(x, y) = color(x, y);
    }
    std::filesystem::create_directories(scene_.file("shot/layers/" + layer));
    writePng(scene_.file(SmallScene::frame("shot/layers/" + layer, number)), frame);
  }

  [[nodiscard]] Rgba pixel(int x, int y, int number = 1) const {
    return readPng(scene_.file(SmallScene::frame("shot", number)))(x, y);
  }

  /// What the shot has to be told of.
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    Observer observer;
    observer.note = [&](const std::string& text) { notes.push_back(text); };
    checkLayers(shot_, observer);
    return notes;
  }

  SmallScene scene_;
  LayeredShot shot_;
};

void expectPixel(Rgba found, Rgba8 expected) {
  EXPECT_EQ(toByte(found.r), expected.r);
  EXPECT_EQ(toByte(found.g), expected.g);
  EXPECT_EQ(toByte(found.b), expected.b);
  EXPECT_EQ(toByte(found.a), expected.a);
}

/// Of 255 levels: a veil of 128 over an opaque one.
std::uint8_t veiled(int veil, int under) {
  const double alpha = 128.0 / 255.0;
  return static_cast<std::uint8_t>(std::lround(alpha * veil + (1.0 - alpha) * under));
}

TEST_F(Layers, LieOverEachOtherAndStayTransparentElsewhere) {
  compositeLayers(shot_, {});
  for (int number = 1; number <= kFrames; ++number) {
    expectPixel(pixel(0, 0, number),
                {veiled(10, 230), veiled(60, 20), veiled(200, 40), 255});  // both
    expectPixel(pixel(0, kSize.height - 1, number), kRed);
    expectPixel(pixel(kSize.width - 1, 0, number), kVeil);
    expectPixel(pixel(kSize.width - 1, kSize.height - 1, number), {0, 0, 0, 0});
  }
}

TEST_F(Layers, GoOnInColourPastTheirEdgesWhereTheyStayTransparent) {
  constexpr int kMargin = 4;
  const int right = kSize.width / 2 + kMargin;  // red ends there, and the veil above
  const int bottom = kSize.height - 1;
  for (const BitDepth depth : {BitDepth::k8, BitDepth::k16}) {
    shot_.bitDepth = depth;
    compositeLayers(shot_, {});
    for (int x = kSize.width / 2; x < right; ++x) {
      expectPixel(pixel(x, bottom), {kRed.r, kRed.g, kRed.b, 0});
    }
    expectPixel(pixel(right, bottom), {0, 0, 0, 0});
    const int below = kSize.height / 2 + kMargin;
    expectPixel(pixel(kSize.width - 1, below - 1), {kVeil.r, kVeil.g, kVeil.b, 0});
    expectPixel(pixel(kSize.width - 1, below), {0, 0, 0, 0});
  }
}

TEST_F(Layers, LieInTheirOrder) {
  std::swap(shot_.layers[0], shot_.layers[1]);
  compositeLayers(shot_, {});
  expectPixel(pixel(0, 0), kRed);
}

TEST_F(Layers, LieOverAColour) {
  shot_.background = "#80c020";
  compositeLayers(shot_, {});
  expectPixel(pixel(0, 0), {veiled(10, 230), veiled(60, 20), veiled(200, 40), 255});
  expectPixel(pixel(kSize.width - 1, 0),
              {veiled(10, 0x80), veiled(60, 0xc0), veiled(200, 0x20), 255});
  expectPixel(pixel(kSize.width - 1, kSize.height - 1), {0x80, 0xc0, 0x20, 255});
}

TEST_F(Layers, RoundOnceWhereChannelsHave16Bits) {
  shot_.bitDepth = BitDepth::k16;
  compositeLayers(shot_, {});
  constexpr float kHalfStep = 0.5F / 65535.0F;
  const float veil = 128.0F / 255.0F;
  EXPECT_NEAR(pixel(0, 0).r, veil * (10.0F / 255.0F) + (1.0F - veil) * (230.0F / 255.0F),
              1.1F * kHalfStep);
  EXPECT_NEAR(pixel(kSize.width - 1, 0).a, veil, 1e-6F);
}

TEST_F(Layers, SayOfColoursWhatTheLowestDoes) {
  const std::string frame = scene_.file(SmallScene::frame("shot/layers/low", 1));
  Image<Rgba8> red(kSize, kRed);
  PngContent content;
  content.color.srgbIntent = 1;
  test::writeBytes(frame, encodePng(red, 1, content));
  std::vector<std::string> notes;
  Observer observer;
  observer.note = [&](const std::string& text) { notes.push_back(text); };
  compositeLayers(shot_, observer);
  EXPECT_EQ(readColorChunks(scene_.file(SmallScene::frame("shot", 1))).chunks.srgbIntent, 1);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes.front().find("layer high: its frames (none) say other than those of layer low"),
            0U)
      << notes.front();
}

TEST_F(Layers, LieOverTheBareSurfaceOfAFilm) {
  for (const char* background : {"exemplar", "exemplar:high"}) {
    shot_.background = background;
    compositeLayers(shot_, {});
    expectPixel(pixel(kSize.width - 1, kSize.height - 1), {240, 236, 225, 255});
  }
  shot_.background = "exemplar:middle";
  EXPECT_EQ(messageOf<UsageError>([&] { checkLayers(shot_, {}); }),
            "--background exemplar:middle: there is no such layer; wanted exemplar:NAME with one "
            "of low, high");
}

TEST_F(Layers, MeetByTheirNumbersAndMayEndEarlier) {
  shot_.layers[1].options.target.frames = 1;
  EXPECT_EQ(notes(),
            std::vector<std::string>{
                "layer high: frames 1 of the shot's 1 to 2; it is not seen in the others"});
  compositeLayers(shot_, {});
  expectPixel(pixel(0, 0, 1), {veiled(10, 230), veiled(60, 20), veiled(200, 40), 255});
  expectPixel(pixel(0, 0, 2), kRed);
}

TEST_F(Layers, LeaveAManifestThatKnowsTheFrames) {
  shot_.background = "white";
  compositeLayers(shot_, {});
  const std::string manifest = scene_.file("shot/fluidymation.json");
  const Verification whole = verify(manifest, [] {});
  EXPECT_TRUE(whole.faults.empty());
  EXPECT_EQ(whole.frames, kFrames);
  scene_.write(SmallScene::frame("shot", 2), scene_.read(SmallScene::frame("target", 2)));
  EXPECT_EQ(verify(manifest, [] {}).faults.size(), 1U);
}

TEST_F(Layers, ReplaceTheirOwnFramesAndNobodyElses) {
  compositeLayers(shot_, {});
  compositeLayers(shot_, {});
  scene_.write(SmallScene::frame("shot", 2), scene_.read(SmallScene::frame("target", 2)));
  EXPECT_NE(messageOf<Error>([&] { compositeLayers(shot_, {}); }).find("is there already"),
            std::string::npos);
  shot_.continuation.existing = ExistingFrames::kReplace;
  compositeLayers(shot_, {});
  expectPixel(pixel(kSize.width - 1, 0, 2), kVeil);
}

TEST_F(Layers, TakeFramesOfTheirSizeOnly) {
  shot_.layers[1].options.target.scale = 2.0;
  const std::string fault = messageOf<Error>([&] { checkLayers(shot_, {}); });
  EXPECT_EQ(fault.find("layer high: --target-path "), 0U) << fault;
  EXPECT_NE(fault.find("frames of 56x44, but those of layer low are 28x22"), std::string::npos);
}

TEST_F(Layers, AreAtLeastOne) {
  shot_.layers.clear();
  const std::string fault = "a shot without layers: wanted one at least";
  EXPECT_EQ(messageOf<UsageError>([&] { checkLayers(shot_, {}); }), fault);
  EXPECT_EQ(messageOf<UsageError>([&] { compositeLayers(shot_, {}); }), fault);
}

TEST_F(Layers, RefuseAPaintedFrameOfAnotherSize) {
  const std::string frame = scene_.file(SmallScene::frame("shot/layers/high", 2));
  writePng(frame, Image<Rgba8>({kSize.width + 1, kSize.height}, kVeil));
  const std::string message = messageOf<Error>([&] { compositeLayers(shot_, {}); });
  EXPECT_EQ(message.find(frame + ": "), 0U) << message;
}

TEST_F(Layers, AreAllCheckedBeforeAnythingIsPainted) {
  shot_.layers[0].options.source.path = scene_.file("nowhere/%05d.png");
  shot_.layers[1].options.target.path = scene_.file("gone/%05d.png");
  const std::string faults = messageOf<Faults>([&] { checkLayers(shot_, {}); });
  EXPECT_NE(faults.find("layer low: " + scene_.file("nowhere/00001.png")), std::string::npos)
      << faults;
  EXPECT_NE(faults.find("layer high: " + scene_.file("gone/00001.png")), std::string::npos)
      << faults;
}

TEST_F(Layers, WriteNoFileThatIsReadOrWrittenElsewhere) {
  const auto fault = [&] { return messageOf<UsageError>([&] { checkLayers(shot_, {}); }); };
  const std::string outPath = shot_.outPath;
  shot_.outPath = scene_.file("src/%05d.png");
  EXPECT_NE(fault().find("is an input and would be overwritten"), std::string::npos);
  shot_.outPath = shot_.layers[0].options.outPath;
  EXPECT_NE(fault().find("is written by layer low, too"), std::string::npos);
  shot_.outPath = outPath;
  shot_.layers[1].options.outPath = shot_.layers[0].options.outPath;
  EXPECT_NE(fault().find("layer high: "), std::string::npos);
  shot_.layers[1].options.outPath = scene_.file("shot/layers/high/%05d.png");
  EXPECT_EQ(fault(), "");
  shot_.background = SmallScene::frame("shot", 1);
  EXPECT_NE(fault().find("no file of that name"), std::string::npos);
  LayeredShot black = shot_;
  black.background = "black";
  compositeLayers(black, {});
  shot_.background = scene_.file(SmallScene::frame("shot", 1));
  EXPECT_NE(fault().find("is an input and would be overwritten"), std::string::npos);
}

TEST_F(Layers, WriteNoFileThatIsTheirBackgroundUnderAnotherName) {
  const std::string picture = scene_.file("wash.png");
  writePng(picture, Image<Rgba8>(kSize, kRed));
  shot_.background = picture;
  const auto fault = [&] { return messageOf<UsageError>([&] { checkLayers(shot_, {}); }); };
  EXPECT_EQ(fault(), "");
  for (const char* folder : {"shot", "shot/layers/high"}) {
    const std::string frame = scene_.file(SmallScene::frame(folder, 2));
    std::filesystem::remove(frame);
    std::filesystem::create_hard_link(picture, frame);
    EXPECT_NE(fault().find(frame + " is an input and would be overwritten"), std::string::npos)
        << fault();
    std::filesystem::remove(frame);
  }
  shot_.layers[1].options.dumpGuidesDirectory = scene_.file("dump");
  std::filesystem::create_directories(scene_.file("dump/source"));
  std::filesystem::create_hard_link(picture, scene_.file("dump/source/00001.mask.png"));
  EXPECT_NE(fault().find("00001.mask.png is an input and would be overwritten"), std::string::npos)
      << fault();
}

TEST_F(Layers, ReplaceNoBackgroundThatHasThePlaceOfTheirManifest) {
  const std::string picture = scene_.file("shot/fluidymation.json");
  std::filesystem::remove(picture);
  writePng(picture, Image<Rgba8>(kSize, kRed));
  shot_.background = picture;
  EXPECT_NE(messageOf<UsageError>([&] { checkLayers(shot_, {}); }).find(picture + " is an input"),
            std::string::npos);
}

TEST_F(Layers, RecordTheirBackgroundAndRefuseAnotherOne) {
  const std::string picture = scene_.file("wash.png");
  writePng(picture, Image<Rgba8>(kSize, kRed));
  shot_.background = picture;
  const Digest digest = digestOfFile(picture);
  compositeLayers(shot_, {});
  const std::vector<InputDigests> inputs =
      readManifest(scene_.file("shot/fluidymation.json")).fingerprint.inputs;
  const auto found = std::find_if(inputs.begin(), inputs.end(), [](const InputDigests& input) {
    return input.option == "--background";
  });
  ASSERT_NE(found, inputs.end());
  ASSERT_EQ(found->files.size(), 1U);
  EXPECT_EQ(found->files[0].digest, digest);
  bool replaced = false;
  Observer observer;
  observer.cancelled = [&] {
    if (!std::exchange(replaced, true)) writePng(picture, Image<Rgba8>(kSize, kVeil));
    return false;
  };
  const std::string message = messageOf<Error>([&] { compositeLayers(shot_, observer); });
  EXPECT_EQ(message.find(picture + ": "), 0U) << message;
  expectPixel(pixel(kSize.width - 1, kSize.height - 1), kRed);
}

TEST_F(Layers, DumpIntoFoldersOfTheirOwn) {
  const auto fault = [&] { return messageOf<UsageError>([&] { checkLayers(shot_, {}); }); };
  shot_.layers[0].options.dumpGuidesDirectory = scene_.file("dump");
  EXPECT_EQ(fault(), "");
  shot_.layers[1].options.dumpGuidesDirectory = scene_.file("other");
  EXPECT_EQ(fault(), "");
  const std::string same = scene_.file("shot/../dump");
  shot_.layers[1].options.dumpGuidesDirectory = same;
  EXPECT_EQ(fault(), "layer high: --dump-guides " + same + ": " + same +
                         "/source is written by layer low, too; choose another folder");
  // "target" is what a dump calls the folder of the animation's guides
  shot_.layers[0].options.dumpGuidesDirectory.reset();
  shot_.outPath = scene_.file("mixed/target/%05d.png");
  shot_.layers[1].options.dumpGuidesDirectory = scene_.file("mixed");
  EXPECT_EQ(fault(), "layer high: --dump-guides: " + scene_.file("mixed/target") +
                         " is a folder of painted frames; choose another folder");
}

TEST_F(Layers, StopWhereTheyAreAskedToAndGoOn) {
  compositeLayers(shot_, {});
  const SmallScene::Painting whole = test::filesOf(scene_.file("shot"));
  bool stopped = true;
  for (int patience = 0; stopped; ++patience) {
    int asked = 0;
    Observer observer;
    observer.cancelled = [&] { return asked++ == patience; };
    shot_.continuation.resume = false;
    try {
      compositeLayers(shot_, observer);
      stopped = false;
    } catch (const Interrupted& stop) {
      EXPECT_TRUE(stop.canResume());
    }
    shot_.continuation.resume = true;
    compositeLayers(shot_, {});
    EXPECT_TRUE(test::filesOf(scene_.file("shot")) == whole) << patience;
  }
}

TEST(InLayer, NamesTheLayerInEveryFault) {
  EXPECT_EQ(messageOf<UsageError>([] { inLayer("a", [] { throw UsageError("x"); }); }),
            "layer a: x");
  EXPECT_EQ(messageOf<Error>([] { inLayer("a", [] { throw Error("x"); }); }), "layer a: x");
  EXPECT_EQ(messageOf<Interrupted>([] { inLayer("a", [] { throw Interrupted("x"); }); }),
            "layer a: x");
  EXPECT_EQ(messageOf<Faults>([] { inLayer("a", [] {
                                     throw Faults({"x", "y"});
                                   }); }),
            "layer a: x; layer a: y");
}

}  // namespace
}  // namespace fluidymation
