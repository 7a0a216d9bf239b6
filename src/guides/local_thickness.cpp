#include "fluidymation/guides/local_thickness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/distance_field.h"

namespace fluidymation {
namespace {

constexpr float kDiagonalPx = 1.4142136F;
/// Rows that are covered with discs at a time.
constexpr int kBandRows = 32;
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

/// A disc within a shape, round a pixel.
struct Disc {
  int x = 0;
  int y = 0;
  float radius = 0.0F;  ///< px
};

/// Raises `thickness` to a disc's radius on the inside pixels nearer to its centre than that, in
/// the rows [top, bottom).
void coverDisc(const Image<float>& distance, const Disc& disc, int top, int bottom,
               Image<float>& thickness) {
  const int reach = static_cast<int>(disc.radius);
  const int firstX = std::max(disc.x - reach, 0);
  const int lastX = std::min(disc.x + reach, distance.width() - 1);
  for (int y = std::max(disc.y - reach, top); y <= std::min(disc.y + reach, bottom - 1); ++y) {
    for (int x = firstX; x <= lastX; ++x) {
      const int dx = x - disc.x;
      const int dy = y - disc.y;
      const auto square = static_cast<float>(dx * dx + dy * dy);
      if (square >= disc.radius * disc.radius || distance(x, y) <= 0.0F) continue;
      thickness(x, y) = std::max(thickness(x, y), disc.radius);
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
  forEachRow(distance.height(), [&](int y) {
    for (int x = 0; x < distance.width(); ++x) {
      if (distance(x, y) <= 0.0F) continue;
      thickness(x, y) = thick(x, y) != 0 ? limitPx : std::min(distance(x, y), limitPx);
    }
  });
  // Thin parts disc by disc, as far as discs reach them
  const Mask thin = thinPixels(distance, thick);
  if (countInside(thin) == 0) return thickness;
  const Image<float> toThin = distanceWithin(thin, static_cast<int>(std::ceil(limitPx)));
  std::vector<std::vector<Disc>> discs(static_cast<std::size_t>(distance.height()));  // of rows
  forEachRow(distance.height(), [&](int y) {
    for (int x = 0; x < distance.width(); ++x) {
      const float depth = distance(x, y);
      if (depth <= 0.0F || depth >= limitPx || toThin(x, y) >= depth) continue;
      if (!isCovered(distance, x, y)) discs[static_cast<std::size_t>(y)].push_back({x, y, depth});
    }
  });
  const int bands = (distance.height() + kBandRows - 1) / kBandRows;
  parallelFor(bands, 1, [&](int band) {
    const int top = band * kBandRows;
    const int bottom = std::min(top + kBandRows, distance.height());
    const int reach = static_cast<int>(limitPx);  // of the largest disc
    const int end = std::min(bottom + reach, distance.height());
    for (int y = std::max(top - reach, 0); y < end; ++y) {
      for (const Disc& disc : discs[static_cast<std::size_t>(y)]) {
        coverDisc(distance, disc, top, bottom, thickness);
      }
    }
  });
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
