#include "pipeline/painted_pixels.h"

#include <cassert>
#include <cstdint>

#include "compositing/color_margin.h"
#include "compositing/over.h"
#include "fluidymation/core/box.h"
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

constexpr std::uint8_t kOpaque8 = 255;

[[nodiscard]] Rgba8 opaque8(Rgb color) {
  return {toByte(color.r), toByte(color.g), toByte(color.b), kOpaque8};
}

[[nodiscard]] Rgba16 opaque16(Rgb color) {
  return {to16Bits(color.r), to16Bits(color.g), to16Bits(color.b), to16Bits(1.0F)};
}

/// With colours past the paint's edge.
template <typename Color>
[[nodiscard]] Image<Color> spread(const Image<Color>& pixels, const FramePart& part) {
  Image<Color> output = recropped(pixels, part.box, withColorMargin(part).box);
  spreadColors(output);
  return output;
}

/// The bare background with `pixel(x, y, alpha, background)` in the part's pixels that the shape
/// covers by `alpha`.
template <typename Color, typename Make>
[[nodiscard]] Image<Color> paintedOver(const PaintedPart& painted, const Image<Rgb>& background,
                                       const Image<Color>& bare, const Make& pixel) {
  assert(background.size() == painted.part.frame && bare.size() == painted.part.frame);
  Image<Color> output = bare.clone();
  const Box& box = painted.part.box;
  forEachRow(box.size().height, [&](int y) {
    for (int x = 0; x < box.size().width; ++x) {
      const float alpha = painted.guides.coverageAt(x, y);
      if (alpha <= 0.0F) continue;
      output(box.beginX + x, box.beginY + y) =
          pixel(x, y, alpha, background(box.beginX + x, box.beginY + y));
    }
  });
  return output;
}

/// Of a painted colour, sRGB-encoded and not rounded.
[[nodiscard]] Rgb over(Lab painted, float alpha, Rgb background) {
  const Rgb color = toRgb(painted);
  return composited(Rgba{color.r, color.g, color.b, alpha}, background);
}

}  // namespace

FramePart withColorMargin(const FramePart& part) {
  return {part.frame, grown(part.box, kColorMarginPx, part.frame)};
}

Image<Rgba8> straightPixels8(const PaintedPart& painted, const SrgbByteEncoder& encoder) {
  const auto pixel = [&](int x, int y) {
    const std::uint8_t alpha = toByte(painted.guides.coverageAt(x, y));
    if (alpha == 0) return Rgba8{};
    const Rgb8 color = encoder(painted.picture(x, y));
    return Rgba8{color.r, color.g, color.b, alpha};
  };
  return spread(madeOf<Rgba8>(painted.picture.size(), pixel), painted.part);
}

Image<Rgba16> straightPixels16(const PaintedPart& painted) {
  const auto pixel = [&](int x, int y) {
    const std::uint16_t alpha = to16Bits(painted.guides.coverageAt(x, y));
    if (alpha == 0) return Rgba16{};
    const Rgb color = toRgb(painted.picture(x, y));
    return Rgba16{to16Bits(color.r), to16Bits(color.g), to16Bits(color.b), alpha};
  };
  return spread(madeOf<Rgba16>(painted.picture.size(), pixel), painted.part);
}

Image<Rgba8> barePixels8(const Image<Rgb>& background) {
  return madeOf<Rgba8>(background.size(), [&](int x, int y) { return opaque8(background(x, y)); });
}

Image<Rgba16> barePixels16(const Image<Rgb>& background) {
  return madeOf<Rgba16>(background.size(),
                        [&](int x, int y) { return opaque16(background(x, y)); });
}

Image<Rgba8> opaquePixels8(const PaintedPart& painted, const Image<Rgb>& background,
                           const Image<Rgba8>& bare, const SrgbByteEncoder& encoder) {
  const auto pixel = [&](int x, int y, float alpha, Rgb behind) {
    if (alpha < 1.0F) return opaque8(over(painted.picture(x, y), alpha, behind));
    const Rgb8 color = encoder(painted.picture(x, y));
    return Rgba8{color.r, color.g, color.b, kOpaque8};
  };
  return paintedOver(painted, background, bare, pixel);
}

Image<Rgba16> opaquePixels16(const PaintedPart& painted, const Image<Rgb>& background,
                             const Image<Rgba16>& bare) {
  const auto pixel = [&](int x, int y, float alpha, Rgb behind) {
    return opaque16(over(painted.picture(x, y), alpha, behind));
  };
  return paintedOver(painted, background, bare, pixel);
}

}  // namespace fluidymation
