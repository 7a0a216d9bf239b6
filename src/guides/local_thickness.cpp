#include "fluidymation/guides/local_thickness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fluidymation/core/box.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/distance_field.h"

namespace fluidymation {
namespace {

constexpr float kDiagonalPx = 1.4142136F;
constexpr float kRounding = 1e-3F;  // px; distances of 1e4 px are exact to this in float

/// Whether the disc round a neighbour holds the whole disc round (x, y).
bool isCovered(const Image<float>& distance, int x, int y) {
  const float depth = distance(x, y);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if ((dx == 0 && dy == 0) || !distance.contains(x + dx, y + dy)) continue;
      const float stepPx = dx != 0 && dy != 0 ? kDiagonalPx : 1.0F;
      if (distance(x + dx, y + dy) >= depth + stepPx - kRounding) return true;
    }
  }
  return false;
}

/// Raises `thickness` to `radius` on the inside pixels nearer to (x, y) than that.
void coverDisc(const Image<float>& distance, int x, int y, float radius, Image<float>& thickness) {
  const int reach = static_cast<int>(radius);
  const int firstX = std::max(x - reach, 0);
  const int lastX = std::min(x + reach, distance.width() - 1);
  for (int py = std::max(y - reach, 0); py <= std::min(y + reach, distance.height() - 1); ++py) {
    for (int px = firstX; px <= lastX; ++px) {
      const auto square = static_cast<float>((px - x) * (px - x) + (py - y) * (py - y));
      if (square >= radius * radius || distance(px, py) <= 0.0F) continue;
      thickness(px, py) = std::max(thickness(px, py), radius);
    }
  }
}

/// 1 where a pixel of depth `limitPx` or more is nearer than `limitPx`.
Mask nearDeepPixels(const Image<float>& distance, float limitPx) {
  Mask deep(distance.size());
  std::transform(distance.begin(), distance.end(), deep.begin(),
                 [limitPx](float d) { return static_cast<std::uint8_t>(d >= limitPx ? 1 : 0); });
  Mask near(distance.size());
  if (countInside(deep) == 0) return near;
  const Image<float> toDeep = distanceWithin(deep, static_cast<int>(std::ceil(limitPx)));
  std::transform(toDeep.begin(), toDeep.end(), near.begin(),
                 [limitPx](float d) { return static_cast<std::uint8_t>(d < limitPx ? 1 : 0); });
  return near;
}

/// Pixels inside that are not `thick`.
Mask thinPixels(const Image<float>& distance, const Mask& thick) {
  Mask thin(distance.size());
  std::transform(distance.begin(), distance.end(), thick.begin(), thin.begin(),
                 [](float d, std::uint8_t isThick) {
                   return static_cast<std::uint8_t>(d > 0.0F && isThick == 0 ? 1 : 0);
                 });
  return thin;
}

}  // namespace

Image<float> localThickness(const Image<float>& distance, float limitPx) {
  // Thick parts at once, by the distance to their deep pixels
  const Mask thick = nearDeepPixels(distance, limitPx);
  Image<float> thickness(distance.size());
  for (int y = 0; y < distance.height(); ++y) {
    for (int x = 0; x < distance.width(); ++x) {
      if (distance(x, y) <= 0.0F) continue;
      thickness(x, y) = thick(x, y) != 0 ? limitPx : std::min(distance(x, y), limitPx);
    }
  }
  // Thin parts disc by disc, as far as discs reach them
  const Mask thin = thinPixels(distance, thick);
  if (countInside(thin) == 0) return thickness;
  const Image<float> toThin = distanceWithin(thin, static_cast<int>(std::ceil(limitPx)));
  for (int y = 0; y < distance.height(); ++y) {
    for (int x = 0; x < distance.width(); ++x) {
      const float depth = distance(x, y);
      if (depth <= 0.0F || depth >= limitPx || toThin(x, y) >= depth) continue;
      if (!isCovered(distance, x, y)) coverDisc(distance, x, y, depth, thickness);
    }
  }
  return thickness;
}

Image<float> stretchedDistance(const Image<float>& distance, float borderWidthPx) {
  Image<float> stretched = distance.clone();
  // All that thickness depends on
  const Box box = boundingBox(distance, [](float d) { return d > 0.0F; });
  const Image<float> thickness = localThickness(cropped(distance, box), borderWidthPx);
  forEachRow(thickness.height(), [&](int y) {
    float* out = stretched.row(box.beginY + y) + box.beginX;
    for (int x = 0; x < thickness.width(); ++x) {
      const float thin = thickness(x, y);
      if (thin > 0.0F && thin < borderWidthPx) out[x] *= borderWidthPx / thin;
    }
  });
  return stretched;
}

}  // namespace fluidymation
