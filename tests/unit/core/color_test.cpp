#include "fluidymation/core/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <random>

namespace fluidymation {
namespace {

TEST(Color, LabOfTheSrgbPrimariesAgreesWithPublishedValues) {
  const Lab red = toLab(Rgb{1.0F, 0.0F, 0.0F});
  EXPECT_NEAR(red.l, 53.24F, 0.02F);
  EXPECT_NEAR(red.a, 80.09F, 0.05F);
  EXPECT_NEAR(red.b, 67.20F, 0.05F);
  const Lab blue = toLab(Rgb{0.0F, 0.0F, 1.0F});
  EXPECT_NEAR(blue.l, 32.30F, 0.02F);
  EXPECT_NEAR(blue.a, 79.19F, 0.05F);
  EXPECT_NEAR(blue.b, -107.86F, 0.05F);
}

TEST(Color, ChannelsBecomeTheNearestOfSixteenBits) {
  EXPECT_EQ(to16Bits(0.0F), 0);
  EXPECT_EQ(to16Bits(1.0F), 65535);
  EXPECT_EQ(to16Bits(0.25F), 16384);
  EXPECT_EQ(to16Bits(-3.0F), 0);
  EXPECT_EQ(to16Bits(7.0F), 65535);
}

TEST(Color, IsReadFromItsNameOrItsHexadecimalDigits) {
  const std::optional<Rgb> paper = colorOf("#F4f100");
  ASSERT_TRUE(paper);
  EXPECT_EQ(toByte(paper->r), 0xF4);
  EXPECT_EQ(toByte(paper->g), 0xF1);
  EXPECT_EQ(toByte(paper->b), 0);
  const std::optional<Rgb> brief = colorOf("#08f");
  ASSERT_TRUE(brief);
  EXPECT_EQ(toByte(brief->r), 0);
  EXPECT_EQ(toByte(brief->g), 0x88);
  EXPECT_EQ(toByte(brief->b), 0xFF);
  EXPECT_TRUE(colorOf("white"));
  for (const char* text : {"", "#", "#12", "#12345", "#1234567", "#12345g", "F4F1E8", "redd"}) {
    EXPECT_FALSE(colorOf(text)) << text;
  }
}

TEST(Color, GraysAreNeutralAndWhiteIsHundred) {
  for (const float gray : {0.0F, 0.01F, 0.2F, 0.5F, 1.0F}) {
    const Lab lab = toLab(Rgb{gray, gray, gray});
    EXPECT_NEAR(lab.a, 0.0F, 1e-3F) << gray;
    EXPECT_NEAR(lab.b, 0.0F, 1e-3F) << gray;
  }
  EXPECT_NEAR(toLab(Rgb{1.0F, 1.0F, 1.0F}).l, 100.0F, 1e-3F);
}

TEST(Color, EightBitColoursSurviveTheRoundTrip) {
  constexpr float kHalfStep = 0.5F / 255.0F;
  for (int r = 0; r < 256; r += 17) {
    for (int g = 0; g < 256; g += 17) {
      for (int b = 0; b < 256; b += 15) {
        const Rgb color{static_cast<float>(r) / 255.0F, static_cast<float>(g) / 255.0F,
                        static_cast<float>(b) / 255.0F};
        const Rgb back = toRgb(toLab(color));
        ASSERT_NEAR(back.r, color.r, kHalfStep) << r << ' ' << g << ' ' << b;
        ASSERT_NEAR(back.g, color.g, kHalfStep) << r << ' ' << g << ' ' << b;
        ASSERT_NEAR(back.b, color.b, kHalfStep) << r << ' ' << g << ' ' << b;
      }
    }
  }
}

TEST(Color, OutOfGamutIsClipped) {
  const Rgb color = toRgb(Lab{50.0F, 200.0F, -200.0F});
  for (const float channel : {color.r, color.g, color.b}) {
    EXPECT_GE(channel, 0.0F);
    EXPECT_LE(channel, 1.0F);
  }
}

std::uint8_t byteByFormula(float linear) {
  return toByte(srgbEncode(std::min(std::max(linear, 0.0F), 1.0F)));
}

TEST(SrgbByteEncoder, AgreesWithTheFormulaNearEveryDecisionLevel) {
  const SrgbByteEncoder encoder;
  constexpr int kNeighbours = 2000;  // floats on either side
  for (int byte = 1; byte <= 255; ++byte) {
    float linear = srgbDecode((static_cast<float>(byte) - 0.5F) / 255.0F);
    for (int i = 0; i < kNeighbours; ++i) linear = std::nextafter(linear, 0.0F);
    for (int i = 0; i < 2 * kNeighbours; ++i) {
      ASSERT_EQ(encoder.byte(linear), byteByFormula(linear)) << byte << ' ' << linear;
      linear = std::nextafter(linear, 2.0F);
    }
    EXPECT_EQ(encoder.byte(linear), byte) << "the level was among them";
  }
}

TEST(SrgbByteEncoder, AgreesWithTheFormulaEverywhereBetween) {
  const SrgbByteEncoder encoder;
  // All floats from 0 to 1 in steps of a prime number of them
  constexpr std::uint32_t kStep = 251;
  constexpr std::uint32_t kBitsOfOne = 0x3F800000;
  for (std::uint32_t bits = 0; bits <= kBitsOfOne; bits += kStep) {
    float linear = 0.0F;
    std::memcpy(&linear, &bits, sizeof linear);
    ASSERT_EQ(encoder.byte(linear), byteByFormula(linear)) << linear;
  }
}

TEST(SrgbByteEncoder, ClipsWhatIsOutside) {
  const SrgbByteEncoder encoder;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float below : {-kInfinity, -1.0F, -0.0F, 0.0F}) EXPECT_EQ(encoder.byte(below), 0);
  for (const float above : {1.0F, 1.0001F, 3e9F, kInfinity}) EXPECT_EQ(encoder.byte(above), 255);
  EXPECT_EQ(encoder.byte(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(SrgbByteEncoder, GivesTheBytesOfTheColour) {
  const SrgbByteEncoder encoder;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> lightness(-5.0F, 105.0F);
  std::uniform_real_distribution<float> chroma(-140.0F, 140.0F);
  for (int i = 0; i < 200'000; ++i) {
    const Lab lab{lightness(random), chroma(random), chroma(random)};
    const Rgb color = toRgb(lab);
    const Rgb8 bytes = encoder(lab);
    ASSERT_EQ(bytes.r, toByte(color.r));
    ASSERT_EQ(bytes.g, toByte(color.g));
    ASSERT_EQ(bytes.b, toByte(color.b));
  }
}

TEST(Color, APictureBecomesWhatItsPixelsBecome) {
  // The 256 values of 8-bit pictures, their neighbours and what scaling makes of them
  std::vector<float> values = {-0.25F, 1.5F, std::numeric_limits<float>::quiet_NaN()};
  for (int i = 0; i <= 255; ++i) {
    const float value = static_cast<float>(i) / 255.0F;
    values.insert(values.end(), {value, std::nextafter(value, 2.0F), std::nextafter(value, -1.0F),
                                 value + 0.3F / 255.0F});
  }
  const int count = static_cast<int>(values.size());
  Image<Rgb> picture(Size{count, 3});
  for (int x = 0; x < count; ++x) {
    const float value = values[static_cast<std::size_t>(x)];
    picture(x, 0) = {value, 0.5F, 0.25F};
    picture(x, 1) = {0.5F, value, 1.0F};
    picture(x, 2) = {value, 0.0F, value};
  }
  const Image<Lab> lab = toLab(picture);
  for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
    const Lab expected = toLab(picture.data()[i]);
    ASSERT_EQ(std::memcmp(&lab.data()[i], &expected, sizeof expected), 0) << i;
  }
}

TEST(ToByte, RoundsToTheNearestAndClips) {
  EXPECT_EQ(toByte(-0.1F), 0);
  EXPECT_EQ(toByte(0.49F / 255.0F), 0);
  EXPECT_EQ(toByte(0.51F / 255.0F), 1);
  EXPECT_EQ(toByte(1.0F), 255);
  EXPECT_EQ(toByte(1.7F), 255);
}

}  // namespace
}  // namespace fluidymation
