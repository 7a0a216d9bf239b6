#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/io/png.h"
#include "support/png_maker.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::PngColor;
using test::PngSpec;
using test::TemporaryFolder;

TEST(PngCoverage, IsAlphaOrLuminance) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  PngSpec spec;
  spec.size = {2, 1};
  spec.color = PngColor::kRgba;
  spec.samples = {255, 0, 0, 254, 128, 128, 128, 255};
  test::writeBytes(path, test::makePng(spec));
  EXPECT_NEAR(readCoverage(path, MaskChannel::kBrightness)(0, 0), 0.2126F, 1e-6F);
  EXPECT_EQ(readCoverage(path, MaskChannel::kBrightness)(1, 0), 128.0F / 255.0F);
  EXPECT_EQ(readCoverage(path, MaskChannel::kAlpha)(0, 0), 254.0F / 255.0F);
  EXPECT_EQ(readCoverage(path, MaskChannel::kAlpha)(1, 0), 1.0F);
  EXPECT_EQ(readColor(path)(0, 0).r, 1.0F) << "alpha does not touch the colour";
}

/// Coverage is read without going by way of RGBA.
TEST(PngCoverage, IsThatOfTheRgbaPixels) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  std::vector<PngSpec> specs;
  for (const PngColor color : {PngColor::kGray, PngColor::kGrayAlpha, PngColor::kRgb,
                               PngColor::kRgba, PngColor::kPalette}) {
    for (const int bitDepth : {1, 2, 4, 8, 16}) {
      const bool isGray = color == PngColor::kGray;
      const bool isPalette = color == PngColor::kPalette;
      if (bitDepth < 8 && !isGray && !isPalette) continue;
      if (bitDepth == 16 && isPalette) continue;
      for (const bool interlaced : {false, true}) {
        PngSpec spec;
        spec.size = {7, 6};
        spec.color = color;
        spec.bitDepth = bitDepth;
        spec.interlaced = interlaced;
        spec.palette = {{9, 9, 9}, {200, 30, 4}};
        if (!isPalette) spec.palette.clear();
        const int values = isPalette ? 2 : 1 << bitDepth;
        for (int i = 0; i < 7 * 6 * test::channelsOf(color); ++i) {
          spec.samples.push_back(static_cast<std::uint16_t>(i * 7919 % values));
        }
        specs.push_back(spec);
        spec.gamma = 0.7;
        specs.push_back(spec);
        if (isPalette) spec.paletteAlpha = {255, 77};
        if (isGray) spec.transparent = {{spec.samples[1], 0, 0}};
        if (color == PngColor::kRgb) {
          spec.transparent = {{spec.samples[3], spec.samples[4], spec.samples[5]}};
        }
        if (isPalette || isGray || color == PngColor::kRgb) specs.push_back(spec);
      }
    }
  }
  for (const PngSpec& spec : specs) {
    test::writeBytes(path, test::makePng(spec));
    const Image<Rgba> pixels = readPng(path);
    const Image<float> brightness = readCoverage(path, MaskChannel::kBrightness);
    const Image<float> alpha = readCoverage(path, MaskChannel::kAlpha);
    if (spec.transparent) {
      EXPECT_EQ(*std::min_element(alpha.begin(), alpha.end()), 0.0F);
      EXPECT_EQ(*std::max_element(alpha.begin(), alpha.end()), 1.0F);
    }
    for (std::size_t i = 0; i < pixels.pixelCount(); ++i) {
      const Rgba& p = pixels.data()[i];
      const bool isGray = p.r == p.g && p.g == p.b;
      ASSERT_EQ(brightness.data()[i], isGray ? p.r : 0.2126F * p.r + 0.7152F * p.g + 0.0722F * p.b);
      ASSERT_EQ(alpha.data()[i], p.a);
    }
  }
}

}  // namespace
}  // namespace fluidymation
