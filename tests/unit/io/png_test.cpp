#include "fluidymation/io/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fluidymation/core/color.h"
#include "fluidymation/core/error.h"
#include "support/png_maker.h"

namespace fluidymation {
namespace {

using test::PngColor;
using test::PngSpec;
using test::TemporaryFolder;

std::string nameOf(const PngSpec& spec) {
  return "color " + std::to_string(static_cast<int>(spec.color)) + ", " +
         std::to_string(spec.bitDepth) + " bit" + (spec.interlaced ? ", interlaced" : "");
}

/// Random samples; 13 x 11 so that every pass of an interlaced file has rows and none is even.
PngSpec randomPng(PngColor color, int bitDepth, bool interlaced, Size size = {13, 11}) {
  PngSpec spec;
  spec.size = size;
  spec.color = color;
  spec.bitDepth = bitDepth;
  spec.interlaced = interlaced;
  std::mt19937 random(static_cast<unsigned>(bitDepth + 100 * static_cast<int>(color)));
  const unsigned valueCount = 1U << static_cast<unsigned>(bitDepth);
  const int samples = size.width * size.height * test::channelsOf(color);
  for (int i = 0; i < samples; ++i) {
    spec.samples.push_back(static_cast<std::uint16_t>(random() % valueCount));
  }
  if (color == PngColor::kPalette) {
    for (unsigned i = 0; i < valueCount; ++i) {
      spec.palette.push_back({static_cast<std::uint8_t>(random() & 0xFFU),
                              static_cast<std::uint8_t>(random() & 0xFFU),
                              static_cast<std::uint8_t>(random() & 0xFFU)});
    }
  }
  return spec;
}

/// Slow twin of the reader: what the samples of `spec` mean.
Rgba meaningOf(const PngSpec& spec, int x, int y) {
  const auto channels = static_cast<std::size_t>(test::channelsOf(spec.color));
  const std::size_t first =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.size.width) +
       static_cast<std::size_t>(x)) *
      channels;
  const auto raw = [&](std::size_t channel) { return spec.samples.at(first + channel); };
  const auto value = [&](std::size_t channel) {
    return static_cast<float>(raw(channel)) / static_cast<float>((1 << spec.bitDepth) - 1);
  };
  const bool gray = spec.color == PngColor::kGray;
  switch (spec.color) {
    case PngColor::kPalette: {
      const auto& c = spec.palette.at(raw(0));
      const float alpha = raw(0) < spec.paletteAlpha.size()
                              ? static_cast<float>(spec.paletteAlpha[raw(0)]) / 255
                              : 1;
      return {static_cast<float>(c[0]) / 255, static_cast<float>(c[1]) / 255,
              static_cast<float>(c[2]) / 255, alpha};
    }
    case PngColor::kGray:
    case PngColor::kRgb: {
      bool transparent = spec.transparent.has_value();
      for (std::size_t i = 0; i < channels && transparent; ++i) {
        transparent = raw(i) == (*spec.transparent)[i];
      }
      return {value(0), value(gray ? 0 : 1), value(gray ? 0 : 2), transparent ? 0.0F : 1.0F};
    }
    case PngColor::kGrayAlpha:
      return {value(0), value(0), value(0), value(1)};
    case PngColor::kRgba:
      break;
  }
  return {value(0), value(1), value(2), value(3)};
}

void expectReadExactly(const PngSpec& spec) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  test::writeBytes(path, test::makePng(spec));
  EXPECT_EQ(readPngSize(path), spec.size) << nameOf(spec);
  const Image<Rgba> image = readPng(path);
  ASSERT_EQ(image.size(), spec.size) << nameOf(spec);
  for (int y = 0; y < spec.size.height; ++y) {
    for (int x = 0; x < spec.size.width; ++x) {
      const Rgba expected = meaningOf(spec, x, y);
      const Rgba& actual = image(x, y);
      ASSERT_TRUE(actual.r == expected.r && actual.g == expected.g && actual.b == expected.b &&
                  actual.a == expected.a)
          << nameOf(spec) << " at " << x << ", " << y << ": " << actual.r << " " << actual.g << " "
          << actual.b << " " << actual.a << ", expected " << expected.r << " " << expected.g << " "
          << expected.b << " " << expected.a;
    }
  }
}

TEST(Png, ReadsEveryColorTypeAndDepthExactly) {
  for (const bool interlaced : {false, true}) {
    for (const int depth : {1, 2, 4, 8, 16}) {
      expectReadExactly(randomPng(PngColor::kGray, depth, interlaced));
    }
    for (const int depth : {1, 2, 4, 8}) {
      expectReadExactly(randomPng(PngColor::kPalette, depth, interlaced));
    }
    for (const PngColor color : {PngColor::kRgb, PngColor::kGrayAlpha, PngColor::kRgba}) {
      for (const int depth : {8, 16}) expectReadExactly(randomPng(color, depth, interlaced));
    }
  }
}

TEST(Png, ReadsTransparencyChunksExactly) {
  for (const bool interlaced : {false, true}) {
    for (const int depth : {1, 2, 4, 8, 16}) {
      PngSpec gray = randomPng(PngColor::kGray, depth, interlaced);
      gray.transparent = {gray.samples[0], gray.samples[0], gray.samples[0]};
      expectReadExactly(gray);
    }
    for (const int depth : {8, 16}) {
      PngSpec rgb = randomPng(PngColor::kRgb, depth, interlaced);
      rgb.transparent = {rgb.samples[0], rgb.samples[1], rgb.samples[2]};
      expectReadExactly(rgb);
    }
    for (const int depth : {1, 2, 4, 8}) {
      PngSpec palette = randomPng(PngColor::kPalette, depth, interlaced);
      palette.paletteAlpha = {0, 77};
      expectReadExactly(palette);
    }
  }
}

TEST(Png, ReadsTheSmallestAndThinnestImages) {
  for (const Size size : {Size{1, 1}, Size{1, 9}, Size{9, 1}, Size{3, 3}}) {
    for (const bool interlaced : {false, true}) {
      expectReadExactly(randomPng(PngColor::kGray, 1, interlaced, size));
      expectReadExactly(randomPng(PngColor::kRgba, 16, interlaced, size));
    }
  }
}

TEST(Png, DeclaredGammaIsUndoneUnlessItIsSrgbLike) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  PngSpec spec;
  spec.size = {1, 1};
  spec.bitDepth = 16;
  spec.color = PngColor::kGrayAlpha;
  spec.samples = {20000, 20000};
  const float stored = 20000.0F / 65535.0F;
  const auto readWith = [&](std::optional<double> gamma, bool srgb) {
    spec.gamma = gamma;
    spec.srgb = srgb;
    test::writeBytes(path, test::makePng(spec));
    const Rgba pixel = readPng(path)(0, 0);
    EXPECT_EQ(pixel.a, stored) << "alpha has no gamma";
    return pixel.g;
  };
  EXPECT_EQ(readWith(std::nullopt, false), stored);
  EXPECT_EQ(readWith(1.0 / 2.2, false), stored);
  EXPECT_EQ(readWith(std::nullopt, true), stored);
  EXPECT_EQ(readWith(1.0 / 2.2, true), stored);
  EXPECT_NEAR(readWith(1.0, false), srgbEncode(stored), 1e-6F);  // linear light
  EXPECT_NEAR(readWith(1.0 / 1.8, false), srgbEncode(std::pow(stored, 1.8F)), 1e-4F);
}

TEST(Png, TransparencyIsFoundWhereverItIs) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  const auto transparent = [&](const PngSpec& spec) {
    test::writeBytes(path, test::makePng(spec));
    return hasTransparency(path);
  };
  for (const PngColor color : {PngColor::kGrayAlpha, PngColor::kRgba}) {
    for (const int bitDepth : {8, 16}) {
      for (const bool interlaced : {false, true}) {
        const auto channels = static_cast<std::size_t>(test::channelsOf(color));
        const auto largest = static_cast<std::uint16_t>((1 << bitDepth) - 1);
        PngSpec spec;
        spec.size = {6, 5};
        spec.color = color;
        spec.bitDepth = bitDepth;
        spec.interlaced = interlaced;
        spec.samples.assign(6 * 5 * channels, 0);
        for (std::size_t i = channels - 1; i < spec.samples.size(); i += channels) {
          spec.samples[i] = largest;
        }
        EXPECT_FALSE(transparent(spec));
        for (std::size_t i = channels - 1; i < spec.samples.size(); i += channels) {
          spec.samples[i] = static_cast<std::uint16_t>(largest - 1);
          EXPECT_TRUE(transparent(spec)) << i;
          spec.samples[i] = largest;
        }
      }
    }
  }
}

TEST(Png, PalettesAndColoursMayBeTransparent) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  PngSpec keyed;
  keyed.size = {2, 1};
  keyed.samples = {3, 4};
  PngSpec palette = keyed;
  palette.color = PngColor::kPalette;
  palette.palette = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {5, 5, 5}};
  for (const std::uint16_t unseen : {std::uint16_t{5}, std::uint16_t{4}}) {
    keyed.transparent = {{unseen, unseen, unseen}};
    palette.paletteAlpha = {255, 255, 255, 255, 255};
    if (unseen < 5) palette.paletteAlpha[unseen] = 254;
    for (const PngSpec& spec : {keyed, palette}) {
      test::writeBytes(path, test::makePng(spec));
      EXPECT_EQ(hasTransparency(path), unseen == 4);
    }
  }
  keyed.transparent.reset();
  test::writeBytes(path, test::makePng(keyed));
  EXPECT_FALSE(hasTransparency(path));
}

TEST(Png, OneBitMasksAreZeroAndOne) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  PngSpec spec;
  spec.size = {2, 1};
  spec.bitDepth = 1;
  spec.samples = {0, 1};
  test::writeBytes(path, test::makePng(spec));
  EXPECT_EQ(readCoverage(path, MaskChannel::kBrightness)(0, 0), 0.0F);
  EXPECT_EQ(readCoverage(path, MaskChannel::kBrightness)(1, 0), 1.0F);
}

TEST(Png, EightBitRoundTripIsExact) {
  const TemporaryFolder folder;
  Image<Rgba8> image(Size{256, 4});
  Image<std::uint8_t> gray(image.size());
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 256; ++x) {
      const auto v = static_cast<std::uint8_t>(x);
      gray(x, y) = v;
      image(x, y) = {v, static_cast<std::uint8_t>(255 - v), static_cast<std::uint8_t>(x * 7 & 0xFF),
                     static_cast<std::uint8_t>(y == 0 ? v : 85 * y)};
    }
  }
  writePng(folder.file("rgba.png"), image);
  writeGrayPng(folder.file("gray.png"), gray);
  const Image<Rgba> imageBack = readPng(folder.file("rgba.png"));
  const Image<Rgba> grayBack = readPng(folder.file("gray.png"));
  const auto byte = [](float v) { return static_cast<int>(std::lround(v * 255.0F)); };
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 256; ++x) {
      const Rgba& p = imageBack(x, y);
      const Rgba8& e = image(x, y);
      ASSERT_TRUE(byte(p.r) == e.r && byte(p.g) == e.g && byte(p.b) == e.b && byte(p.a) == e.a);
      ASSERT_EQ(byte(grayBack(x, y).g), gray(x, y));
      ASSERT_EQ(grayBack(x, y).a, 1.0F);
    }
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"gray.png", "rgba.png"}));
}

TEST(Png, SameImageGivesTheSameBytes) {
  const TemporaryFolder folder;
  const Image<Rgba8> image(Size{40, 30}, Rgba8{1, 2, 3, 255});
  writePng(folder.file("a.png"), image);
  writePng(folder.file("b.png"), image);
  EXPECT_EQ(test::readBytes(folder.file("a.png")), test::readBytes(folder.file("b.png")));
}

/// Smooth colours with a little noise inside a disc, nothing outside: like a painted frame.
Image<Rgba8> paintedDisc(Size size) {
  Image<Rgba8> picture(size);
  std::mt19937 random(1);
  const int centreX = size.width / 2;
  const int centreY = size.height / 2;
  const int radius = size.height / 3;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int dx = x - centreX;
      const int dy = y - centreY;
      if (dx * dx + dy * dy > radius * radius) continue;
      const auto near = [&random](int value) {
        return static_cast<std::uint8_t>(value + static_cast<int>(random() % 6));
      };
      picture(x, y) = {near(x / 2), near(y), near((x + y) / 4), 255};
    }
  }
  return picture;
}

TEST(Png, CompressionLevelsChangeNoPixel) {
  const TemporaryFolder folder;
  const Image<Rgba8> picture = paintedDisc({90, 60});
  for (int level = kLeastCompression; level <= kMostCompression; ++level) {
    SCOPED_TRACE(level);
    const std::string path = folder.file(std::to_string(level) + ".png");
    writePng(path, picture, level);
    const Image<Rgba> back = readPng(path);
    ASSERT_EQ(back.size(), picture.size());
    for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
      const Rgba& p = back.data()[i];
      const Rgba8& e = picture.data()[i];
      ASSERT_TRUE(toByte(p.r) == e.r && toByte(p.g) == e.g && toByte(p.b) == e.b &&
                  toByte(p.a) == e.a)
          << i;
    }
  }
}

TEST(Png, EveryCompressionLevelButTheLeastCompresses) {
  const Image<Rgba8> picture = paintedDisc({400, 300});
  const auto bytes = [&](int level) { return encodePng(picture, level).size(); };
  EXPECT_GT(bytes(0), picture.pixelCount() * sizeof(Rgba8)) << "stored";
  for (int level = 1; level <= kMostCompression; ++level) {
    EXPECT_LT(bytes(level), bytes(0) / 4) << level;
  }
}

TEST(Png, TheDefaultCompressionIsNearlyThatOfTheSlowestLevel) {
  const Image<Rgba8> picture = paintedDisc({400, 300});
  EXPECT_LT(static_cast<double>(encodePng(picture).size()),
            1.05 * static_cast<double>(encodePng(picture, kMostCompression).size()));
}

TEST(Png, AFileIsWrittenAsItWasEncoded) {
  const TemporaryFolder folder;
  const Image<Rgba8> picture = paintedDisc({50, 40});
  writePng(folder.file("a.png"), picture, 5);
  const std::vector<std::uint8_t> encoded = encodePng(picture, 5);
  const test::Bytes written = test::readBytes(folder.file("a.png"));
  EXPECT_TRUE(std::equal(written.begin(), written.end(), encoded.begin(), encoded.end()));
}

TEST(Png, WritingNamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none/a.png");
  EXPECT_EQ(test::messageOf<Error>([&] {
              writePng(path, Image<Rgba8>(Size{2, 2}));
            }),
            path + ": cannot be written (No such file or directory)");
}

TEST(EncodePng, HoldsSixteenBitsHighByteFirst) {
  const test::TemporaryFolder folder;
  Image<Rgba16> picture({2, 1});
  picture(0, 0) = {0x0102, 0xFFFE, 0, 0x8001};
  picture(1, 0) = {65535, 1, 256, 65535};
  const std::string path = folder.file("a.png");
  test::writeBytes(path, encodePng(picture, 0));
  const test::Bytes file = test::readBytes(path);
  EXPECT_EQ(file[24], 16);
  const test::Bytes row = {1, 2, 0xFF, 0xFE, 0, 0, 0x80, 1, 0xFF, 0xFF, 0, 1, 1, 0, 0xFF, 0xFF};
  EXPECT_NE(std::search(file.begin(), file.end(), row.begin(), row.end()), file.end());
  const Image<Rgba> read = readPng(path);
  for (int x = 0; x < 2; ++x) {
    EXPECT_EQ(std::lround(65535.0F * read(x, 0).r), picture(x, 0).r);
    EXPECT_EQ(std::lround(65535.0F * read(x, 0).g), picture(x, 0).g);
    EXPECT_EQ(std::lround(65535.0F * read(x, 0).b), picture(x, 0).b);
    EXPECT_EQ(std::lround(65535.0F * read(x, 0).a), picture(x, 0).a);
  }
}

TEST(EncodePng, AnOpaquePictureHasNoAlpha) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  test::writeBytes(path, encodePng(Image<Rgba8>({3, 2}, Rgba8{1, 2, 3, 4}), 2, {true, {}}));
  EXPECT_EQ(test::readBytes(path)[25], 2) << "colour type RGB";
  const Rgba pixel = readPng(path)(2, 1);
  EXPECT_EQ(toByte(pixel.r), 1);
  EXPECT_EQ(toByte(pixel.b), 3);
  EXPECT_EQ(pixel.a, 1.0F);
}

}  // namespace
}  // namespace fluidymation
