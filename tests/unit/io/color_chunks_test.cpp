#include "fluidymation/io/color_chunks.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <string>

#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"
#include "support/png_maker.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::PngChunk;
using test::TemporaryFolder;

Bytes bigEndian(std::uint32_t value) {
  return {
      static_cast<std::uint8_t>(value >> 24U), static_cast<std::uint8_t>((value >> 16U) & 0xFFU),
      static_cast<std::uint8_t>((value >> 8U) & 0xFFU), static_cast<std::uint8_t>(value & 0xFFU)};
}

/// An ICC.1 version 2 display profile: its header, and one tag of noise, for libpng takes
/// chunks of less than some 90 bytes for damaged.
Bytes profileOf(const char* colorSpace, std::uint32_t length = 400) {
  Bytes profile(length, 0);
  const auto put = [&](std::size_t place, const Bytes& bytes) {
    std::copy(bytes.begin(), bytes.end(), profile.begin() + static_cast<std::ptrdiff_t>(place));
  };
  const auto text = [](const char* word) { return Bytes(word, word + std::strlen(word)); };
  put(0, bigEndian(length));
  put(8, {2, 0x10});
  put(12, text("mntr"));
  put(16, text(colorSpace));
  put(20, text("XYZ "));
  put(36, text("acsp"));
  put(68, {0, 0, 0xF6, 0xD6, 0, 1, 0, 0, 0, 0, 0xD3, 0x2D});  // D50
  put(128, bigEndian(1));
  put(132, text("cprt"));
  put(136, bigEndian(144));
  put(140, bigEndian(256));
  put(144, text("text"));
  std::mt19937 random(3);
  for (std::size_t i = 152; i < 400; ++i) profile[i] = static_cast<std::uint8_t>(random() & 0xFFU);
  return profile;
}

Bytes deflated(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes packed(size);
  compress(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()));
  packed.resize(size);
  return packed;
}

PngChunk profileChunk(const Bytes& profile, const std::string& name = "film") {
  Bytes data(name.begin(), name.end());
  data.insert(data.end(), {0, 0});  // the name's end, and how the profile is packed
  const Bytes packed = deflated(profile);
  data.insert(data.end(), packed.begin(), packed.end());
  return {"iCCP", data};
}

PngChunk gammaChunk(std::uint32_t gamma) { return {"gAMA", bigEndian(gamma)}; }

PngChunk chromaticityChunk(const std::array<std::int32_t, 8>& values) {
  Bytes data;
  for (const std::int32_t value : values) {
    const Bytes bytes = bigEndian(static_cast<std::uint32_t>(value));
    data.insert(data.end(), bytes.begin(), bytes.end());
  }
  return {"cHRM", data};
}

constexpr std::array<std::int32_t, 8> kDisplayP3 = {31270, 32900, 68000, 32000,
                                                    26500, 69000, 15000, 6000};

class ColorChunksTest : public ::testing::Test {
 protected:
  /// Of an RGB picture with these chunks behind its header.
  [[nodiscard]] FoundColorChunks found(const std::vector<PngChunk>& chunks,
                                       test::PngColor color = test::PngColor::kRgb) const {
    test::PngSpec spec;
    spec.size = {2, 1};
    spec.color = color;
    spec.samples.assign(static_cast<std::size_t>(2 * test::channelsOf(color)), 7);
    std::vector<PngChunk> all = test::splitPng(test::makePng(spec));
    all.insert(all.begin() + 1, chunks.begin(), chunks.end());
    test::writeBytes(path_, test::joinPng(all));
    return readColorChunks(path_);
  }

  /// As they come back from a file that `encodePng` made.
  [[nodiscard]] FoundColorChunks writtenAndRead(const ColorChunks& chunks) const {
    for (const bool opaque : {false, true}) {
      test::writeBytes(path_,
                       encodePng(Image<Rgba16>({2, 2}), kDefaultCompression, {opaque, chunks}));
    }
    return readColorChunks(path_);
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.png");
};

TEST_F(ColorChunksTest, AFileWithoutAnyHasNone) {
  const FoundColorChunks none = found({});
  EXPECT_EQ(none.chunks, ColorChunks{});
  EXPECT_EQ(namesOf(none.chunks), "none");
  EXPECT_EQ(none.refused, "");
  EXPECT_EQ(writtenAndRead({}).chunks, ColorChunks{});
}

TEST_F(ColorChunksTest, WhatIsFoundIsWrittenAndNothingElse) {
  const Bytes profile = profileOf("RGB ");
  for (const auto& [chunks, names] : std::vector<std::pair<std::vector<PngChunk>, std::string>>{
           {{{"sRGB", {2}}}, "sRGB"},
           {{{"sRGB", {0}}, gammaChunk(45455)}, "sRGB, gAMA"},
           {{gammaChunk(45455)}, "gAMA"},
           {{gammaChunk(45455), chromaticityChunk(kDisplayP3)}, "gAMA, cHRM"},
           {{chromaticityChunk(kDisplayP3)}, "cHRM"},
           {{profileChunk(profile)}, "iCCP"},
           {{gammaChunk(45455), profileChunk(profile)}, "gAMA, iCCP"}}) {
    const FoundColorChunks first = found(chunks);
    EXPECT_EQ(namesOf(first.chunks), names);
    EXPECT_EQ(first.refused, "") << names;
    const FoundColorChunks second = writtenAndRead(first.chunks);
    EXPECT_EQ(second.chunks, first.chunks) << names << " became " << namesOf(second.chunks);
  }
  EXPECT_EQ(found({{"sRGB", {2}}}).chunks.srgbIntent, 2);
  EXPECT_EQ(found({chromaticityChunk(kDisplayP3)}).chunks.chromaticities, kDisplayP3);
  EXPECT_EQ(found({profileChunk(profile)}).chunks.profile->bytes, profile);
  EXPECT_EQ(found({profileChunk(profile)}).chunks.profile->name, "film");
}

TEST_F(ColorChunksTest, AnExponentThatIsUndoneBecomesThatOfSrgb) {
  EXPECT_EQ(found({gammaChunk(100000)}).chunks.gamma, 45455);
  EXPECT_EQ(found({gammaChunk(46000)}).chunks.gamma, 46000) << "nearly sRGB's: values stay";
  EXPECT_EQ(found({gammaChunk(100000), profileChunk(profileOf("RGB "))}).chunks.gamma, 100000)
      << "the profile counts, so that values stay";
}

TEST_F(ColorChunksTest, WhatIsDamagedOrOfOtherPicturesIsRefusedByName) {
  EXPECT_EQ(found({{"iCCP", {1, 2, 3}}}).refused, "iCCP");
  Bytes cut = profileOf("RGB ");
  cut.resize(100);
  EXPECT_EQ(found({profileChunk(cut)}).refused, "iCCP");
  const FoundColorChunks gray = found({profileChunk(profileOf("GRAY"))}, test::PngColor::kGray);
  EXPECT_EQ(gray.refused, "iCCP");
  EXPECT_FALSE(gray.chunks.profile);
  EXPECT_EQ(found({{"sRGB", {9}}}).refused, "sRGB");
  EXPECT_EQ(found({gammaChunk(0)}).refused, "gAMA");
  EXPECT_EQ(found({chromaticityChunk({})}).refused, "cHRM");
  const FoundColorChunks both = found({{"sRGB", {0}}, profileChunk(profileOf("RGB "))});
  EXPECT_EQ(both.refused, "iCCP, sRGB") << "only one of them may be there";
  EXPECT_EQ(both.chunks, ColorChunks{});
}

TEST_F(ColorChunksTest, AProfileWhoseNameMayNotBeWrittenGetsAnother) {
  const Bytes profile = profileOf("RGB ");
  const std::string longest(79, 'x');
  for (const std::string& name :
       {std::string("a b"), std::string("caf\xE9"), std::string("~"), longest}) {
    EXPECT_EQ(found({profileChunk(profile, name)}).chunks.profile->name, name);
  }
  for (const char* name : {" ", "   ", " a", "a ", "a  b", "a\tb", "a\x7F", "a\x80", "a\xA0"}) {
    const FoundColorChunks first = found({profileChunk(profile, name)});
    EXPECT_EQ(first.refused, "") << name;
    ASSERT_TRUE(first.chunks.profile) << name;
    EXPECT_EQ(first.chunks.profile->name, kUnnamedProfile);
    EXPECT_EQ(first.chunks.profile->bytes, profile);
    EXPECT_EQ(writtenAndRead(first.chunks).chunks, first.chunks) << name;
  }
}

TEST_F(ColorChunksTest, AProfileThatUnpacksToTooMuchIsRefused) {
  const FoundColorChunks bomb = found({profileChunk(profileOf("RGB ", 40'000'000))});
  EXPECT_EQ(bomb.refused, "iCCP");
  EXPECT_EQ(namesOf(bomb.chunks), "none");
}

TEST_F(ColorChunksTest, ADamagedCheckSumIsAFault) {
  (void)found({gammaChunk(45455)});
  Bytes file = test::readBytes(path_);
  file[33 + 8 + 4] ^= 1U;  // of the chunk behind the header: length, name, four bytes
  test::writeBytes(path_, file);
  const std::string message = test::messageOf<Error>([&] { (void)readColorChunks(path_); });
  EXPECT_EQ(message.find(path_ + ": damaged PNG file ("), 0U) << message;
}

}  // namespace
}  // namespace fluidymation
