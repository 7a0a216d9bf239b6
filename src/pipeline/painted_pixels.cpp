#include "pipeline/painted_pixels.h"

#include <cassert>
#include <cstdint>

#include "compositing/color_margin.h"
#include "compositing/over.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Calls `pixel(x, y)` for all pixels of an image, rows side by side.
template <typename Color, typename Make>
[[nodiscard]] Image<Color> madeOf(Size size, const Make& pixel) {
  Image<Color> output(size);
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) output(x, y) = pixel(x, y);
  });
  return output;
}

/// Of pixel (x, y), sRGB-encoded and not rounded.
[[nodiscard]] Rgb over(const Image<Lab>& picture, float alpha, const Image<Rgb>& background, int x,
                       int y) {
  if (alpha <= 0.0F) return background(x, y);
  const Rgb color = toRgb(picture(x, y));
  return composited(Rgba{color.r, color.g, color.b, alpha}, background(x, y));
}

}  // namespace

Image<Rgba8> straightPixels8(const Image<Lab>& picture, const GuideFrame& guides,
                             const SrgbByteEncoder& encoder) {
  Image<Rgba8> output = madeOf<Rgba8>(picture.size(), [&](int x, int y) {
    const std::uint8_t alpha = toByte(guides.coverageAt(x, y));
    if (alpha == 0) return Rgba8{};
    const Rgb8 color = encoder(picture(x, y));
    return Rgba8{color.r, color.g, color.b, alpha};
  });
  spreadColors(output);
  return output;
}

Image<Rgba16> straightPixels16(const Image<Lab>& picture, const GuideFrame& guides) {
  Image<Rgba16> output = madeOf<Rgba16>(picture.size(), [&](int x, int y) {
    const std::uint16_t alpha = to16Bits(guides.coverageAt(x, y));
    if (alpha == 0) return Rgba16{};
    const Rgb color = toRgb(picture(x, y));
    return Rgba16{to16Bits(color.r), to16Bits(color.g), to16Bits(color.b), alpha};
  });
  spreadColors(output);
  return output;
}

Image<Rgba8> opaquePixels8(const Image<Lab>& picture, const GuideFrame& guides,
                           const Image<Rgb>& background, const SrgbByteEncoder& encoder) {
  assert(background.size() == picture.size());
  return madeOf<Rgba8>(picture.size(), [&](int x, int y) {
    constexpr std::uint8_t kOpaque = 255;
    const float alpha = guides.coverageAt(x, y);
    if (alpha >= 1.0F) {
      const Rgb8 color = encoder(picture(x, y));
      return Rgba8{color.r, color.g, color.b, kOpaque};
    }
    const Rgb color = over(picture, alpha, background, x, y);
    return Rgba8{toByte(color.r), toByte(color.g), toByte(color.b), kOpaque};
  });
}

Image<Rgba16> opaquePixels16(const Image<Lab>& picture, const GuideFrame& guides,
                             const Image<Rgb>& background) {
  assert(background.size() == picture.size());
  return madeOf<Rgba16>(picture.size(), [&](int x, int y) {
    const Rgb color = over(picture, guides.coverageAt(x, y), background, x, y);
    return Rgba16{to16Bits(color.r), to16Bits(color.g), to16Bits(color.b), to16Bits(1.0F)};
  });
}

}  // namespace fluidymation
