#include "fluidymation/core/color.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

float srgbDecode(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

float srgbEncode(float linear) {
  return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

Lab toLab(Rgb color) {
  const float r = srgbDecode(color.r);
  const float g = srgbDecode(color.g);
  const float b = srgbDecode(color.b);
  const float fx = labForward((0.4124F * r + 0.3576F * g + 0.1805F * b) / kWhiteX);
  const float fy = labForward((0.2126F * r + 0.7152F * g + 0.0722F * b) / kWhiteY);
  const float fz = labForward((0.0193F * r + 0.1192F * g + 0.9505F * b) / kWhiteZ);
  return {116.0F * fy - 16.0F, 500.0F * (fx - fy), 200.0F * (fy - fz)};
}

Rgb toRgb(Lab color) {
  const float fy = (color.l + 16.0F) / 116.0F;
  const float x = kWhiteX * labInverse(fy + color.a / 500.0F);
  const float y = kWhiteY * labInverse(fy);
  const float z = kWhiteZ * labInverse(fy - color.b / 200.0F);
  const auto channel = [](float linear) { return srgbEncode(std::clamp(linear, 0.0F, 1.0F)); };
  // The inverse of the matrix above.
  return {channel(3.2406255F * x - 1.5372080F * y - 0.4986286F * z),
          channel(-0.9689307F * x + 1.8757561F * y + 0.0415175F * z),
          channel(0.0557101F * x - 0.2040211F * y + 1.0569959F * z)};
}

Image<Lab> toLab(const Image<Rgb>& image) {
  Image<Lab> lab(image.size());
  forEachRow(image.height(), [&](int y) {
    std::transform(image.row(y), image.row(y) + image.width(), lab.row(y),
                   [](Rgb color) { return toLab(color); });
  });
  return lab;
}

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

}  // namespace fluidymation
