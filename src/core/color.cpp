#include "fluidymation/core/color.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

// CIE 15: f(t) is the cube root above (6/29)^3 and its tangent there below.
constexpr float kLabEpsilon = 216.0F / 24389.0F;
constexpr float kLabKappa = 24389.0F / 27.0F;

// Row sums of the sRGB matrix below (IEC 61966-2-1): the XYZ of RGB (1, 1, 1), which is D65.
constexpr float kWhiteX = 0.4124F + 0.3576F + 0.1805F;
constexpr float kWhiteY = 0.2126F + 0.7152F + 0.0722F;
constexpr float kWhiteZ = 0.0193F + 0.1192F + 0.9505F;

float labForward(float t) {
  return t > kLabEpsilon ? std::cbrt(t) : (kLabKappa * t + 16.0F) / 116.0F;
}

float labInverse(float f) {
  const float cube = f * f * f;
  return cube > kLabEpsilon ? cube : (116.0F * f - 16.0F) / kLabKappa;
}

/// Linear channels, not clipped to the gamut.
Rgb linearRgb(Lab color) {
  const float fy = (color.l + 16.0F) / 116.0F;
  const float x = kWhiteX * labInverse(fy + color.a / 500.0F);
  const float y = kWhiteY * labInverse(fy);
  const float z = kWhiteZ * labInverse(fy - color.b / 200.0F);
  // The inverse of the matrix in `labOfLinear`.
  return {3.2406255F * x - 1.5372080F * y - 0.4986286F * z,
          -0.9689307F * x + 1.8757561F * y + 0.0415175F * z,
          0.0557101F * x - 0.2040211F * y + 1.0569959F * z};
}

Lab labOfLinear(Rgb linear) {
  const auto [r, g, b] = linear;
  const float fx = labForward((0.4124F * r + 0.3576F * g + 0.1805F * b) / kWhiteX);
  const float fy = labForward((0.2126F * r + 0.7152F * g + 0.0722F * b) / kWhiteY);
  const float fz = labForward((0.0193F * r + 0.1192F * g + 0.9505F * b) / kWhiteZ);
  return {116.0F * fy - 16.0F, 500.0F * (fx - fy), 200.0F * (fy - fz)};
}

/// `srgbDecode`, looked up for the 256 values that an 8-bit picture can hold.
class SrgbDecoder {
 public:
  SrgbDecoder() {
    for (std::size_t i = 0; i < encoded_.size(); ++i) {
      encoded_[i] = static_cast<float>(i) / 255.0F;
      linear_[i] = srgbDecode(encoded_[i]);
    }
  }

  [[nodiscard]] float operator()(float encoded) const {
    // NaN and what is out of range fail the comparison, wherever they are looked for.
    const float level = std::clamp(encoded, 0.0F, 1.0F) * 255.0F + 0.5F;
    const std::size_t nearest = level >= 0.0F ? static_cast<std::size_t>(level) : 0;
    return encoded_[nearest] == encoded ? linear_[nearest] : srgbDecode(encoded);
  }

 private:
  std::array<float, 256> encoded_{};
  std::array<float, 256> linear_{};
};

std::uint32_t bitsOf(float value) {
  static_assert(sizeof(float) == sizeof(std::uint32_t));
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

float floatOf(std::uint32_t bits) {
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// Intervals of linear values that share their exponent and the upper 7 bits of their mantissa: 128
// an octave, and 67 bytes begin in the fullest octave, [0.5, 1]. None holds two beginnings.
constexpr std::uint32_t kIntervalShift = 16;

[[nodiscard]] int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

float srgbDecode(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

float srgbEncode(float linear) {
  return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

std::string colorText(Rgb8 color) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {color.r, color.g, color.b}) {
    text += kDigits[channel / 16];
    text += kDigits[channel % 16];
  }
  return text;
}

std::optional<Rgb> colorOf(const std::string& text) {
  constexpr float kMiddle = 0.5F;
  if (text == "white") return Rgb{1.0F, 1.0F, 1.0F};
  if (text == "black") return Rgb{};
  if (text == "gray") return Rgb{kMiddle, kMiddle, kMiddle};
  if ((text.size() != 4 && text.size() != 7) || text[0] != '#') return std::nullopt;
  const std::size_t digits = (text.size() - 1) / 3;
  std::array<float, 3> channels{};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const int high = hexDigit(text[1 + c * digits]);
    const int low = hexDigit(text[1 + c * digits + digits - 1]);
    if (high < 0 || low < 0) return std::nullopt;
    constexpr float kWhite = 255.0F;
    channels[c] = static_cast<float>(16 * high + low) / kWhite;
  }
  return Rgb{channels[0], channels[1], channels[2]};
}

Lab toLab(Rgb color) {
  return labOfLinear({srgbDecode(color.r), srgbDecode(color.g), srgbDecode(color.b)});
}

Lab toLab(Rgb8 color) {
  constexpr float kWhite = 255.0F;
  const auto channel = [](std::uint8_t byte) { return static_cast<float>(byte) / kWhite; };
  return toLab(Rgb{channel(color.r), channel(color.g), channel(color.b)});
}

Rgb toRgb(Lab color) {
  const auto channel = [](float linear) { return srgbEncode(std::clamp(linear, 0.0F, 1.0F)); };
  const Rgb linear = linearRgb(color);
  return {channel(linear.r), channel(linear.g), channel(linear.b)};
}

bool isInGamut(Lab color) {
  constexpr float kRounding =
      1e-4F;  // of linear light; a third of a byte's step where it is finest
  const Rgb linear = linearRgb(color);
  const auto fits = [](float c) { return c >= -kRounding && c <= 1.0F + kRounding; };
  return fits(linear.r) && fits(linear.g) && fits(linear.b);
}

Image<Lab> toLab(const Image<Rgb>& image) {
  const SrgbDecoder decoded;
  Image<Lab> lab(image.size());
  forEachRow(image.height(), [&](int y) {
    std::transform(image.row(y), image.row(y) + image.width(), lab.row(y), [&](Rgb color) {
      return labOfLinear({decoded(color.r), decoded(color.g), decoded(color.b)});
    });
  });
  return lab;
}

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

std::uint16_t to16Bits(float value) {
  constexpr float kMost = 65535.0F;
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * kMost));
}

SrgbByteEncoder::SrgbByteEncoder() {
  leastLinear_.back() = std::numeric_limits<float>::infinity();
  // Floats from 0 up are ordered as their bits are.
  std::uint32_t below = bitsOf(0.0F);
  for (int byte = 1; byte <= 255; ++byte) {
    std::uint32_t reached = bitsOf(1.0F);
    while (reached - below > 1) {
      const std::uint32_t middle = below + (reached - below) / 2;
      (toByte(srgbEncode(floatOf(middle))) < byte ? below : reached) = middle;
    }
    leastLinear_[static_cast<std::size_t>(byte)] = floatOf(reached);
  }
  firstInterval_ = bitsOf(leastLinear_[1]) >> kIntervalShift;
  const std::uint32_t end = (bitsOf(1.0F) >> kIntervalShift) + 1;
  std::uint8_t byte = 0;
  for (std::uint32_t interval = firstInterval_; interval < end; ++interval) {
    const float low = floatOf(interval << kIntervalShift);
    while (leastLinear_[byte + std::size_t{1}] <= low) ++byte;
    byteAt_.push_back(byte);
    assert(byte >= 254 || bitsOf(leastLinear_[byte + std::size_t{2}]) >> kIntervalShift > interval);
  }
}

std::uint8_t SrgbByteEncoder::byte(float linear) const {
  if (!(linear >= leastLinear_[1])) return 0;
  const float clipped = std::min(linear, 1.0F);
  const std::uint8_t byte = byteAt_[(bitsOf(clipped) >> kIntervalShift) - firstInterval_];
  return static_cast<std::uint8_t>(byte + (clipped >= leastLinear_[byte + std::size_t{1}] ? 1 : 0));
}

Rgb8 SrgbByteEncoder::operator()(Lab color) const {
  const Rgb linear = linearRgb(color);
  return {byte(linear.r), byte(linear.g), byte(linear.b)};
}

}  // namespace fluidymation
