#include "support/synthetic_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fluidymation/core/random.h"
#include "fluidymation/guides/mask.h"

namespace fluidymation::test {

GuideFrame GrowingDisc::guides(int frame) const {
  GuideFrame guides{Mask(size),        Image<float>(size), Image<Vec2>(size), Image<Vec2>(size),
                    Image<Vec2>(size), Image<Vec2>(size),  SolveReport{},     {}};
  const float radius = radiusPx(frame);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Vec2 away{static_cast<float>(x) - centre.x, static_cast<float>(y) - centre.y};
      const float rho = length(away);
      const bool inside = rho < radius;
      guides.distance(x, y) = inside ? std::max(radius - rho, 1.0F) : std::min(radius - rho, -1.0F);
      if (!inside) continue;
      const Vec2 outward = rho > 0.0F ? (1.0F / rho) * away : Vec2{1.0F, 0.0F};
      guides.mask(x, y) = 1;
      guides.flow(x, y) = speedPx * outward;
      guides.direction(x, y) = outward;
      const float past = std::min(radius - rho, radius - startRadiusPx);
      guides.accForward(x, y) = std::max(past, 0.0F) * outward;
      guides.accBackward(x, y) = (radiusPx(frameCount - 1) - radius) * outward;
    }
  }
  return guides;
}

Image<Lab> randomTexture(Size size, std::uint64_t seed) {
  constexpr int kCellPx = 3;
  Image<Lab> texture(size);
  const auto noise = [seed](int cx, int cy, int channel) {
    Random random({seed, channel, 0, 0, cx, cy});
    return static_cast<float>(random.uniform(0, 1000)) / 1000.0F;
  };
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int cx = x / kCellPx;
      const int cy = y / kCellPx;
      const float fx = static_cast<float>(x % kCellPx) / kCellPx;
      const float fy = static_cast<float>(y % kCellPx) / kCellPx;
      const auto value = [&](int channel) {
        return (1.0F - fy) *
                   ((1.0F - fx) * noise(cx, cy, channel) + fx * noise(cx + 1, cy, channel)) +
               fy *
                   ((1.0F - fx) * noise(cx, cy + 1, channel) + fx * noise(cx + 1, cy + 1, channel));
      };
      texture(x, y) = {30.0F + 40.0F * value(0), 30.0F * (value(1) - 0.5F),
                       30.0F * (value(2) - 0.5F)};
    }
  }
  return texture;
}

Image<Lab> paintedDisc(const GrowingDisc& disc, int frame, std::uint64_t seed) {
  constexpr float kRimPx = 4.0F;
  constexpr float kRimDarkening = 25.0F;
  Image<Lab> picture = randomTexture(disc.size, seed);
  const GuideFrame guides = disc.guides(frame);
  for (int y = 0; y < disc.size.height; ++y) {
    for (int x = 0; x < disc.size.width; ++x) {
      const float distance = guides.distance(x, y);
      if (distance < 0.0F) {
        picture(x, y) = {95.0F, 0.0F, 5.0F};
      } else {
        picture(x, y).l -= kRimDarkening * std::max(0.0F, 1.0F - distance / kRimPx);
      }
    }
  }
  return picture;
}

Image<FixedLab> fixedPicture(const Image<Lab>& color, const Image<Segment>& segment) {
  Image<FixedLab> picture(color.size());
  for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
    if (segment.data()[i] == Segment::kOutside) continue;
    picture.data()[i] = FixedLab::of(color.data()[i]);
  }
  return picture;
}

Exemplar discExemplar(const GrowingDisc& disc, int coarsest, float borderWidthPx,
                      std::uint64_t seed, const ShapeRules& rules) {
  return heldDiscExemplar(disc, 0, disc.frameCount, coarsest, borderWidthPx, seed, rules);
}

Exemplar heldDiscExemplar(const GrowingDisc& disc, int begin, int held, int coarsest,
                          float borderWidthPx, std::uint64_t seed, const ShapeRules& rules) {
  Exemplar exemplar(disc.size, held, coarsest, borderWidthPx, rules);
  exemplar.advance(begin);
  for (int k = begin; k < begin + held; ++k) fillFrame(disc, k, seed, exemplar);
  exemplar.finish();
  return exemplar;
}

void fillFrame(const GrowingDisc& disc, int frame, std::uint64_t seed, Exemplar& exemplar) {
  const int k = frame - exemplar.firstFrame();
  exemplar.setColor(k, paintedDisc(disc, frame, seed));
  GuideFrame guides = disc.guides(frame);
  guides.shape = blurredMask(guides.mask, exemplar.level(0).borderWidthPx());
  exemplar.setGuides(k, guides);
}

}  // namespace fluidymation::test
